// What is true of balancing forces and of proofs that there are none, from the definitions.
#pragma once

#include <cmath>
#include <span>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sim/quality/forces.h"

namespace prehend::test {

inline Wrench wrench_of(double fx, double fy, double fz, double tx = 0, double ty = 0,
                        double tz = 0) {
  return (Wrench() << fx, fy, fz, tx, ty, tz).finished();
}

inline double largest_tangential(const Contact& contact, double normal_force) {
  return contact.model == ContactModel::frictionless ? 0.0 : contact.friction * normal_force;
}

// The lowest power of the wrenches of a contact's forces of unit normal force with u: the exact
// cone, or (pyramid) anything inside it.
inline double lowest_power(const Contact& contact, const WrenchFrame& frame, const Wrench& u) {
  const Eigen::Vector3d arm = contact.position - frame.torque_origin;
  const Eigen::Vector3d torque = frame.torque_scale * u.tail<3>();
  const Eigen::Vector3d velocity = u.head<3>() + torque.cross(arm);
  const double along = velocity.dot(contact.normal);
  const double across = (velocity - along * contact.normal).norm();
  const double twist = contact.model == ContactModel::soft_finger
                           ? contact.torsion * torque.dot(contact.normal)
                           : 0.0;
  return along - largest_tangential(contact, 1.0) * std::hypot(across, twist);
}

// The forces balance the wrench within `residual` of it, from inside the cones.
inline void expect_balanced(std::span<const Contact> contacts, const WrenchFrame& frame,
                            const Wrench& external, const ContactForces& forces,
                            double residual = 1e-8) {
  ASSERT_EQ(forces.outcome, ForceOutcome::balanced)
      << "residual " << forces.residual << ", gap " << forces.gap;
  Wrench sum = external;
  double largest = 0.0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact& contact = contacts[i];
    const auto column = static_cast<Eigen::Index>(i);
    const Eigen::Vector3d force = forces.forces.col(column);
    const double torsion = forces.components(3, column);
    const double normal = force.dot(contact.normal);
    largest = std::max(largest, normal);
    sum.head<3>() += force;
    sum.tail<3>() += frame.torque_scale * ((contact.position - frame.torque_origin).cross(force) +
                                           torsion * contact.normal);
    // Rounding of the axes and of the projection on them.
    const double slack = 1e-14 * forces.largest_normal;
    EXPECT_GE(normal, -slack);
    const bool twists = contact.model == ContactModel::soft_finger && contact.torsion > 0.0;
    const double twist = twists ? torsion / contact.torsion : 0.0;
    EXPECT_TRUE(twists || torsion == 0.0);
    EXPECT_LE(std::hypot((force - normal * contact.normal).norm(), twist),
              largest_tangential(contact, normal) + slack);
    EXPECT_NEAR(forces.components(0, column), normal, slack);
  }
  EXPECT_NEAR(forces.largest_normal, largest, 1e-14 * largest);
  EXPECT_LE(sum.norm(), residual * external.norm());
  EXPECT_LE(forces.gap, 1e-6);
}

// The separating wrench proves that the contacts cannot balance the external one: not with normal
// forces below 1e10 times it.
inline void expect_separated(std::span<const Contact> contacts, const WrenchFrame& frame,
                             const Wrench& external, const ContactForces& forces) {
  ASSERT_EQ(forces.outcome, ForceOutcome::impossible);
  EXPECT_NEAR(forces.separating.norm(), 1.0, 1e-14);
  const double power = forces.separating.dot(external.normalized());
  EXPECT_GT(power, 0.0);
  for (const Contact& contact : contacts) {
    EXPECT_GE(lowest_power(contact, frame, forces.separating), -power / kLargestForce);
  }
  EXPECT_EQ(forces.components.cwiseAbs().sum(), 0.0);
}

}  // namespace prehend::test
