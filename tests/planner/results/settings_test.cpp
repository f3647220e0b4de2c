// The settings of a run in its grasp file: every option of every struct, under one name.
#include <memory>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "planner/plan/learn/tree_model.h"
#include "planner/results/grasps_file.h"
#include "planner/results/json_settings.h"
#include "sim/base/visit_settings.h"
#include "sim/shape/basic_shapes.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

using nlohmann::json;

json settings_of(const PlanOptions& options) {
  static const CompiledScene kScene =
      test::compiled(find_robot("parallel_jaw"), make_box({0.02, 0.02, 0.02}));
  RunRecord record;
  record.options = options;
  return json::parse(grasps_json(kScene, {}, record))["settings"];
}

PlanOptions with_paths() {
  PlanOptions options;
  options.paths.emplace();
  return options;
}

// Another value of the same type.
template <typename Value>
Value changed(const Value& value) {
  if constexpr (std::is_same_v<Value, bool>) {
    return !value;
  } else if constexpr (std::is_enum_v<Value>) {
    return value == kAll<Value>.front() ? kAll<Value>.back() : kAll<Value>.front();
  } else {
    return value + 1;
  }
}

// Changes setting number `which` and says its name; "" where there are not so many.
template <typename Options>
std::string change(Options& options, int which) {
  std::string name;
  visit_settings(options, [&](const std::string& of, auto& value, const Setting&) {
    if (which-- == 0) {
      name = of;
      value = changed(value);
    }
  });
  return name;
}

// The names whose values differ.
std::set<std::string> differing(const json& a, const json& b) {
  std::set<std::string> names;
  for (const auto& [name, value] : a.items()) {
    if (!b.contains(name) || b[name] != value) names.insert(name);
  }
  for (const auto& [name, value] : b.items()) {
    if (!a.contains(name)) names.insert(name);
  }
  return names;
}

TEST(Settings, EveryOneIsInTheFileUnderItsOwnName) {
  const json before = settings_of(with_paths());
  std::set<std::string> names;
  for (int which = 0;; ++which) {
    PlanOptions options = with_paths();
    const std::string name = change(options, which);
    if (name.empty()) break;
    EXPECT_TRUE(names.insert(name).second) << name << " twice";
    EXPECT_EQ(differing(before, settings_of(options)), std::set<std::string>{name});
  }
  // Nothing else is there but the one that is written by hand.
  std::set<std::string> all = names;
  all.insert("paths");
  EXPECT_EQ(before.size(), all.size());
  EXPECT_GE(names.size(), 40U);
}

TEST(Settings, EveryOneOfThePathsIsInTheFileUnderItsOwnName) {
  const json before = settings_of(with_paths())["paths"];
  std::set<std::string> names;
  for (int which = 0;; ++which) {
    PlanOptions options = with_paths();
    const std::string name = change(*options.paths, which);
    if (name.empty()) break;
    EXPECT_TRUE(names.insert(name).second) << name << " twice";
    EXPECT_EQ(differing(before, settings_of(options)["paths"]), std::set<std::string>{name});
  }
  EXPECT_EQ(before.size(), names.size());
  EXPECT_GE(names.size(), 15U);
}

TEST(Settings, ALimitToTheApproachIsReadBack) {
  PlanOptions options;
  EXPECT_FALSE(settings_of(options).contains("approach"));
  options.candidates.approach = {.direction = {1.0, 0.0, -2.0}, .angle = 0.25};
  const json written = settings_of(options);
  EXPECT_EQ(written["approach"]["frame"], "world");
  RunRecord record;
  read_settings(JsonFile("settings.json", written.dump()).root(), record);
  ASSERT_TRUE(record.options.candidates.approach.has_value());
  EXPECT_EQ(record.options.candidates.approach->direction, Vector3(1.0, 0.0, -2.0));
  EXPECT_EQ(record.options.candidates.approach->angle, 0.25);
}

TEST(Settings, ThoseOfEarlierVersionsArePermitted) {
  const JsonFile file("settings.json", R"({"seed": 5, "max_candidates": 800, "places": 3,
      "gaps_near": 5e-4, "paths": {"longest_edge": 0.8}})");
  RunRecord record;
  read_settings(file.root(), record);
  EXPECT_EQ(record.options.seed, 5U);
}

TEST(Settings, AModelIsInTheFileByNameAndChecksum) {
  auto model = std::make_shared<TreeModel>();
  model->name = "mine";
  PlanOptions options;
  options.search.learned = LearnedOrder{};
  options.search.learned->model = model;
  const json learned = settings_of(options)["learned"];
  EXPECT_EQ(learned["model"], "mine");
  EXPECT_EQ(learned["choose_from"], options.search.learned->choose_from);
  EXPECT_EQ(learned["variety"], options.search.learned->variety);
  EXPECT_EQ(learned["unordered"], options.search.learned->unordered);
  EXPECT_EQ(learned["ordered_first"], options.search.learned->ordered_first);
  EXPECT_EQ(learned["unknown_hand_first"], options.search.learned->unknown_hand_first);
  const std::string before = learned["checksum"];
  EXPECT_EQ(before.size(), 16U);
  model->base = 1.0;
  EXPECT_NE(settings_of(options)["learned"]["checksum"], before);
  EXPECT_FALSE(settings_of({}).contains("learned"));
  // Reading does not stumble over it.
  const JsonFile file("settings.json", R"({"learned": {"model": "mine"}, "seed": 3})");
  RunRecord record;
  read_settings(file.root(), record);
  EXPECT_EQ(record.options.seed, 3U);
  EXPECT_FALSE(record.options.search.learned.has_value());
}

// Names that files of earlier versions have, which programs may read.
TEST(Settings, KnownNamesStay) {
  const json settings = settings_of(with_paths());
  for (const char* name : {"seed", "top", "cone_edges", "contacts", "contact_threshold",
                           "contact_gap", "back_off_step", "back_off_tries", "settle_angle",
                           "settle_steps", "primitive_tolerance", "max_primitives", "trials"}) {
    EXPECT_TRUE(settings.contains(name)) << name;
  }
  for (const char* name : {"planner", "max_iterations", "simplify_steps", "alternatives",
                           "line_step", "tightest", "sample_time"}) {
    EXPECT_TRUE(settings["paths"].contains(name)) << name;
  }
}

// Seeds derive from the one of the run: only that one is a setting.
TEST(Settings, ThereIsOneSeed) {
  const json settings = settings_of(with_paths());
  int seeds = 0;
  for (const json* group : {&settings, &settings["paths"]}) {
    for (const auto& [name, value] : group->items()) {
      seeds += name.find("seed") != std::string::npos ? 1 : 0;
    }
  }
  EXPECT_EQ(seeds, 1);
}

}  // namespace
}  // namespace prehend
