#include "sim/motion/robot_dynamics.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/robot/files/platform_file.h"
#include "sim/robot/files/robot_file.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

constexpr double kGravity = 9.81;

// A rod of point masses: joints about z one after the other, each with a mass at the end of a link.
Robot rods(const std::vector<double>& lengths, const std::vector<double>& masses) {
  Robot robot;
  robot.name = "rods";
  robot.links.emplace_back();
  for (std::size_t k = 0; k < lengths.size(); ++k) {
    Joint joint{.name = "joint" + std::to_string(k), .dof = static_cast<int>(k)};
    joint.parent = static_cast<int>(k) - 1;
    if (k > 0) joint.X_PJ = translation({lengths[k - 1], 0.0, 0.0});
    robot.joints.push_back(joint);
    robot.dofs.push_back({.name = joint.name});
    Link link;
    link.name = "link" + std::to_string(k);
    link.joint = static_cast<int>(k);
    link.inertial = {masses[k], {lengths[k], 0.0, 0.0}, Matrix3::Zero()};
    robot.links.push_back(link);
  }
  robot.chains.push_back({"rods", 0, static_cast<int>(lengths.size())});
  return robot;
}

JointVector random_vector(Random& random, Eigen::Index size, double most) {
  JointVector values(size);
  for (double& value : values) value = random.uniform(-most, most);
  return values;
}

JointVector random_values(Random& random, const Robot& robot) {
  JointVector values(static_cast<Eigen::Index>(robot.joints.size()));
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Joint& joint = robot.joints[j];
    values[static_cast<Eigen::Index>(j)] =
        random.uniform(std::max(joint.lower, -3.0), std::min(joint.upper, 3.0));
  }
  return values;
}

RobotSurroundings random_surroundings(Random& random, Eigen::Index joints) {
  RobotSurroundings around;
  around.gravity_B = random_vector(random, 3, kGravity);
  around.base_velocity = random_vector(random, 6, 1.0);
  around.base_acceleration = random_vector(random, 6, 1.0);
  for (Eigen::Index j = 0; j < joints; ++j) {
    around.forces_A.emplace_back(random_vector(random, 6, 1.0));
  }
  return around;
}

std::vector<Robot> library() {
  std::vector<Robot> robots;
  for (const std::string& name : library_robot_names()) robots.push_back(find_robot(name));
  for (const std::string& name : library_platform_names()) {
    robots.push_back(assemble(find_platform(name)).robot);
  }
  return robots;
}

TEST(RobotDynamics, PendulumNeedsTheMomentOfItsWeight) {
  const double length = 0.7;
  const double mass = 1.3;
  const RobotDynamics dynamics(rods({length}, {mass}));
  RobotSurroundings around;
  around.gravity_B = {0.0, -kGravity, 0.0};
  for (const double angle : {-2.0, 0.0, 0.4, 1.5}) {
    const JointVector q = JointVector::Constant(1, angle);
    const JointVector v = JointVector::Constant(1, 3.0);
    const JointVector a = JointVector::Constant(1, 0.5);
    EXPECT_NEAR(dynamics.inverse(q, v, a, around)[0],
                mass * length * length * 0.5 + mass * kGravity * length * std::cos(angle), 1e-12);
  }
}

// Lagrange's equations of the double pendulum, point masses at the ends of its rods.
TEST(RobotDynamics, DoublePendulumFollowsLagrange) {
  const double l1 = 0.5;
  const double l2 = 0.3;
  const double m1 = 1.1;
  const double m2 = 0.7;
  const RobotDynamics dynamics(rods({l1, l2}, {m1, m2}));
  RobotSurroundings around;
  around.gravity_B = {0.0, -kGravity, 0.0};
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    const JointVector q = random_vector(random, 2, 3.0);
    const JointVector v = random_vector(random, 2, 5.0);
    const double c2 = std::cos(q[1]);
    const double s2 = std::sin(q[1]);
    Eigen::Matrix2d mass;
    mass(1, 1) = m2 * l2 * l2;
    mass(0, 1) = mass(1, 0) = mass(1, 1) + m2 * l1 * l2 * c2;
    mass(0, 0) = m1 * l1 * l1 + m2 * (l1 * l1 + l2 * l2 + 2.0 * l1 * l2 * c2);
    const double h = m2 * l1 * l2 * s2;
    const double hang2 = m2 * kGravity * l2 * std::cos(q[0] + q[1]);
    const Eigen::Vector2d bias(
        -h * v[1] * (2.0 * v[0] + v[1]) + (m1 + m2) * kGravity * l1 * std::cos(q[0]) + hang2,
        h * v[0] * v[0] + hang2);
    EXPECT_LT((dynamics.mass_matrix(q) - mass).norm(), 1e-12);
    EXPECT_LT((dynamics.bias(q, v, around) - bias).norm(), 1e-12);
  }
}

