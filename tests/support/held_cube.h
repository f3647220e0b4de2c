// A cube held between the plates of the parallel jaw: a simple grasp for tests of pictures and
// motions.
#pragma once

#include <utility>
#include <vector>

#include "planner/plan/path/grasp_motion.h"
#include "planner/show/grasp_picture.h"
#include "planner/show/posed_grasp.h"
#include "sim/trial/run_trial.h"
#include "tests/support/scenes.h"

namespace prehend::test {

inline constexpr double kCube = 0.05;  // edge of the cube [m]

// The jaw approaches along -z onto the cube, with its first preshape (open), and closes along x.
inline Candidate from_above() {
  Candidate candidate;
  Matrix3 down;
  down << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  candidate.X_OH = pose_from(down, Vector3(0, 0, 0.05));
  candidate.approach_O = -Vector3::UnitZ();
  candidate.approach_distance = 0.05;
  candidate.preshape = 0;
  return candidate;
}

// The compiled scene, the trial of from_above(), and the grasp as pictures take it.
struct HeldCube {
  CompiledScene scene;
  Trial trial;
  PosedGrasp grasp;
};

// The scene with the cube at the world's origin, and the trial of from_above() in it.
inline HeldCube held_cube(std::vector<StaticBody> obstacles = {}) {
  HeldCube held{
      compiled(find_robot("parallel_jaw"), make_box({kCube, kCube, kCube}), std::move(obstacles)),
      {},
      {}};
  held.trial = run_trial(held.scene, from_above());
  held.grasp = {held.trial.X_OH, held.trial.joints, held.trial.contacts, Wrench::Zero(), "cube"};
  return held;
}

// The approach and the closing, without an arm.
inline GraspMotion motion_of(const HeldCube& held) {
  return grasp_motion(held.scene, from_above(), held.trial, nullptr);
}

}  // namespace prehend::test
