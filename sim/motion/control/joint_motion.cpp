#include "sim/motion/control/joint_motion.h"

#include <algorithm>

#include "sim/base/input_error.h"

namespace prehend {
namespace {

// The cubic between two samples, at the part u (0 to 1) of its duration.
double on_cubic(double u, double duration, double p0, double v0, double p1, double v1) {
  const double w = 1.0 - u;
  return w * w * (1.0 + 2.0 * u) * p0 + u * w * w * duration * v0 + u * u * (3.0 - 2.0 * u) * p1 -
         u * u * w * duration * v1;
}

std::vector<Eigen::Index> dofs_of(const Trajectory& trajectory, const Robot& robot) {
  std::vector<Eigen::Index> dofs;
  for (const std::string& name : trajectory.joints) {
    const auto found = std::find_if(robot.dofs.begin(), robot.dofs.end(),
                                    [&](const DegreeOfFreedom& dof) { return dof.name == name; });
    if (found == robot.dofs.end()) {
      throw InputError({robot.name, "joints", "has no degree of freedom of that name", name});
    }
    dofs.push_back(found - robot.dofs.begin());
  }
  return dofs;
}

}  // namespace

JointMotion motion_along(const Trajectory& trajectory, const Robot& robot,
                         const Eigen::VectorXd& rest) {
  if (trajectory.times.empty()) {
    throw InputError({.field = "trajectory", .problem = "has no samples"});
  }
  return [trajectory, rest, dofs = dofs_of(trajectory, robot)](double time) -> Eigen::VectorXd {
    const std::vector<double>& times = trajectory.times;
    const double within = std::clamp(time, times.front(), times.back());
    const auto after = std::upper_bound(times.begin(), times.end(), within);
    const auto last = static_cast<std::ptrdiff_t>(times.size()) - 1;
    const auto next = static_cast<std::size_t>(std::min(after - times.begin(), last));
    const std::size_t here = next > 0 ? next - 1 : 0;
    const double duration = times[next] - times[here];
    const double u = duration > 0.0 ? (within - times[here]) / duration : 1.0;
    Eigen::VectorXd values = rest;
    for (std::size_t j = 0; j < dofs.size(); ++j) {
      values[dofs[j]] =
          on_cubic(u, duration, trajectory.positions[here][j], trajectory.velocities[here][j],
                   trajectory.positions[next][j], trajectory.velocities[next][j]);
    }
    return values;
  };
}

}  // namespace prehend