// Three ways to the same equation, which share nothing but the inertias.
TEST(RobotDynamics, InverseAndForwardAgreeOnEveryRobotOfTheLibrary) {
  for (const Robot& robot : library()) {
    const RobotDynamics dynamics(robot);
    Random random(17);
    for (int i = 0; i < 1000; ++i) {
      const JointVector q = random_values(random, robot);
      const JointVector v = random_vector(random, dynamics.joints(), 3.0);
      const JointVector a = random_vector(random, dynamics.joints(), 10.0);
      const RobotSurroundings around = random_surroundings(random, dynamics.joints());
      const JointVector effort = dynamics.inverse(q, v, a, around);
      const JointVector again = dynamics.forward(q, v, effort, around);
      EXPECT_LE((again - a).norm(), 1e-9 * a.norm()) << robot.name;
      const JointVector sum = dynamics.mass_matrix(q) * a + dynamics.bias(q, v, around);
      EXPECT_LT((sum - effort).norm(), 1e-12 * (1.0 + effort.norm())) << robot.name;
    }
  }
}

TEST(RobotDynamics, MassMatrixIsThatOfTheKineticEnergy) {
  for (const Robot& robot : library()) {
    const RobotDynamics dynamics(robot);
    Random random(5);
    const JointVector q = random_values(random, robot);
    const JointVector v = random_vector(random, dynamics.joints(), 2.0);
    const Eigen::MatrixXd mass = dynamics.mass_matrix(q);
    EXPECT_EQ(mass, mass.transpose()) << robot.name;
    EXPECT_EQ(Eigen::LLT<Eigen::MatrixXd>(mass).info(), Eigen::Success) << robot.name;
    const double energy = dynamics.kinetic_energy(q, v);
    EXPECT_NEAR(0.5 * v.dot(mass * v), energy, 1e-12 * energy) << robot.name;
  }
}

// The work of the efforts goes into kinetic energy: its rate along the motion, by differences.
TEST(RobotDynamics, PowerBecomesKineticEnergy) {
  const Robot robot = find_robot("puma560");
  const RobotDynamics dynamics(robot);
  Random random(11);
  for (int i = 0; i < 20; ++i) {
    const JointVector q = random_values(random, robot);
    const JointVector v = random_vector(random, dynamics.joints(), 1.0);
    const JointVector a = random_vector(random, dynamics.joints(), 5.0);
    const JointVector effort = dynamics.inverse(q, v, a);
    constexpr double h = 1e-5;
    const auto energy = [&](double t) {
      return dynamics.kinetic_energy(q + t * v + 0.5 * t * t * a, v + t * a);
    };
    const double rate = (energy(h) - energy(-h)) / (2.0 * h);
    EXPECT_NEAR(rate, effort.dot(v), 1e-6 * (1.0 + std::abs(rate)));
  }
}

TEST(RobotDynamics, CoupledJointsMoveInTheirRatios) {
  const Robot robot = find_robot("barrett");
  const Eigen::MatrixXd coupling = coupling_matrix(robot);
  std::vector<double> dofs = initial_dofs(robot);
  const std::vector<double> before = joint_values(robot, dofs);
  Random random(2);
  JointVector step(static_cast<Eigen::Index>(dofs.size()));
  for (std::size_t d = 0; d < dofs.size(); ++d) {
    step[static_cast<Eigen::Index>(d)] = random.uniform(-0.1, 0.1);
    dofs[d] += step[static_cast<Eigen::Index>(d)];
  }
  const std::vector<double> after = joint_values(robot, dofs);
  const JointVector moved = coupling * step;
  for (std::size_t j = 0; j < after.size(); ++j) {
    EXPECT_NEAR(after[j] - before[j], moved[static_cast<Eigen::Index>(j)], 1e-15);
  }
}

TEST(RobotDynamics, AJointThatMovesNoMassIsRefused) {
  const InputError refusal = test::refusal_of([] { RobotDynamics(rods({1.0, 1.0}, {1.0, 0.0})); });
  EXPECT_EQ(refusal.field(), "joint joint1");
}

}  // namespace
}  // namespace prehend
