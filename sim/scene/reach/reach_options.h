// How an arm's motions are searched for and checked for collision.
#pragma once

#include "sim/base/settings.h"
#include "sim/robot/ik_options.h"

namespace prehend {

struct MotionCheckOptions {
  static constexpr AboutSettings kAbout{"MotionCheckOptions",
                                        "How motions are proven free of collision."};
  // Motions with gaps below about half of this may be refused.
  double tightest = 2e-4;
};

template <SettingsOf<MotionCheckOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [tightest] = options;
  visit("tightest", tightest, kLengthAbove0, "m",
        "A stretch on which the bodies of a pair move by no more than this against each other is "
        "not divided further: a pair not yet proved free there counts as blocked.");
}

struct ReachOptions {
  static constexpr AboutSettings kAbout{"ReachOptions", "How an arm follows the hand's approach."};
  // Fewer restarts than IkOptions has: redundant robots arrive from one of the first few starts or
  // not at all.
  IkOptions kinematics = {.restarts = 30, .max_solutions = 24};
  // Between two steps the joints move along a straight line in joint space, from which the hand
  // deviates a little.
  double line_step = 2e-3;
  double largest_joint_step = 0.15;
  MotionCheckOptions motion;
};

template <SettingsOf<ReachOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [kinematics, line_step, largest_joint_step, motion] = options;
  visit("kinematics", kinematics, "The arm's inverse kinematics.");
  visit("line_step", line_step, kLengthAbove0, "m", "Longest step along the line.");
  visit("largest_joint_step", largest_joint_step, kLengthAbove0, "rad or m",
        "More change of a joint in one step counts as a jump to another branch of the inverse "
        "kinematics, where the hand would leave the line.");
  visit("motion", motion, "How the arm's motion is proven free of collision.");
}

}  // namespace prehend
