#include "sim/robot/spherical_wrist.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/robot/denavit_hartenberg.h"

namespace prehend {
namespace {

// The closed form works on six axes, not on the frames of the joints: axes_of() measures the
// Denavit-Hartenberg parameters between neighbouring axes, choosing among equivalent ones those
// that the formulas expect. The solution then has two independent halves, because the three wrist
// axes meet in a point that only the first three joints move: these place that point (at most four
// ways), and the last three turn the hand into its orientation (two ways for each).

constexpr double kTurn = 2.0 * std::numbers::pi;
// Angles and lengths this close to a right angle or to 0 count as exact [rad or m].
constexpr double kExact = 1e-9;
// A target beyond the reach by no more than this is there by rounding only and is solved with the
// arm stretched (relative to the squared lengths).
constexpr double kStretched = 1e-12;
// Sine of the wrist's bend below which its first and last axis count as one line (singular).
constexpr double kStraight = 1e-10;

bool is_zero(double value) { return std::abs(value) < kExact; }
bool is_right_angle(double angle) { return is_zero(std::abs(angle) - std::numbers::pi / 2.0); }
double sign_of(double angle) { return angle > 0.0 ? 1.0 : -1.0; }

const Joint& joint_of(const Robot& robot, const Chain& chain, int k) {
  return robot.joints[static_cast<std::size_t>(chain.first_joint + k)];
}

// Rz(theta) Rx(sign * 90 degrees) or, for sign 0, Rz(theta).
Matrix3 turn(double theta, double sign) {
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

// The chain in the form that the formulas need: Denavit-Hartenberg parameters between its axes.
struct Axes {
  std::array<Vector3, 6> axis;  // of the joint or its negative, in the joint frame
  std::array<double, 6> sense;  // 1, or -1 where the negative was taken
  std::array<AxisStep, 5> steps;
};

// A frame at the joint frame's origin with z along `axis`, in the joint frame.
Pose along(const Vector3& axis) {
  if (axis == Vector3::UnitZ()) return Pose::Identity();
  return Pose(Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), axis));
}

// From axis k to axis k + 1.
AxisStep step_after(const Robot& robot, const Chain& chain, const Axes& axes, int k) {
  const auto i = static_cast<std::size_t>(k);
  const Pose X_JK = joint_of(robot, chain, k).X_JA * joint_of(robot, chain, k + 1).X_PJ;
  return step_between_axes(along(axes.axis[i]).inverse() * X_JK * along(axes.axis[i + 1]));
}

Axes axes_of(const Robot& robot, const Chain& chain) {
  Axes axes{};
  for (int k = 0; k < 6; ++k) {
    axes.axis[static_cast<std::size_t>(k)] = joint_of(robot, chain, k).axis;
    axes.sense[static_cast<std::size_t>(k)] = 1.0;
  }
  // The formulas need alpha2 = 0. Where the third axis is antiparallel to the second (alpha2 = pi),
  // its negative is used, and the joint's value with the opposite sign.
  if (std::abs(step_after(robot, chain, axes, 1).dh.alpha) > std::numbers::pi / 2.0) {
    axes.axis[2] = -axes.axis[2];
    axes.sense[2] = -1.0;
  }
  for (int k = 0; k < 5; ++k) {
    axes.steps[static_cast<std::size_t>(k)] = step_after(robot, chain, axes, k);
  }
  // The formulas need alpha5 = -alpha4. Where they are equal, the common normal of axes 5 and 6 is
  // reversed, which describes the same axes: theta grows by half a turn, a and alpha change sign,
  // and the frame after it turns back by half a turn.
  AxisStep& wrist = axes.steps[4];
  if (axes.steps[3].dh.alpha * wrist.dh.alpha > 0.0) {
    wrist.dh.theta += std::numbers::pi;
    wrist.dh.a = -wrist.dh.a;
    wrist.dh.alpha = -wrist.dh.alpha;
    wrist.twist += std::numbers::pi;
  }
  return axes;
}

// The link offset d at axis k [m]: the distance along the axis between the feet of its common
// normals with the axes before and after it.
double offset_at(const Axes& axes, std::size_t k) {
  return axes.steps[k].dh.d + (k > 0 ? axes.steps[k - 1].beyond : 0.0);
}

}  // namespace

