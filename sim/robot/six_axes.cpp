#include "sim/robot/six_axes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prehend {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kExact = 1e-9;

const Joint& joint_of(const Robot& robot, const Chain& chain, std::size_t k) {
  return robot.joints[static_cast<std::size_t>(chain.first_joint) + k];
}

// A frame at the joint frame's origin with z along `axis`, in the joint frame.
Pose along(const Vector3& axis) {
  if (axis == Vector3::UnitZ()) return Pose::Identity();
  return Pose(Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), axis));
}

// From axis k to axis k + 1.
AxisStep step_after(const Robot& robot, const Chain& chain, const SixAxes& axes, std::size_t k) {
  const Pose X_JK = joint_of(robot, chain, k).X_JA * joint_of(robot, chain, k + 1).X_PJ;
  return step_between_axes(along(axes.axis[k]).inverse() * X_JK * along(axes.axis[k + 1]));
}

}  // namespace

bool is_exactly_zero(double value) { return std::abs(value) < kExact; }
bool is_right_angle(double angle) {
  return is_exactly_zero(std::abs(angle) - std::numbers::pi / 2.0);
}

Matrix3 axis_turn(double theta, double sign) {
  const double c = std::cos(theta);
  const double s = std::sin(theta);
  Matrix3 rotation;
  if (sign == 0.0) {
    rotation << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
  } else {
    rotation << c, 0.0, sign * s, s, 0.0, -sign * c, 0.0, sign, 0.0;
  }
  return rotation;
}

std::string six_revolute_defect(const Robot& robot, const Chain& chain) {
  if (chain.joint_count != 6) return "the closed form needs six joints";
  for (std::size_t k = 0; k < 6; ++k) {
    if (joint_of(robot, chain, k).type != JointType::revolute) {
      return "the closed form needs revolute joints";
    }
  }
  return "";
}

SixAxes six_axes(const Robot& robot, const Chain& chain, int last_parallel) {
  SixAxes axes{};
  for (std::size_t k = 0; k < 6; ++k) {
    axes.axis[k] = joint_of(robot, chain, k).axis;
    axes.sense[k] = 1.0;
  }
  for (std::size_t k = 2; k < static_cast<std::size_t>(last_parallel); ++k) {
    if (std::abs(step_after(robot, chain, axes, k - 1).dh.alpha) > std::numbers::pi / 2.0) {
      axes.axis[k] = -axes.axis[k];
      axes.sense[k] = -1.0;
    }
  }
  for (std::size_t k = 0; k < 5; ++k) axes.steps[k] = step_after(robot, chain, axes, k);
  return axes;
}

SixAngles::SixAngles(const Robot& robot, const Chain& chain, const SixAxes& axes) {
  for (std::size_t k = 0; k < 6; ++k) {
    const Joint& joint = joint_of(robot, chain, k);
    sense[k] = axes.sense[k];
    theta[k] = axes.sense[k] * joint.zero;
    if (k > 0) theta[k] += axes.steps[k - 1].twist;
    if (k < 5) theta[k] += axes.steps[k].dh.theta;
    lower[k] = joint.lower;
    upper[k] = joint.upper;
  }
}

void SixAngles::add_if_inside(SixJoints angles, const SixJoints& near,
                              SixJointSolutions& all) const {
  for (std::size_t k = 0; k < 6; ++k) {
    double value = sense[k] * (angles[k] - theta[k]);
    value += kTurn * std::round((near[k] - value) / kTurn);
    if (value < lower[k] - kExact) value += kTurn * std::ceil((lower[k] - kExact - value) / kTurn);
    if (value > upper[k] + kExact) value -= kTurn * std::ceil((value - upper[k] - kExact) / kTurn);
    if (value < lower[k] - kExact) return;
    angles[k] = std::clamp(value, lower[k], upper[k]);
  }
  all.joints[static_cast<std::size_t>(all.count++)] = angles;
}

Pose first_axis_pose(const Robot& robot, const Chain& chain, const SixAxes& axes) {
  return joint_of(robot, chain, 0).X_PJ * along(axes.axis[0]);
}

Pose last_axis_pose(const Robot& robot, const Chain& chain, const SixAxes& axes) {
  const Pose X_6T = translation(axes.steps[4].beyond * Vector3::UnitZ()) *
                    along(axes.axis[5]).inverse() * joint_of(robot, chain, 5).X_JA;
  return X_6T.inverse();
}

}  // namespace prehend
