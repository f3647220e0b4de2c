// Whether two robots are the same.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "sim/robot/robot.h"

namespace prehend::test {

// Rounding of unit vectors that are made unit again.
inline constexpr double kUnitAgain = 1e-15;

inline void expect_same_pose(const Pose& a, const Pose& b, const std::string& what) {
  EXPECT_EQ((a.matrix() - b.matrix()).cwiseAbs().maxCoeff(), 0.0) << what;
}

inline void expect_same_joint(const Joint& a, const Joint& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.driver_name, b.driver_name) << a.name;
  EXPECT_EQ(a.type, b.type) << a.name;
  expect_same_pose(a.X_PJ, b.X_PJ, a.name);
  expect_same_pose(a.X_JA, b.X_JA, a.name);
  EXPECT_LE((a.axis - b.axis).norm(), kUnitAgain) << a.name;
  EXPECT_EQ(a.zero, b.zero) << a.name;
  EXPECT_EQ(a.lower, b.lower) << a.name;
  EXPECT_EQ(a.upper, b.upper) << a.name;
  EXPECT_EQ(a.dof, b.dof) << a.name;
  EXPECT_EQ(a.ratio, b.ratio) << a.name;
  EXPECT_EQ(a.across, b.across) << a.name;
  EXPECT_EQ(a.ahead, b.ahead) << a.name;
  EXPECT_EQ(a.offset, b.offset) << a.name;
  EXPECT_EQ(a.parent, b.parent) << a.name;
  EXPECT_EQ(a.chain, b.chain) << a.name;
  EXPECT_EQ(a.max_effort, b.max_effort) << a.name;
  EXPECT_EQ(a.friction.coulomb, b.friction.coulomb) << a.name;
  EXPECT_EQ(a.friction.viscous, b.friction.viscous) << a.name;
  EXPECT_EQ(a.spring.stiffness, b.spring.stiffness) << a.name;
  EXPECT_EQ(a.spring.rest, b.spring.rest) << a.name;
}

inline void expect_same_dof(const DegreeOfFreedom& a, const DegreeOfFreedom& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.lower, b.lower) << a.name;
  EXPECT_EQ(a.upper, b.upper) << a.name;
  EXPECT_EQ(a.initial, b.initial) << a.name;
  EXPECT_EQ(a.closing_velocity, b.closing_velocity) << a.name;
  EXPECT_EQ(a.max_velocity, b.max_velocity) << a.name;
  EXPECT_EQ(a.max_acceleration, b.max_acceleration) << a.name;
  EXPECT_EQ(a.coupling, b.coupling) << a.name;
  EXPECT_EQ(a.breakaway_effort, b.breakaway_effort) << a.name;
  EXPECT_EQ(a.stiffness, b.stiffness) << a.name;
  EXPECT_EQ(a.damping, b.damping) << a.name;
}

inline void expect_same_link(const Link& a, const Link& b) {
  EXPECT_TRUE(a.pad == b.pad) << a.name;
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.material, b.material) << a.name;
  EXPECT_EQ(a.joint, b.joint) << a.name;
  EXPECT_EQ(a.mesh.vertices, b.mesh.vertices) << a.name;
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles) << a.name;
  EXPECT_EQ(a.inertial.mass, b.inertial.mass) << a.name;
  EXPECT_EQ(a.inertial.center_of_mass, b.inertial.center_of_mass) << a.name;
  const double largest = a.inertial.inertia.cwiseAbs().maxCoeff();
  EXPECT_LE((a.inertial.inertia - b.inertial.inertia).norm(), kUnitAgain * largest) << a.name;
}

inline void expect_same_frames(const Robot& a, const Robot& b) {
  ASSERT_EQ(a.frames.size(), b.frames.size());
  for (std::size_t f = 0; f < a.frames.size(); ++f) {
    EXPECT_EQ(a.frames[f].name, b.frames[f].name);
    EXPECT_EQ(a.frames[f].role, b.frames[f].role) << a.frames[f].name;
    EXPECT_EQ(a.frames[f].joint, b.frames[f].joint) << a.frames[f].name;
    expect_same_pose(a.frames[f].X_AF, b.frames[f].X_AF, a.frames[f].name);
  }
}

inline void expect_same_hand(const Robot& a, const Robot& b) {
  ASSERT_EQ(a.hand.has_value(), b.hand.has_value());
  if (!a.hand) return;
  EXPECT_LE((a.hand->approach - b.hand->approach).norm(), kUnitAgain);
  EXPECT_LE((a.hand->closing - b.hand->closing).norm(), kUnitAgain);
  EXPECT_EQ(a.hand->origin, b.hand->origin);
  ASSERT_EQ(a.hand->preshapes.size(), b.hand->preshapes.size());
  for (std::size_t p = 0; p < a.hand->preshapes.size(); ++p) {
    const Preshape& one = a.hand->preshapes[p];
    const Preshape& other = b.hand->preshapes[p];
    EXPECT_EQ(one.name, other.name);
    EXPECT_EQ(one.dofs, other.dofs) << one.name;
    EXPECT_EQ(one.min_width, other.min_width) << one.name;
    EXPECT_EQ(one.max_width, other.max_width) << one.name;
    EXPECT_EQ(one.depth, other.depth) << one.name;
  }
  ASSERT_EQ(a.hand->strategies.size(), b.hand->strategies.size());
  for (std::size_t s = 0; s < a.hand->strategies.size(); ++s) {
    const ClosingStrategy& one = a.hand->strategies[s];
    const ClosingStrategy& other = b.hand->strategies[s];
    EXPECT_EQ(one.name, other.name);
    EXPECT_EQ(one.first, other.first) << one.name;
    EXPECT_EQ(one.waits, other.waits) << one.name;
    EXPECT_EQ(one.effort, other.effort) << one.name;
  }
}

// All but the notes.
inline void expect_same_robot(const Robot& a, const Robot& b) {
  SCOPED_TRACE(a.name);
  EXPECT_EQ(a.name, b.name);
  ASSERT_EQ(a.chains.size(), b.chains.size());
  for (std::size_t c = 0; c < a.chains.size(); ++c) {
    EXPECT_EQ(a.chains[c].name, b.chains[c].name);
    EXPECT_EQ(a.chains[c].first_joint, b.chains[c].first_joint);
    EXPECT_EQ(a.chains[c].joint_count, b.chains[c].joint_count);
    EXPECT_EQ(a.chains[c].closed_form, b.chains[c].closed_form);
  }
  ASSERT_EQ(a.joints.size(), b.joints.size());
  for (std::size_t j = 0; j < a.joints.size(); ++j) expect_same_joint(a.joints[j], b.joints[j]);
  ASSERT_EQ(a.dofs.size(), b.dofs.size());
  for (std::size_t d = 0; d < a.dofs.size(); ++d) expect_same_dof(a.dofs[d], b.dofs[d]);
  ASSERT_EQ(a.links.size(), b.links.size());
  for (std::size_t l = 0; l < a.links.size(); ++l) expect_same_link(a.links[l], b.links[l]);
  EXPECT_EQ(a.exempt_pairs, b.exempt_pairs);
  expect_same_frames(a, b);
  expect_same_hand(a, b);
}

}  // namespace prehend::test
