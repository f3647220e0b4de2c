// A block on a table before an arm, and grasps of it from above.
#pragma once

#include <cmath>

#include <gtest/gtest.h>

#include "sim/geometry/basic_shapes.h"
#include "sim/trial/trial.h"
#include "tests/support/library_scenes.h"

namespace prehend::test {

// A block of 5 x 5 x 12 cm on the table of the library's scene, 58 cm in front of the arm.
inline Scene block_on_table() {
  Scene scene = load_scene(library_scene("mug_on_table"));
  scene.object = make_graspable("block", make_box({0.05, 0.05, 0.12}), Material::plastic);
  scene.object.X_WO = translation(Vector3(0.58, 0.05, 0.7801));
  return scene;
}

// From above onto the block's middle, the hand turned by `yaw`.
inline Candidate from_above(const Robot& robot, double yaw) {
  const Hand& hand = *robot.hand;
  Matrix3 hand_axes;
  hand_axes << hand.closing, hand.approach.cross(hand.closing), hand.approach;
  const Vector3 closing(std::cos(yaw), std::sin(yaw), 0.0);
  const Vector3 down = -Vector3::UnitZ();
  Matrix3 wanted;
  wanted << closing, down.cross(closing), down;
  const Matrix3 rotation = wanted * hand_axes.transpose();
  Candidate candidate;
  candidate.X_OH = pose_from(rotation, Vector3(0.0, 0.0, 0.06) - rotation * hand.origin);
  candidate.approach_O = down;
  candidate.approach_distance = 0.1;
  candidate.preshape = 0;
  return candidate;
}

struct Grasp {
  Candidate candidate;
  Trial trial;
};

// The first stable one of twelve turns of the hand.
inline Grasp stable_grasp(const CompiledScene& scene) {
  for (int i = 0; i < 12; ++i) {
    const Candidate candidate = from_above(scene.scene.hand, 0.5236 * i);
    const Trial trial = run_trial(scene, candidate);
    if (trial.outcome == Outcome::stable) return {candidate, trial};
  }
  ADD_FAILURE() << "no stable grasp from above";
  return {};
}

}  // namespace prehend::test
