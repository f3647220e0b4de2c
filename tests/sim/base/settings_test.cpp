// Settings: what is declared once is checked, named and visited.
#include "sim/base/settings.h"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/base/named_enum.h"
#include "sim/base/range.h"
#include "sim/base/require_settings.h"

namespace prehend {
namespace {

enum class Gait { walk, trot };
constexpr auto enum_names(Gait /*of*/) { return std::to_array<std::string_view>({"walk", "trot"}); }

struct HoofOptions {
  static constexpr AboutSettings kAbout{"HoofOptions", "How a hoof is set down."};
  double gap = 1.0;
  double limit = 2.0;
};

template <SettingsOf<HoofOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [gap, limit] = options;
  visit("gap", gap, kAbove0, "m", "Above the ground.");
  visit.relation("gap", gap <= limit, "must be at most the limit");
  visit("limit", limit, Range{.with_infinity = true}, "m", "Of the gap.");
}

struct HorseOptions {
  static constexpr AboutSettings kAbout{"HorseOptions", "How a horse goes."};
  int legs = 4;
  Gait gait = Gait::walk;
  HoofOptions front = {};
  HoofOptions rear = {};
  std::optional<HoofOptions> spare = {};
  int seed = 1;
};

template <SettingsOf<HorseOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [legs, gait, front, rear, spare, seed] = options;
  visit({"legs", "leg_count"}, legs, Range{1.0, 8.0}, "", "That it stands on.");
  visit("gait", gait, "In which order they move.");
  visit({"front", ""}, front, "Of the front legs.");
  visit("rear", rear, "Of the rear legs.");
  visit.unlisted("spare", spare, "Of a fifth leg.");
  visit.unlisted("seed", seed, kAtLeast0, "", "Of the first step.");
}

std::string refusal(const HorseOptions& options) {
  try {
    require_settings(options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Settings, DefaultsAreAccepted) {
  EXPECT_EQ(refusal({}), "");
  EXPECT_EQ(refusal({.spare = HoofOptions{}}), "");
}

TEST(Settings, ARefusalNamesThePathTheRangeAndTheValue) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal({.legs = 9}), "legs: must be at least 1 and at most 8 (9)");
  EXPECT_EQ(refusal({.front = {.gap = 0.0}}), "front.gap: must be above 0 (0)");
  EXPECT_EQ(refusal({.rear = {.gap = nan}}), "rear.gap: must be above 0 (nan)");
  EXPECT_EQ(refusal({.rear = {.gap = infinity}}), "rear.gap: must be above 0 (inf)");
  EXPECT_EQ(refusal({.rear = {.limit = infinity}}), "");
  EXPECT_EQ(refusal({.spare = HoofOptions{.gap = -1.0}}), "spare.gap: must be above 0 (-1)");
  EXPECT_EQ(refusal({.seed = -1}), "seed: must be at least 0 (-1)");
}

TEST(Settings, TheFirstFaultIsNamed) {
  EXPECT_EQ(refusal({.legs = 0, .rear = {.gap = 0.0}}).rfind("legs: ", 0), 0U);
}

TEST(Settings, SettingsThatDoNotFitToEachOtherAreRefused) {
  EXPECT_EQ(refusal({.rear = {.gap = 3.0}}), "rear.gap: must be at most the limit");
  const auto fault = setting_fault(HorseOptions{.rear = {.gap = 3.0}});
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->in_files, "rear_gap");
  EXPECT_EQ(setting_fault(HorseOptions{.front = {.gap = 3.0}})->in_files, "gap");
}

TEST(Settings, FilesHaveTheListedOnesUnderOneNameEach) {
  HorseOptions options;
  std::vector<std::string> names;
  visit_settings(options,
                 [&](const std::string& name, auto&, const Setting&) { names.push_back(name); });
  EXPECT_EQ(names, (std::vector<std::string>{"leg_count", "gait", "gap", "limit", "rear_gap",
                                             "rear_limit"}));
}

TEST(Settings, AStructHasANameAndAMeaning) {
  EXPECT_EQ(HorseOptions::kAbout.name, "HorseOptions");
  EXPECT_EQ(HoofOptions::kAbout.meaning, "How a hoof is set down.");
  EXPECT_EQ(name_of(HorseOptions{}.gait), "walk");
}

TEST(Range, IsWrittenAsAnInterval) {
  EXPECT_EQ(kAnyNumber.interval(), "");
  EXPECT_EQ(kAbove0.interval(), "> 0");
  EXPECT_EQ(kAtLeast1.interval(), ">= 1");
  EXPECT_EQ(kFraction.interval(), "[0, 1]");
  EXPECT_EQ(kFractionAbove0.interval(), "(0, 1]");
}

}  // namespace
}  // namespace prehend