std::string spherical_wrist_defect(const Robot& robot, const Chain& chain) {
  if (chain.joint_count != 6) return "the closed form needs six joints";
  for (int k = 0; k < 6; ++k) {
    if (joint_of(robot, chain, k).type != JointType::revolute) {
      return "the closed form needs revolute joints";
    }
  }
  const Axes axes = axes_of(robot, chain);
  const auto at = [&](std::size_t k) -> const DhParameters& { return axes.steps[k].dh; };
  if (!is_zero(at(0).a) || !is_right_angle(at(0).alpha)) {
    return "the closed form needs the axes of joints 1 and 2 to meet at a right angle";
  }
  if (!is_zero(at(1).alpha) || is_zero(at(1).a)) {
    return "the closed form needs the axes of joints 2 and 3 to be parallel and apart";
  }
  if (!is_right_angle(at(2).alpha)) {
    return "the closed form needs the axis of joint 4 at a right angle to that of joint 3";
  }
  if (!is_zero(at(3).a) || !is_zero(at(4).a) || !is_zero(offset_at(axes, 4))) {
    return "the closed form needs the axes of joints 4, 5 and 6 to meet in a point";
  }
  if (!is_right_angle(at(3).alpha) || !is_right_angle(at(4).alpha)) {
    return "the closed form needs the axis of joint 5 at a right angle to those of joints 4 and 6";
  }
  if (is_zero(std::hypot(at(2).a, offset_at(axes, 3)))) {
    return "the closed form needs the wrist away from the axis of joint 3";
  }
  return "";
}

SphericalWrist::SphericalWrist(const Robot& robot, const Chain& chain) {
  const Axes axes = axes_of(robot, chain);
  for (std::size_t k = 0; k < 6; ++k) {
    const Joint& joint = joint_of(robot, chain, static_cast<int>(k));
    sense_[k] = axes.sense[k];
    theta_[k] = axes.sense[k] * joint.zero;
    if (k > 0) theta_[k] += axes.steps[k - 1].twist;
    if (k < 5) theta_[k] += axes.steps[k].dh.theta;
    lower_[k] = joint.lower;
    upper_[k] = joint.upper;
  }
  X_PC_ = joint_of(robot, chain, 0).X_PJ * along(axes.axis[0]);
  const Pose X_6T = translation(axes.steps[4].beyond * Vector3::UnitZ()) *
                    along(axes.axis[5]).inverse() * joint_of(robot, chain, 5).X_JA;
  X_T6_ = X_6T.inverse();
  const DhParameters& elbow = axes.steps[2].dh;
  d1_ = axes.steps[0].dh.d;
  a2_ = axes.steps[1].dh.a;
  side_ = offset_at(axes, 1) + offset_at(axes, 2);
  const double d4 = offset_at(axes, 3);
  shoulder_sign_ = sign_of(axes.steps[0].dh.alpha);
  elbow_sign_ = sign_of(elbow.alpha);
  wrist_sign_ = sign_of(axes.steps[3].dh.alpha);
  forearm_ = std::hypot(elbow.a, d4);
  fold_ = std::atan2(-d4 * elbow_sign_, elbow.a);
}

