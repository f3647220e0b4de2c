#include "sim/scene/reach/cartesian_line.h"

#include <algorithm>
#include <cmath>

#include "sim/base/index.h"
#include "sim/robot/inverse_kinematics.h"
#include "sim/scene/compiled_arm.h"

namespace prehend {
namespace {

// Distance from the axis of the point by whose way a turn is divided into steps [m].
constexpr double kTurnArm = 0.1;

// By how much limits are narrower for motions that will be smoothed [rad or m].
constexpr double kInsideLimits = 1e-3;

}  // namespace

FollowedLine follow_line(const CompiledArm& arm, const Pose& X_OH_from, const Pose& X_OH_to,
                         const DofValues& first, const ReachOptions& options,
                         const RunContext& context) {
  const Vector3 way = X_OH_to.translation() - X_OH_from.translation();
  const Eigen::Quaterniond from(X_OH_from.linear());
  const Eigen::Quaterniond to(X_OH_to.linear());
  const bool turns = X_OH_from.linear() != X_OH_to.linear();
  const double length = std::max(way.norm(), turns ? kTurnArm * from.angularDistance(to) : 0.0);
  const int steps = std::max(1, static_cast<int>(std::ceil(length / options.line_step)));
  FollowedLine line{.postures = {first}, .steps = steps};
  Pose X_OH = X_OH_from;
  for (int i = 1; i <= steps; ++i) {
    context.cancellation.check();
    const double part = static_cast<double>(i) / steps;
    X_OH.translation() = X_OH_from.translation() + part * way;
    if (turns) X_OH.linear() = from.slerp(part, to).toRotationMatrix();
    const IkTarget target{arm.hand_part().joint, arm.hand_part().X_JR, arm.X_BO * X_OH};
    const DofValues& before = line.postures.back();
    const auto next = solve_near(arm.robot(), {target}, before, options.kinematics);
    line.failed = i;
    if (!next) return line;
    line.end = LineEnd::jump;
    for (const int d : arm.dofs) {
      if (std::abs((*next)[index(d)] - before[index(d)]) > options.largest_joint_step) return line;
    }
    line.end = LineEnd::unreachable;
    line.postures.push_back(*next);
  }
  line.end = LineEnd::followed;
  line.failed = -1;
  return line;
}

FollowedLine follow_line_inside(CompiledArm& arm, const Pose& X_OH_from, const Pose& X_OH_to,
                                const DofValues& first, const ReachOptions& options,
                                const RunContext& context) {
  std::vector<DegreeOfFreedom>& dofs = arm.platform.robot.dofs;
  const std::vector<DegreeOfFreedom> whole = dofs;
  for (const int d : arm.dofs) {
    DegreeOfFreedom& dof = dofs[index(d)];
    dof.lower = std::min(dof.lower + kInsideLimits, first[index(d)]);
    dof.upper = std::max(dof.upper - kInsideLimits, first[index(d)]);
  }
  FollowedLine line = follow_line(arm, X_OH_from, X_OH_to, first, options, context);
  dofs = whole;
  return line;
}

}  // namespace prehend
