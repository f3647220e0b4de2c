// How an arm's motions are searched for and checked for collision.
#pragma once

#include "sim/base/settings.h"
#include "sim/robot/ik_options.h"

namespace prehend {

// How finely motions are checked for collision.
struct MotionCheckOptions {
  // A stretch of the motion on which the bodies of a pair move by no more than this relative to
  // each other is not divided further: a pair not yet proved free there counts as blocked. Motions
  // with gaps below about half of this may therefore be refused [m].
  double tightest = 2e-4;
  // Relative error by which the gap of a pair may be underestimated. A larger one makes each
  // distance query faster, but divides the motion into more stretches.
  double gap_error = 0.5;
};

template <SettingsOf<MotionCheckOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [tightest, gap_error] = options;
  visit("tightest", tightest, kAbove0);
  visit("gap_error", gap_error, kPart);
}

// How the arm's postures along the line are searched for and checked.
struct ReachOptions {
  // Fewer restarts than IkOptions has: redundant robots arrive from one of the first few starts or
  // not at all.
  IkOptions kinematics = {.restarts = 30, .max_solutions = 24};
  // Longest step along the line; between two steps the joints move along a straight line in joint
  // space, from which the hand deviates a little [m].
  double line_step = 2e-3;
  // Largest change of a joint in one step: more counts as a jump to another branch of the inverse
  // kinematics, where the hand would leave the line [rad or m].
  double largest_joint_step = 0.15;
  MotionCheckOptions motion;
};

template <SettingsOf<ReachOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [kinematics, line_step, largest_joint_step, motion] = options;
  visit("kinematics", kinematics);
  visit("line_step", line_step, kAbove0);
  visit("largest_joint_step", largest_joint_step, kAbove0);
  visit("motion", motion);
}

}  // namespace prehend
