// Inverse kinematics: values of the degrees of freedom that bring frames of a robot to given poses.
#pragma once

#include <optional>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/robot/dof_values.h"
#include "sim/robot/ik_options.h"
#include "sim/robot/robot.h"

namespace prehend {

// A frame T fixed to a robot, and the pose that it should have.
struct IkTarget {
  int joint = 0;                 // T is fixed to the frame J after this joint
  Pose X_JT = Pose::Identity();  // pose of T in J
  Pose X_BT = Pose::Identity();  // wanted pose of T in the robot's base frame B
};

// The solution to which damped least squares converge from `start`, for all targets at once and
// inside the limits; nothing when they do not converge. Degrees of freedom that move no target keep
// their values. Source: Levenberg-Marquardt with the damping of Sugihara, "Solvability-unconcerned
// inverse kinematics by the Levenberg-Marquardt method", 2011.
std::optional<DofValues> solve_near(const Robot& robot, const std::vector<IkTarget>& targets,
                                    const DofValues& start, const IkOptions& options = {});

// Different solutions inside the limits, sorted by the sum of the distances that the degrees of
// freedom move from `start`. The same arguments give the same solutions. Throws Cancelled.
//
// For one target at the end of a chain with a closed form (ClosedForm) that alone moves it, these
// are all branches of the closed form. Otherwise they are found numerically (solve_near) from
// `start` and from random starts, which need not find all. Where such a chain stands on other
// degrees of freedom, such as a mobile base, each numerical solution adds all branches of the
// closed form with the base where that solution has it.
std::vector<DofValues> solve_all(const Robot& robot, const std::vector<IkTarget>& targets,
                                 const DofValues& start, const IkOptions& options = {},
                                 const RunContext& context = {});

// The smallest distance of the listed degrees of freedom from their limits, each divided by half
// its range: 0 when one is at a limit, 1 when all are in the middle.
double limit_margin(const Robot& robot, const std::vector<int>& dofs, const DofValues& values);

// Degrees of freedom that move the frame after `joint`, base to tip.
std::vector<int> dofs_to(const Robot& robot, int joint);

}  // namespace prehend
