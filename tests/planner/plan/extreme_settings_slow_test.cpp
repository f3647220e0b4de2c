// Plans with each setting at the ends of its range.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "planner/plan/plan.h"
#include "sim/base/input_error.h"
#include "sim/base/visit_settings.h"
#include "sim/robot/files/robot_file.h"
#include "sim/scene/compiled_scene.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

struct NumberSetting {
  std::string name;
  Range range;
  bool counts = false;  // an integer
};

// All numbers of the options, in the order in which for_each_number visits them.
template <typename Options, typename Visit>
void for_each_number(Options& options, const std::string& prefix, const Visit& visit) {
  const auto leaf = [&](const Setting& setting, auto& value) {
    using Value = std::remove_cvref_t<decltype(value)>;
    const std::string name = prefix + std::string(setting.name.name);
    if constexpr (HasSettings<Value>) {
      for_each_number(value, name + ".", visit);
    } else if constexpr (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>) {
      visit(name, setting, value);
    }
  };
  for_each_setting(options, SettingVisitor(leaf));
}

std::vector<NumberSetting> number_settings() {
  std::vector<NumberSetting> all;
  PlanOptions options;
  for_each_number(options, "", [&](const std::string& name, const Setting& setting, auto& value) {
    all.push_back(
        {name, setting.range, std::is_integral_v<std::remove_reference_t<decltype(value)>>});
  });
  return all;
}

PlanOptions shortest_plan() {
  PlanOptions options;
  options.search.trials = 8;
  options.refine.trials = 4;
  options.uncertainty.samples = 2;
  options.free_closing = 0;
  options.volumes = false;
  return options;
}

PlanOptions with(const std::string& wanted, double number) {
  PlanOptions options = shortest_plan();
  options.robustness = wanted.starts_with("uncertainty");
  for_each_number(options, "",
                  [&](const std::string& name, const Setting& /*setting*/, auto& value) {
                    if (name == wanted)
                      value = static_cast<std::remove_reference_t<decltype(value)>>(number);
                  });
  return options;
}

TEST(ExtremeSettings, HaveBothEnds) {
  const std::vector<NumberSetting> all = number_settings();
  EXPECT_GT(all.size(), 70U);
  for (const NumberSetting& setting : all) {
    // A call from C++ says "all of them" by the largest number.
    if (setting.name.ends_with("seed") || setting.name == "sections") continue;
    EXPECT_TRUE(std::isfinite(setting.range.upper)) << setting.name;
    EXPECT_TRUE(std::isfinite(setting.range.lower)) << setting.name;
  }
}

// A count at its upper end only takes long.
TEST(ExtremeSettings, ArePlannedWithOrRefused) {
  Scene scene;
  scene.object = make_graspable("cube", make_box(Vector3::Constant(0.05), 1), Material::plastic);
  scene.hand = find_robot("parallel_jaw");
  const CompiledScene compiled = compile(std::move(scene));
  int planned = 0;
  for (const NumberSetting& setting : number_settings()) {
    const double tiny = setting.counts ? setting.range.lower : 1e-300;
    const double least = setting.range.without_lower ? tiny : setting.range.lower;
    std::vector<double> ends{least};
    if (!setting.counts && std::isfinite(setting.range.upper)) ends.push_back(setting.range.upper);
    for (const double end : ends) {
      SCOPED_TRACE(setting.name + " " + std::to_string(end));
      PlanOptions options = with(setting.name, end);
      try {
        const PlanResult result = plan(compiled, options);
        ++planned;
        for (const ScoredGrasp& grasp : result.grasps) {
          EXPECT_TRUE(std::isfinite(grasp.trial.epsilon.lower));
          EXPECT_TRUE(grasp.trial.X_OH.matrix().allFinite());
        }
      } catch (const InputError& error) {
        // Two settings have to fit to each other.
        EXPECT_FALSE(error.field().empty()) << error.what();
      }
    }
  }
  EXPECT_GT(planned, 90);
}

}  // namespace
}  // namespace prehend
