#include "sim/motion/joint_springs.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/motion/energy.h"
#include "sim/motion/step_world.h"
#include "sim/motion/world.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

constexpr double kMass = 0.5;     // [kg]
constexpr double kArm = 0.2;      // of the centre of mass from the joint [m]
constexpr double kEarth = 9.81;   // [m/s^2]
constexpr double kFinest = 1e-3;  // [s]

// A cube on a joint: one that slides up, or one about y from which it hangs by kArm.
Robot sprung(JointType type, const JointSpring& spring) {
  Robot robot;
  robot.name = "sprung";
  Joint joint{.name = "spring", .type = type};
  if (type == JointType::revolute) joint.axis = Vector3::UnitY();
  joint.lower = -10.0;
  joint.upper = 10.0;
  joint.spring = spring;
  robot.joints = {joint};
  robot.dofs = {{.name = "spring", .lower = -10.0, .upper = 10.0}};
  Link base;
  base.name = "base";
  base.material = "metal";
  base.mesh = make_box(Vector3::Constant(0.01));
  Link cube = base;
  cube.name = "cube";
  cube.joint = 0;
  const double down = type == JointType::revolute ? kArm : 0.0;
  for (Vector3& p : cube.mesh.vertices) p.z() -= down;
  cube.inertial = inertial_of_mass(cube.mesh, kMass);
  robot.links = {base, cube};
  robot.exempt_pairs = {{0, 1}};
  robot.chains = {{"arm", 0, 1}};
  return robot;
}

World world_of(const Robot& robot, double value) {
  World world;
  world.robots.push_back(
      make_world_robot("sprung", std::make_shared<const RobotModel>(make_robot_model(robot)),
                       Pose::Identity(), {value}));
  return world;
}

void run_for(World& world, double seconds, double step) {
  const auto steps = static_cast<int>(std::lround(seconds / step));
  for (int i = 0; i < steps; ++i) {
    ASSERT_EQ(step_world(world, {.step = step}).outcome, StepOutcome::moved);
  }
}

// A weight on a spring swings about where the two balance, as x = a cos(w t), w^2 = k / m. Steps h
// that take the spring as it is in their middle do so as a cos(2 n atan(h w / 2)).
TEST(JointSprings, AWeightSwingsWithThePeriodOfItsSpring) {
  const JointSpring spring{.stiffness = 80.0, .rest = 0.1};
  const double w = std::sqrt(spring.stiffness / kMass);
  const double balanced = spring.rest - kMass * kEarth / spring.stiffness;
  World world = world_of(sprung(JointType::prismatic, spring), balanced + 0.05);
  double last = 0.05;
  std::vector<double> falls;  // times at which it passes the middle on its way down
  for (int n = 1; n <= 2000; ++n) {
    ASSERT_EQ(step_world(world, {.step = kFinest}).outcome, StepOutcome::moved);
    const double off = world.robots[0].x[0] - balanced;
    const double hw = kFinest * w;
    EXPECT_NEAR(off, 0.05 * std::cos(2.0 * n * std::atan(0.5 * hw)), 1e-12);
    if (last > 0.0 && off <= 0.0) falls.push_back((n - off / (off - last)) * kFinest);
    last = off;
  }
  ASSERT_GE(falls.size(), 3U);
  const double period = (falls.back() - falls.front()) / static_cast<double>(falls.size() - 1);
  EXPECT_NEAR(period, 2.0 * std::acos(-1.0) / w, 1e-4 * period);
}

TEST(JointSprings, APendulumSettlesWhereItsSpringBalancesTheWeight) {
  Robot robot = sprung(JointType::revolute, {.stiffness = 2.0, .rest = 1.2});
  robot.joints[0].friction.viscous = 0.3;
  World world = world_of(robot, 0.0);
  run_for(world, 8.0, 2.5e-3);
  const double at = world.robots[0].x[0];
  EXPECT_NEAR(2.0 * (1.2 - at), kMass * kEarth * kArm * std::sin(at), 1e-9);
}

// A relaxed spring that nothing else can stretch keeps the joint where it is, however stiff.
TEST(JointSprings, NoStiffnessIsTooMuch) {
  World world = world_of(sprung(JointType::prismatic, {.stiffness = 1e12, .rest = 0.2}), 0.2);
  run_for(world, 1.0, 2.5e-3);
  EXPECT_NEAR(world.robots[0].x[0], 0.2, 1e-9);
}

TEST(JointSprings, TheirEnergyIsThatOfTheStretch) {
  const JointSpring spring{.stiffness = 80.0, .rest = 0.1};
  World world = world_of(sprung(JointType::prismatic, spring), 0.4);
  const double weight = kMass * kEarth * 0.4;
  EXPECT_NEAR(energy_of(world), weight + 0.5 * 80.0 * 0.3 * 0.3, 1e-12);
  EXPECT_NEAR(spring_efforts(world.robots[0].model->robot, world.robots[0].x)[0], -24.0, 1e-12);
}

// Coupled joints add their springs: of two joints at the ratio -1, relaxed at opposite values.
TEST(JointSprings, CoupledJointsShareTheirSprings) {
  Robot robot = sprung(JointType::prismatic, {.stiffness = 30.0, .rest = 0.2});
  Joint other = robot.joints[0];
  other.name = "other";
  other.ratio = -1.0;
  other.spring = {.stiffness = 10.0, .rest = -0.6};
  robot.joints.push_back(other);
  robot.joints[1].chain = 1;
  robot.chains.push_back({"second", 1, 1});
  Link cube = robot.links[1];
  cube.name = "second cube";
  cube.joint = 1;
  for (Vector3& p : cube.mesh.vertices) p.x() += 1.0;
  cube.inertial.center_of_mass.x() += 1.0;
  robot.links.push_back(cube);
  for (Joint& joint : robot.joints) joint.friction.viscous = 5.0;
  World world = world_of(robot, 0.0);
  run_for(world, 10.0, 2.5e-3);
  // The weights balance each other.
  EXPECT_NEAR(world.robots[0].x[0], (30.0 * 0.2 + 10.0 * 0.6) / 40.0, 1e-9);
}

}  // namespace
}  // namespace prehend
