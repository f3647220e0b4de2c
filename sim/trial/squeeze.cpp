#include "sim/trial/squeeze.h"

#include <algorithm>

#include "sim/base/index.h"

namespace prehend {
namespace {

// The direction within the friction cone of a contact that is nearest to `along`. Both it and the
// contact's normal are unit.
Vector3 within_cone(const Vector3& along, const Contact& contact) {
  const double normal = along.dot(contact.normal);
  const Vector3 tangent = along - normal * contact.normal;
  const double sideways = tangent.norm();
  if (sideways <= contact.friction * normal) return along;
  if (sideways < 1e-12) return contact.normal;
  return (contact.normal + contact.friction / sideways * tangent).normalized();
}

// Force and torque about the object's origin of one finger, which presses with 1 N along its way.
struct Press {
  int contacts = 0;
  Vector3 point_O = Vector3::Zero();  // mean of the contacts [m]
  Vector3 force_O = Vector3::Zero();
  Vector3 torque_O = Vector3::Zero();
};

// The contacts of all links beyond a joint share the force equally. A contact whose normal is
// across the finger's way, or against it, takes no part.
Press press(const CompiledScene& scene, const Trial& trial, int joint, const Vector3& along) {
  constexpr double kAcross = 0.05;  // cosine of the angle from which a contact lies across
  Press press;
  for (const GraspContact& contact : trial.contacts) {
    const std::vector<int>& joints = scene.links[index(contact.link)].joints;
    if (std::find(joints.begin(), joints.end(), joint) == joints.end()) continue;
    ++press.contacts;
    press.point_O += contact.point.position;
    if (along.dot(contact.point.normal) < kAcross) continue;
    const Vector3 force = within_cone(along, contact.point);
    press.force_O += force;
    press.torque_O += contact.point.position.cross(force);
  }
  if (press.contacts > 0) press.point_O /= press.contacts;
  const double drive = press.force_O.dot(along);
  if (drive > 0.0) {
    press.force_O /= drive;
    press.torque_O /= drive;
  }
  return press;
}

// Mean moment of inertia of the object for 1 kg about axes through a point [m^2]. The mean, because
// with each axis its own a slender object would spin about its length instead of turning until the
// fingers lie on it. An object without a mass resists as if it lay at its farthest point.
double mean_inertia(const CompiledScene& scene, const Vector3& p_O) {
  const GraspableBody& object = scene.scene.object;
  const double far = 1.0 / scene.wrench_frame.torque_scale;
  if (!(object.mass > 0.0)) return far * far;
  return object.inertia.trace() / object.mass / 3.0 +
         2.0 / 3.0 * (object.center_of_mass - p_O).squaredNorm();
}

}  // namespace

Pose after(const ObjectMotion& motion, const Pose& X_OH) {
  const double angle = motion.angular_O.norm();
  const Vector3 axis_O = angle > 0.0 ? Vector3(motion.angular_O / angle) : Vector3::UnitZ();
  return translation(motion.center_O) * Eigen::AngleAxisd(-angle, axis_O) *
         translation(-motion.center_O - motion.linear_O) * X_OH;
}

std::optional<ObjectMotion> squeezed(const CompiledScene& scene, const FingerPair& fingers,
                                     const Trial& trial, const SqueezeLimits& limits) {
  const Vector3 opening_O =
      trial.X_OH.linear() * opening_axis(scene.scene.hand, fingers, trial.joints);
  const Press first = press(scene, trial, fingers.first, -opening_O);
  const Press second = press(scene, trial, fingers.second, opening_O);
  if (first.contacts == 0 || second.contacts == 0) return std::nullopt;
  ObjectMotion motion;
  motion.center_O = 0.5 * (first.point_O + second.point_O);
  motion.linear_O = first.force_O + second.force_O;
  const Vector3 couple = first.torque_O + second.torque_O - motion.center_O.cross(motion.linear_O);
  if (motion.linear_O.norm() < limits.least_force && couple.norm() < limits.least_arm) {
    return std::nullopt;
  }
  motion.angular_O = couple / mean_inertia(scene, motion.center_O);
  const double slide = std::max(motion.at(first.point_O).norm(), motion.at(second.point_O).norm());
  const double angle = motion.angular_O.norm();
  // Not both are zero: the forces do not balance.
  const double size = std::max(slide / limits.slide, angle / limits.angle);
  if (!(size > 0.0)) return std::nullopt;
  motion.linear_O /= size;
  motion.angular_O /= size;
  return motion;
}

}  // namespace prehend
