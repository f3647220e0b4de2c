// A block on a table in front of an arm (a Puma 560 with a Barrett hand), and grasps of it from
// above.
#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/scene/reach/reach.h"
#include "sim/shape/basic_shapes.h"
#include "sim/trial/approach_line.h"
#include "sim/trial/candidate.h"
#include "sim/trial/run_trial.h"
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

// The same block to the arm's right and without the table: the arm can follow the approach in two
// postures. Compiled once for the whole test program.
inline const CompiledScene& block_in_the_air() {
  static const CompiledScene kScene = [] {
    Scene scene = block_on_table();
    scene.obstacles.clear();
    scene.object.X_WO = translation(Vector3(0.58, -0.3, 0.7801));
    return compile(std::move(scene));
  }();
  return kScene;
}

// A candidate that approaches vertically from above, with the hand's origin on the centre of the
// block's upper face (z = 0.06 m in the object's frame); the closing axis is turned by `yaw` [rad]
// from the x axis. The rotation takes the hand's axes (closing, third, approach) to the
// wanted ones: R = wanted * hand_axes^T.
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

// A candidate and the trial of it.
struct Grasp {
  Candidate candidate;
  Trial trial;
};

// The first stable grasp of twelve yaw angles, 30 degrees apart. A test failure without one.
inline Grasp stable_grasp(const CompiledScene& scene) {
  for (int i = 0; i < 12; ++i) {
    const Candidate candidate = from_above(scene.scene.hand, 0.5236 * i);
    const Trial trial = run_trial(scene, candidate);
    if (trial.outcome == Outcome::stable) return {candidate, trial};
  }
  ADD_FAILURE() << "no stable grasp from above";
  return {};
}

// A stable grasp that the arm can reach in two postures. The trial has chosen the posture nearer to
// the start; here it is replaced by the farther one, to test that callers use the postures that the
// trial states and do not solve the inverse kinematics again.
inline Grasp grasp_in_the_farther_posture(const CompiledScene& scene) {
  constexpr int kTurns = 72;
  for (int i = 0; i < kTurns; ++i) {
    Grasp grasp{from_above(scene.scene.hand, 2.0 * std::numbers::pi * i / kTurns), {}};
    grasp.trial = run_trial(scene, grasp.candidate);
    if (grasp.trial.outcome != Outcome::stable) continue;
    const HandLine line = approach_line(scene, grasp.candidate, grasp.trial);
    std::vector<Reach> ways = find_reaches(*scene.arm, line, 2, {});
    if (ways.size() < 2) continue;
    grasp.trial.arm_line = std::move(ways[1].line);
    grasp.trial.arm_dofs = grasp.trial.arm_line.back();
    return grasp;
  }
  ADD_FAILURE() << "no grasp from above that is reached in two postures";
  return {};
}

}  // namespace prehend::test
