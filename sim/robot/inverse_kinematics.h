// Inverse kinematics: values of the degrees of freedom that bring frames of a robot to given poses.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/base/settings.h"
#include "sim/robot/robot.h"
#include "sim/robot/spherical_wrist.h"

namespace prehend {

// A frame fixed to a robot, and where it should be.
struct IkTarget {
  int joint = 0;                 // the frame is fixed to the one after this joint ...
  Pose X_JT = Pose::Identity();  // ... here
  Pose X_BT = Pose::Identity();  // where it should be, in the robot's base frame
};

struct IkOptions {
  double position_tolerance = 1e-9;  // m
  double angle_tolerance = 1e-9;     // rad
  int max_iterations = 80;           // from one start
  int restarts = 100;                // random starts, after the given one
  int max_solutions = 16;            // no more are looked for (>= 1)
  std::uint64_t seed = 1;
};

template <SettingsOf<IkOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [position_tolerance, angle_tolerance, max_iterations, restarts, max_solutions, seed] =
      options;
  visit("position_tolerance", position_tolerance);
  visit("angle_tolerance", angle_tolerance);
  visit("max_iterations", max_iterations);
  visit("restarts", restarts);
  visit("max_solutions", max_solutions);
}

// Every degree of freedom of the robot has a value; those that move no target keep theirs.
using DofValues = std::vector<double>;

// Damped least squares from `start` (Levenberg-Marquardt with the damping of Sugihara 2011), all
// targets at once, kept inside the limits; nothing when it does not arrive. A degree of freedom
// that pushes against a limit is left out of the step.
std::optional<DofValues> solve_near(const Robot& robot, const std::vector<IkTarget>& targets,
                                    const DofValues& start, const IkOptions& options = {});

// Different solutions, the one with the shortest way from `start` first; seeded. One target on a
// chain with a closed form and no other degree of freedom before it: all branches of that. Else
// solve_near from `start` and from random starts, spread where the robot is redundant; behind other
// degrees of freedom a closed form gives all branches for what those were found to be. Throws
// Cancelled.
std::vector<DofValues> solve_all(const Robot& robot, const std::vector<IkTarget>& targets,
                                 const DofValues& start, const IkOptions& options = {},
                                 const RunContext& context = {});

// The least distance of the listed degrees of freedom from their limits, each as a part of half its
// range: 0 when one is at a limit, 1 when all are in the middle.
double limit_margin(const Robot& robot, const std::vector<int>& dofs, const DofValues& values);

// Degrees of freedom that move the frame after `joint`, base to tip.
std::vector<int> dofs_to(const Robot& robot, int joint);

}  // namespace prehend
