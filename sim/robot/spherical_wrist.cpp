#include "sim/robot/spherical_wrist.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prehend {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
// Parameters typed with few digits are still meant to be right angles and zeros [rad or m].
constexpr double kExact = 1e-9;
// Beyond the reach by rounding only [part of the lengths squared].
constexpr double kStretched = 1e-12;
// Sine below which the wrist counts as straight.
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

}  // namespace

std::string spherical_wrist_defect(const Robot& robot, const Chain& chain) {
  if (chain.joint_count != 6) return "the closed form needs six joints";
  for (int k = 0; k < 6; ++k) {
    if (joint_of(robot, chain, k).type != JointType::revolute) {
      return "the closed form needs revolute joints";
    }
  }
  const auto at = [&](int k) -> const Joint& { return joint_of(robot, chain, k); };
  const bool shoulder =
      is_zero(at(0).a) && is_right_angle(at(0).alpha) && is_zero(at(1).alpha) && !is_zero(at(1).a);
  const bool elbow = is_right_angle(at(2).alpha) && !is_zero(std::hypot(at(2).a, at(3).d));
  const bool wrist = is_zero(at(3).a) && is_zero(at(4).a) && is_zero(at(5).a) && is_zero(at(4).d) &&
                     is_right_angle(at(3).alpha) && is_zero(at(3).alpha + at(4).alpha) &&
                     is_zero(at(5).alpha);
  if (!shoulder) return "the closed form needs a1 = 0, alpha1 = +-90 degrees, alpha2 = 0, a2 not 0";
  if (!elbow) return "the closed form needs alpha3 = +-90 degrees and a forearm";
  if (!wrist) return "the closed form needs a spherical wrist";
  return "";
}

SphericalWrist::SphericalWrist(const Robot& robot, const Chain& chain) {
  const auto at = [&](int k) -> const Joint& { return joint_of(robot, chain, k); };
  for (int k = 0; k < 6; ++k) {
    const auto i = static_cast<std::size_t>(k);
    theta_[i] = at(k).theta;
    lower_[i] = at(k).lower;
    upper_[i] = at(k).upper;
  }
  d1_ = at(0).d;
  a2_ = at(1).a;
  side_ = at(1).d + at(2).d;
  d6_ = at(5).d;
  shoulder_sign_ = sign_of(at(0).alpha);
  elbow_sign_ = sign_of(at(2).alpha);
  wrist_sign_ = sign_of(at(3).alpha);
  forearm_ = std::hypot(at(2).a, at(3).d);
  fold_ = std::atan2(-at(3).d * elbow_sign_, at(2).a);
}

SphericalWrist::Solutions SphericalWrist::solve(const Pose& X_CT, const Joints& near) const {
  Solutions all;
  const Matrix3 R_CT = X_CT.linear();
  const Vector3 wrist = X_CT.translation() - d6_ * R_CT.col(2);
  // Seen along the shoulder's second axis, the arm is two bars in a plane that passes the first
  // axis at the distance side_: (x, y) is the wrist in that plane.
  const double across = wrist.head<2>().squaredNorm();
  const double x_squared = across - side_ * side_;
  if (x_squared < -kStretched * (across + side_ * side_)) return all;
  const double reach = std::sqrt(std::max(0.0, x_squared));
  const double y = shoulder_sign_ * (wrist.z() - d1_);
  const double heading = std::atan2(wrist.y(), wrist.x());
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
      add_wrists(R_C3.transpose() * R_CT, {q1, q2, q3, 0.0, 0.0, 0.0}, near, all);
    }
  }
  return all;
}

// The wrist turns like Rz(q4) Ry(tilt) Rz(q6).
void SphericalWrist::add_wrists(const Matrix3& R_3T, const Joints& arm, const Joints& near,
                                Solutions& all) const {
  const double sine = std::hypot(R_3T(0, 2), R_3T(1, 2));
  Joints angles = arm;
  if (sine < kStraight) {
    angles[3] = near[3] + theta_[3];
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
    double value = angles[k] - theta_[k];
    value += kTurn * std::round((near[k] - value) / kTurn);  // within half a turn of near
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