SphericalWrist::Solutions SphericalWrist::solve(const Pose& X_CT, const Joints& near) const {
  Solutions all;
  const Pose X_C6 = X_CT * X_T6_;
  const Matrix3 R_C6 = X_C6.linear();
  const Vector3& wrist = X_C6.translation();
  // Upper arm and forearm move in a plane orthogonal to the second axis. It turns with the first
  // joint and stays at the distance side_ from the first axis. (x, y) is the wrist in that plane,
  // seen from the shoulder; x may have either sign, which are the arm's left and right branches.
  // `across` is the squared distance of the wrist from the first axis, so x^2 + side^2 = across.
  const double across = wrist.head<2>().squaredNorm();
  const double x_squared = across - side_ * side_;
  if (x_squared < -kStretched * (across + side_ * side_)) return all;
  const double reach = std::sqrt(std::max(0.0, x_squared));
  const double y = shoulder_sign_ * (wrist.z() - d1_);
  const double heading = std::atan2(wrist.y(), wrist.x());
  // Law of cosines for the triangle of shoulder, elbow and wrist. `bend` is the angle between upper
  // arm and forearm (0: stretched), `beyond` the angle at the shoulder between the upper arm and
  // the line to the wrist. Elbow up and down differ in the sign of both.
  const double bars = a2_ * a2_ + forearm_ * forearm_;
  double cosine = (reach * reach + y * y - bars) / (2.0 * a2_ * forearm_);
  if (std::abs(cosine) > 1.0 + kStretched * bars / std::abs(a2_ * forearm_)) return all;
  cosine = std::clamp(cosine, -1.0, 1.0);
  const double bend = std::acos(cosine);
  const double beyond = std::atan2(forearm_ * std::sin(bend), a2_ + forearm_ * cosine);
  for (const double x : {reach, -reach}) {
    const double q1 = heading - std::atan2(-shoulder_sign_ * side_, x);
    const Matrix3 R_C1 = turn(q1, shoulder_sign_);
    const double rise = std::atan2(y, x);
    for (const double elbow : {1.0, -1.0}) {
      const double q2 = rise - elbow * beyond;
      const double q3 = elbow * bend - fold_;
      const Matrix3 R_C3 = R_C1 * turn(q2 + q3, elbow_sign_);
      add_wrists(R_C3.transpose() * R_C6, {q1, q2, q3, 0.0, 0.0, 0.0}, near, all);
    }
  }
  return all;
}

// The three wrist angles from the rotation that is left for the wrist: with axes at right angles it
// is Rz(q4) Ry(tilt) Rz(q6), tilt = -wrist_sign_ * q5, a product of ZYZ Euler angles. They have two
// solutions, (q4, tilt, q6) and (q4 + pi, -tilt, q6 + pi): the wrist flipped or not.
void SphericalWrist::add_wrists(const Matrix3& R_3T, const Joints& arm, const Joints& near,
                                Solutions& all) const {
  const double sine = std::hypot(R_3T(0, 2), R_3T(1, 2));
  Joints angles = arm;
  if (sine < kStraight) {
    // Singular: axes 4 and 6 are one line and only the sum or difference of their angles counts.
    // The fourth joint stays where it is near, and the sixth does the rest.
    angles[3] = sense_[3] * near[3] + theta_[3];
    const Matrix3 rest = turn(angles[3], 0.0).transpose() * R_3T;
    angles[4] = R_3T(2, 2) > 0.0 ? 0.0 : std::numbers::pi;
    angles[5] = std::atan2(rest(1, 0), rest(1, 1));
    add_if_inside(angles, near, all);
    return;
  }
  const double tilt = std::atan2(sine, R_3T(2, 2));
  for (const double flip : {1.0, -1.0}) {
    angles[3] = std::atan2(flip * R_3T(1, 2), flip * R_3T(0, 2));
    angles[4] = -wrist_sign_ * flip * tilt;
    angles[5] = std::atan2(flip * R_3T(2, 1), -flip * R_3T(2, 0));
    add_if_inside(angles, near, all);
  }
}

void SphericalWrist::add_if_inside(Joints angles, const Joints& near, Solutions& all) const {
  for (std::size_t k = 0; k < 6; ++k) {
    double value = sense_[k] * (angles[k] - theta_[k]);
    // The angle is known up to whole turns. First the one within half a turn of `near`, and if that
    // is outside the limits, the nearest one inside, where there is one.
    value += kTurn * std::round((near[k] - value) / kTurn);
    if (value < lower_[k] - kExact)
      value += kTurn * std::ceil((lower_[k] - kExact - value) / kTurn);
    if (value > upper_[k] + kExact)
      value -= kTurn * std::ceil((value - upper_[k] - kExact) / kTurn);
    if (value < lower_[k] - kExact) return;
    angles[k] = std::clamp(value, lower_[k], upper_[k]);
  }
  all.joints[static_cast<std::size_t>(all.count++)] = angles;
}

}  // namespace prehend
