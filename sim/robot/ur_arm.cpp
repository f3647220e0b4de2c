#include "sim/robot/ur_arm.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prehend {
namespace {

// Axes 2, 3 and 4 are parallel, so the arm moves in a plane that only the first joint turns. The
// point where axes 5 and 6 meet has a fixed distance from that plane's axis, which gives joint 1
// (two ways); the angle between axes 4 and 6 gives joint 5 (two ways) and the orientation then
// joint 6 and the pitch, the sum of joints 2, 3 and 4. What is left is a triangle in the plane (two
// ways).

// A target beyond the reach by no more than this is there by rounding only and is solved with the
// arm stretched (relative to the squared lengths).
constexpr double kUrStretched = 1e-12;
// Sine of joint 5 below which axes 4 and 6 count as parallel (singular).
constexpr double kUrStraight = 1e-10;
// The last of the axes that are parallel, counted from 1.
constexpr int kLastParallel = 4;

double ur_sign(double angle) { return angle > 0.0 ? 1.0 : -1.0; }

}  // namespace

std::string ur_arm_defect(const Robot& robot, const Chain& chain) {
  std::string defect = six_revolute_defect(robot, chain);
  if (!defect.empty()) return defect;
  const SixAxes axes = six_axes(robot, chain, kLastParallel);
  const auto at = [&](std::size_t k) -> const DhParameters& { return axes.steps[k].dh; };
  if (!is_exactly_zero(at(0).a) || !is_right_angle(at(0).alpha)) {
    return "the closed form needs the axes of joints 1 and 2 to meet at a right angle";
  }
  for (const std::size_t k : {1U, 2U}) {
    if (!is_exactly_zero(at(k).alpha) || is_exactly_zero(at(k).a)) {
      return "the closed form needs the axes of joints 2, 3 and 4 to be parallel and apart";
    }
  }
  if (!is_exactly_zero(at(3).a) || !is_right_angle(at(3).alpha)) {
    return "the closed form needs the axes of joints 4 and 5 to meet at a right angle";
  }
  if (!is_exactly_zero(at(4).a) || !is_right_angle(at(4).alpha)) {
    return "the closed form needs the axes of joints 5 and 6 to meet at a right angle";
  }
  return "";
}

UrArm::UrArm(const Robot& robot, const Chain& chain) {
  const SixAxes axes = six_axes(robot, chain, kLastParallel);
  angles_ = SixAngles(robot, chain, axes);
  X_PC_ = first_axis_pose(robot, chain, axes);
  X_T6_ = last_axis_pose(robot, chain, axes);
  d1_ = axes.steps[0].dh.d;
  a2_ = axes.steps[1].dh.a;
  a3_ = axes.steps[2].dh.a;
  d5_ = axes.offset_at(4);
  side_ = axes.offset_at(1) + axes.offset_at(2) + axes.offset_at(3);
  sign1_ = ur_sign(axes.steps[0].dh.alpha);
  sign4_ = ur_sign(axes.steps[3].dh.alpha);
  sign5_ = ur_sign(axes.steps[4].dh.alpha);
}

// Hawkins 2013, section "theta 1": the second axis is orthogonal to the arm's plane, and the point
// lies at side_ along it.
UrArm::Solutions UrArm::solve(const Pose& X_CT, const Joints& near) const {
  Solutions all;
  const Pose X_C6 = X_CT * X_T6_;
  const double across = X_C6.translation().head<2>().squaredNorm();
  const double x_squared = across - side_ * side_;
  if (x_squared < -kUrStretched * (across + side_ * side_)) return all;
  const double reach = std::sqrt(std::max(0.0, x_squared));
  const double heading = std::atan2(X_C6.translation().y(), X_C6.translation().x());
  for (const double x : {reach, -reach}) {
    add_wrists(X_C6, heading - std::atan2(-sign1_ * side_, x), near, all);
  }
  return all;
}

// What joints 2 to 6 turn is Rz(pitch) Rx(sign4) Rz(q5) Rx(sign5) Rz(q6). Its third column and its
// third row give all three angles.
void UrArm::add_wrists(const Pose& X_C6, double q1, const Joints& near, Solutions& all) const {
  const Matrix3 R_C1 = axis_turn(q1, sign1_);
  const Matrix3 rotation_16 = R_C1.transpose() * X_C6.linear();
  const Vector3 p_1 = R_C1.transpose() * (X_C6.translation() - d1_ * Vector3::UnitZ());
  const double sine = std::hypot(rotation_16(0, 2), rotation_16(1, 2));
  const double tilt = std::atan2(sine, -sign4_ * sign5_ * rotation_16(2, 2));
  Joints angles{q1, 0.0, 0.0, 0.0, 0.0, 0.0};
  if (sine < kUrStraight) {
    // Singular: axes 4 and 6 are parallel, and only the sum or difference of pitch and the last
    // angle counts. The last joint stays where it is near, and the pitch does the rest.
    angles[4] = -sign4_ * sign5_ * rotation_16(2, 2) > 0.0 ? 0.0 : std::numbers::pi;
    angles[5] = angles_.angle(5, near[5]);
    const Matrix3 wrist =
        axis_turn(0.0, sign4_) * axis_turn(angles[4], sign5_) * axis_turn(angles[5], 0.0);
    const Matrix3 rest = rotation_16 * wrist.transpose();
    add_elbows(p_1, std::atan2(rest(1, 0), rest(0, 0)), angles, near, all);
    return;
  }
  for (const double flip : {1.0, -1.0}) {
    angles[4] = flip * tilt;
    const double pitch =
        std::atan2(flip * sign5_ * rotation_16(1, 2), flip * sign5_ * rotation_16(0, 2));
    // The last angle is what is left, so that it makes up for the rounding of a pitch that is
    // poorly determined near the singularity.
    const Matrix3 before = axis_turn(pitch, sign4_) * axis_turn(angles[4], sign5_);
    const Matrix3 rest = before.transpose() * rotation_16;
    angles[5] = std::atan2(rest(1, 0), rest(0, 0));
    add_elbows(p_1, pitch, angles, near, all);
  }
}

// Law of cosines for the triangle of the axes 2, 3 and 4, in the plane of the arm.
void UrArm::add_elbows(const Vector3& p_1, double pitch, Joints angles, const Joints& near,
                       Solutions& all) const {
  const double x = p_1.x() - d5_ * sign4_ * std::sin(pitch);
  const double y = p_1.y() + d5_ * sign4_ * std::cos(pitch);
  const double bars = a2_ * a2_ + a3_ * a3_;
  double cosine = (x * x + y * y - bars) / (2.0 * a2_ * a3_);
  if (std::abs(cosine) > 1.0 + kUrStretched * bars / std::abs(a2_ * a3_)) return;
  cosine = std::clamp(cosine, -1.0, 1.0);
  const double bend = std::acos(cosine);
  const double beyond = std::atan2(a3_ * std::sin(bend), a2_ + a3_ * cosine);
  for (const double elbow : {1.0, -1.0}) {
    angles[1] = std::atan2(y, x) - elbow * beyond;
    angles[2] = elbow * bend;
    angles[3] = pitch - angles[1] - angles[2];
    angles_.add_if_inside(angles, near, all);
  }
}

}  // namespace prehend
