#include "sim/robot/denavit_hartenberg.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace prehend {
namespace {

// Axes count as parallel when the sine of their angle is below this, and parallel axes as the same
// when their distance is [m].
constexpr double kSameAxis = 1e-9;

// Rz(theta) Tz(d) Tx(a) Rx(alpha), multiplied out.
Pose closed_form(const DhParameters& dh) {
  const double ct = std::cos(dh.theta);
  const double st = std::sin(dh.theta);
  const double ca = std::cos(dh.alpha);
  const double sa = std::sin(dh.alpha);
  Matrix3 rotation;
  rotation << ct, -st * ca, st * sa,  //
      st, ct * ca, -ct * sa,          //
      0.0, sa, ca;
  return pose_from(rotation, Vector3(dh.a * ct, dh.a * st, dh.d));
}

// The unit direction of the common normal of both z axes, in the first frame. Of its two senses the
// one with x >= 0 is taken; parallel axes have it from one axis straight to the other.
Vector3 common_normal(const Pose& X, bool parallel) {
  const Vector3 z = X.linear().col(2);
  const Vector3& p = X.translation();
  Vector3 normal = parallel ? Vector3(p.x(), p.y(), 0.0) : Vector3(-z.y(), z.x(), 0.0);
  if (normal.norm() < kSameAxis) return Vector3::UnitX();
  normal.normalize();
  return normal.x() < 0.0 ? Vector3(-normal) : normal;
}

}  // namespace

Joint denavit_hartenberg(Joint joint, const DhParameters& parameters) {
  joint.axis = Vector3::UnitZ();
  DhParameters after = parameters;
  // Rz(theta) and Tz(d) commute, so the one to which the joint's value is added can be split off as
  // the zero of the joint; the rest is the constant pose after it.
  joint.zero = std::exchange(joint.type == JointType::revolute ? after.theta : after.d, 0.0);
  joint.X_JA = closed_form(after);
  return joint;
}

AxisStep step_between_axes(const Pose& X) {
  const Vector3 z = X.linear().col(2);
  const Vector3& p = X.translation();
  const bool parallel = std::hypot(z.x(), z.y()) < kSameAxis;
  const Vector3 normal = common_normal(X, parallel);
  const Vector3 side = Vector3::UnitZ().cross(normal);
  AxisStep step;
  step.dh.theta = std::atan2(normal.y(), normal.x());
  step.dh.a = p.dot(normal);
  if (parallel) {
    step.dh.alpha = z.z() > 0.0 ? 0.0 : std::numbers::pi;
    step.dh.d = p.z();
  } else {
    // p = d z_0 + a normal + beyond z, where z = cos(alpha) z_0 - sin(alpha) side.
    const double sine = -z.dot(side);
    step.dh.alpha = std::atan2(sine, z.z());
    step.beyond = -p.dot(side) / sine;
    step.dh.d = p.z() - step.beyond * z.z();
  }
  const Vector3 x = X.linear().col(0);
  step.twist = std::atan2(x.dot(z.cross(normal)), x.dot(normal));
  return step;
}

}  // namespace prehend
