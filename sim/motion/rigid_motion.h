// The motion of a rigid body, in world axes.
#pragma once

#include "sim/base/pose.h"
#include "sim/robot/inertial.h"

namespace prehend {

// Where a body is and how it moves.
struct RigidMotion {
  Pose X_WB = Pose::Identity();
  Vector3 angular = Vector3::Zero();  // velocity, world axes [rad/s]
  Vector3 linear = Vector3::Zero();   // of the centre of mass, world axes [m/s]
};

// The centre of mass in the world.
Vector3 center_in_world(const Inertial& inertial, const Pose& X_WB);

// The inertia about the centre of mass in world axes.
Matrix3 inertia_in_world(const Inertial& inertial, const Pose& X_WB);

// The body at pose X_WB, moved for a time with its velocities held: it turns about its centre of
// mass.
Pose carried(const Inertial& inertial, const RigidMotion& motion, double time);

// The mean angular velocity of a body that turns freely for `time`: with it, carried() keeps the
// angular momentum exactly and the energy to second order, with an error that does not grow: turns
// about the principal axes one after the other, in parts of the step that turn little each (a
// symplectic splitting; Hairer, Lubich and Wanner 2006, Geometric Numerical Integration, section
// VII.5). `momentum`: about the centre of mass, world axes [N m s]. `time` > 0.
Vector3 free_angular_velocity(const Inertial& inertial, const Pose& X_WB, const Vector3& momentum,
                              double time);

// 1/2 m v^2 and the part of the rotation [J].
double kinetic_energy(const Inertial& inertial, const RigidMotion& motion);

}  // namespace prehend
