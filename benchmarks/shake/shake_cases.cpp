#include "benchmarks/shake/shake_cases.h"

#include <algorithm>
#include <filesystem>

#include "benchmarks/shake/on_table.h"
#include "planner/plan/plan.h"
#include "planner/plan/plan_options.h"
#include "sim/scene/make_scene.h"
#include "sim/scene/scene_file.h"
#include "sim/shape/object_generator.h"

namespace prehend::bench {
namespace {

constexpr int kTriangles = 3000;

Scene scene_of(const std::string& name, const std::string& hand) {
  const std::vector<std::string> generated = generated_object_names();
  if (std::find(generated.begin(), generated.end(), name) != generated.end()) {
    return make_scene(make_graspable(name, generate_object(name, kTriangles), Material::plastic),
                      hand.empty() ? "barrett" : hand);
  }
  SceneSource source;
  source.hand = hand;
  return load_scene(name, source);
}

}  // namespace

ShakeCase shake_case(const std::string& name, int trials, int most, bool on_support) {
  const std::size_t colon = name.find(':');
  const std::string hand = colon == std::string::npos ? "" : name.substr(colon + 1);
  const bool is_file = name.find('/') != std::string::npos;
  std::string title = is_file ? std::filesystem::path(name.substr(0, colon)).stem().string() : name;
  if (is_file && !hand.empty()) title += ":" + hand;
  Scene scene = scene_of(name.substr(0, colon), hand);
  if (on_support && scene.obstacles.empty()) put_on_table(scene);
  return shake_case(title, std::move(scene), trials, most);
}

ShakeCase shake_case(const std::string& name, Scene scene, int trials, int most) {
  ShakeCase shaken;
  shaken.name = name;
  shaken.scene = compile(std::move(scene));
  PlanOptions options;
  options.search.trials = trials;
  options.rank.top = most;
  options.volumes = false;
  for (ScoredGrasp& grasp : plan(shaken.scene, options).grasps) {
    const int rank = static_cast<int>(shaken.grasps.size()) + 1;
    shaken.grasps.push_back({std::move(grasp), rank});
  }
  shaken.shapes = mjcf_shapes(shaken.scene);
  return shaken;
}

std::vector<ShakeTestResult> failed_tests(const ShakeResult& result) {
  std::vector<ShakeTestResult> failed;
  if (!result.prepare.survived()) failed.push_back(result.prepare);
  for (const ShakeTestResult& test : result.tests) {
    if (!test.survived()) failed.push_back(test);
  }
  return failed;
}

}  // namespace prehend::bench
