#include "sim/robot/spherical_wrist.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prehend {
namespace {

// The closed form works on six axes, not on the frames of the joints (six_axes.h). The solution has
// two independent halves, because the three wrist axes meet in a point that only the first three
// joints move: these place that point (at most four ways), and the last three turn the hand into
// its orientation (two ways for each).

// A target beyond the reach by no more than this is there by rounding only and is solved with the
// arm stretched (relative to the squared lengths).
constexpr double kStretched = 1e-12;
// Sine of the wrist's bend below which its first and last axis count as one line (singular).
constexpr double kStraight = 1e-10;

double sign_of(double angle) { return angle > 0.0 ? 1.0 : -1.0; }

// Axis 3 is made to point the way of axis 2 (alpha2 = 0).
SixAxes wrist_axes(const Robot& robot, const Chain& chain) {
  SixAxes axes = six_axes(robot, chain, 3);
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

}  // namespace

std::string spherical_wrist_defect(const Robot& robot, const Chain& chain) {
  std::string defect = six_revolute_defect(robot, chain);
  if (!defect.empty()) return defect;
  const SixAxes axes = wrist_axes(robot, chain);
  const auto at = [&](std::size_t k) -> const DhParameters& { return axes.steps[k].dh; };
  if (!is_exactly_zero(at(0).a) || !is_right_angle(at(0).alpha)) {
    return "the closed form needs the axes of joints 1 and 2 to meet at a right angle";
  }
  if (!is_exactly_zero(at(1).alpha) || is_exactly_zero(at(1).a)) {
    return "the closed form needs the axes of joints 2 and 3 to be parallel and apart";
  }
  if (!is_right_angle(at(2).alpha)) {
    return "the closed form needs the axis of joint 4 at a right angle to that of joint 3";
  }
  if (!is_exactly_zero(at(3).a) || !is_exactly_zero(at(4).a) ||
      !is_exactly_zero(axes.offset_at(4))) {
    return "the closed form needs the axes of joints 4, 5 and 6 to meet in a point";
  }
  if (!is_right_angle(at(3).alpha) || !is_right_angle(at(4).alpha)) {
    return "the closed form needs the axis of joint 5 at a right angle to those of joints 4 and 6";
  }
  if (is_exactly_zero(std::hypot(at(2).a, axes.offset_at(3)))) {
    return "the closed form needs the wrist away from the axis of joint 3";
  }
  return "";
}

SphericalWrist::SphericalWrist(const Robot& robot, const Chain& chain) {
  const SixAxes axes = wrist_axes(robot, chain);
  angles_ = SixAngles(robot, chain, axes);
  X_PC_ = first_axis_pose(robot, chain, axes);
  X_T6_ = last_axis_pose(robot, chain, axes);
  const DhParameters& elbow = axes.steps[2].dh;
  d1_ = axes.steps[0].dh.d;
  a2_ = axes.steps[1].dh.a;
  side_ = axes.offset_at(1) + axes.offset_at(2);
  const double d4 = axes.offset_at(3);
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
    const Matrix3 R_C1 = axis_turn(q1, shoulder_sign_);
    const double rise = std::atan2(y, x);
    for (const double elbow : {1.0, -1.0}) {
      const double q2 = rise - elbow * beyond;
      const double q3 = elbow * bend - fold_;
      const Matrix3 R_C3 = R_C1 * axis_turn(q2 + q3, elbow_sign_);
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
    angles[3] = angles_.angle(3, near[3]);
    const Matrix3 rest = axis_turn(angles[3], 0.0).transpose() * R_3T;
    angles[4] = R_3T(2, 2) > 0.0 ? 0.0 : std::numbers::pi;
    angles[5] = std::atan2(rest(1, 0), rest(1, 1));
    angles_.add_if_inside(angles, near, all);
    return;
  }
  const double tilt = std::atan2(sine, R_3T(2, 2));
  for (const double flip : {1.0, -1.0}) {
    angles[3] = std::atan2(flip * R_3T(1, 2), flip * R_3T(0, 2));
    angles[4] = -wrist_sign_ * flip * tilt;
    angles[5] = std::atan2(flip * R_3T(2, 1), -flip * R_3T(2, 0));
    angles_.add_if_inside(angles, near, all);
  }
}

}  // namespace prehend
