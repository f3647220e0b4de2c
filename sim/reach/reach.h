// Whether the arm brings the hand to a grasp: from the pre-grasp along a straight line.
#pragma once

#include <optional>
#include <vector>

#include "sim/base/settings.h"
#include "sim/reach/motion_check.h"
#include "sim/robot/inverse_kinematics.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {

struct ReachOptions {
  // Fewer restarts than IkOptions has: redundant robots arrive from one of the first few starts or
  // not at all.
  IkOptions kinematics = {.restarts = 30, .max_solutions = 24};
  // The line is followed in steps of this; between them the joints move straight [m].
  double line_step = 2e-3;
  // Largest change of a joint in one step: more is a jump to another branch [rad or m].
  double largest_joint_step = 0.15;
  MotionCheckOptions motion;
};

template <SettingsOf<ReachOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [kinematics, line_step, largest_joint_step, motion] = options;
  visit("kinematics", kinematics);
  visit("line_step", line_step);
  visit("largest_joint_step", largest_joint_step);
  visit("motion", motion);
}

// A straight motion of the hand with its joints at rest, in the object's frame.
struct HandLine {
  Pose X_OH_from = Pose::Identity();  // the pre-grasp
  Pose X_OH_to = Pose::Identity();    // the grasp: moved, not turned
  std::vector<double> hand_joints;
};

enum class ReachEnd {
  reached,
  unreachable,  // no posture inside the limits, or none that follows the line without a jump
  blocked,      // by `pair`, in the last posture that was tried
};

struct Reach {
  ReachEnd end = ReachEnd::unreachable;
  std::optional<ArmPair> pair;
  // Degrees of freedom along the line, from the pre-grasp to the grasp; of the platform.
  std::vector<DofValues> line;
};

// Postures that put the hand at X_OH, the one with the shortest way from the start first. Throws
// Cancelled.
std::vector<DofValues> postures_at(const CompiledArm& arm, const Pose& X_OH,
                                   const ReachOptions& options, const RunContext& context = {});

// Tries the postures of the pre-grasp, nearest to the start first, until `most` of them follow the
// line: with one continuous solution of the inverse kinematics, and without collision of the robots
// with each other, or of any link but the hand's with the object and the obstacles (the trial
// checks the hand itself). Returns those that reach, or where none does one failure: the first
// collision, else unreachable. Throws Cancelled.
std::vector<Reach> find_reaches(const CompiledArm& arm, const HandLine& line, int most,
                                const ReachOptions& options, const RunContext& context = {});

// The first of them.
Reach find_reach(const CompiledArm& arm, const HandLine& line, const ReachOptions& options,
                 const RunContext& context = {});

// The postures along the line of which `last`, with the hand at X_OH_to, is the last one: the line
// is followed back from there. Empty where that meets a limit or would have to jump to another
// branch. Collisions are not checked. Throws Cancelled.
std::vector<DofValues> line_ending_in(const CompiledArm& arm, const HandLine& line,
                                      const DofValues& last, const ReachOptions& options,
                                      const RunContext& context = {});

}  // namespace prehend
