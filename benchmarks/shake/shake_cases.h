// Scenes with their best grasps, which protocols are carried out on.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/shake/shake_result.h"
#include "planner/plan/plan_result.h"
#include "planner/show/exports/mjcf.h"

namespace prehend::bench {

struct ShakenGrasp {
  ScoredGrasp grasp;
  int rank = 1;
};

struct ShakeCase {
  std::string name;
  CompiledScene scene;
  MjcfShapes shapes;  // the pieces that simulators of convex bodies need
  std::vector<ShakenGrasp> grasps;
};

// SCENE[:HAND]: a scene of the library, a scene or mesh file, or a generated object; with at most
// so many of the best grasps of a plan. `on_support`: an object without obstacles is put on a table
// first. Throws InputError.
ShakeCase shake_case(const std::string& name, int trials, int most, bool on_support = false);
ShakeCase shake_case(const std::string& name, Scene scene, int trials, int most);

// The tests that failed, of which the preparation is one.
std::vector<ShakeTestResult> failed_tests(const ShakeResult& result);

}  // namespace prehend::bench
