// What acts on bodies and joints besides gravity and contacts at rest, one closed form each.
#include <cmath>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "sim/base/random.h"
#include "sim/motion/energy.h"
#include "sim/motion/island.h"
#include "sim/motion/robot_dynamics.h"
#include "sim/motion/world.h"
#include "sim/robot/files/robot_file.h"
#include "tests/support/sample_worlds.h"

namespace prehend {
namespace {

using test::box;
using test::ground;
using test::kG;
using test::world_with;

World on_plate(std::vector<WorldBody> bodies, double friction) {
  bodies.insert(bodies.begin(), ground());
  return world_with(std::move(bodies), friction);
}

TEST(Laws, AForceAcceleratesABody) {
  World world = world_with({box("box", {0.1, 0.1, 0.1}, 2.0, Vector3::Zero())}, 0.5);
  world.gravity.setZero();
  world.bodies[0].force_W = {3.0, -1.0, 0.5};
  ASSERT_EQ(test::run(world, 0.5), StepOutcome::moved);
  EXPECT_LT((world.bodies[0].motion.linear - 0.25 * Vector3(3.0, -1.0, 0.5)).norm(), 1e-13);
}

// What starts to slide goes on with the smaller coefficient: it holds up to the static one, and
// stops after v^2 / (2 mu_k g).
TEST(Laws, SlidingBodiesHaveKineticFriction) {
  World world = on_plate({box("box", {0.1, 0.1, 0.04}, 1.0, {-1.0, 0.0, 0.02005})}, 0.5);
  world.laws.kinetic = world.laws.friction;
  world.laws.kinetic->set(Material::plastic, Material::plastic, 0.2);
  ASSERT_EQ(test::run(world, 0.05), StepOutcome::moved);
  World pulled = world;
  for (const double part : {0.98, 1.02}) {
    pulled.bodies[1].force_W = {part * 0.5 * kG, 0.0, 0.0};
    ASSERT_EQ(test::run(pulled, 0.2), StepOutcome::moved);
    const double speed = pulled.bodies[1].motion.linear.x();
    // Until it slides at 1 mm/s, within 5 steps, it has the static coefficient.
    const double expected = part < 1.0 ? 0.0 : (part * 0.5 - 0.2) * kG * 0.2;
    EXPECT_NEAR(speed, expected, part < 1.0 ? 1e-9 : 5.0 * 2.5e-3 * 0.3 * kG) << part;
  }
  world.bodies[1].motion.linear = {1.2, 0.0, 0.0};
  const double start = world.bodies[1].motion.X_WB.translation().x();
  ASSERT_EQ(test::run(world, 1.0, {.step = 2.5e-4}), StepOutcome::moved);
  const double way = world.bodies[1].motion.X_WB.translation().x() - start;
  EXPECT_NEAR(way, 1.2 * 1.2 / (2.0 * 0.2 * kG), 2e-3 * way);
}

// A rubber ball that spins on a point is slowed by mu m g times the lever arm of its contact.
TEST(Laws, SoftContactsResistSpin) {
  World world =
      on_plate({test::body_of("ball", make_sphere(0.05, 3), 1.0, {0.0, 0.0, 0.0501})}, 0.5);
  WorldBody& ball = world.bodies[1];
  ball.material = Material::rubber;
  world.laws.friction.set(Material::rubber, Material::plastic, 0.8);
  ASSERT_EQ(test::run(world, 0.3), StepOutcome::moved);
  ball.motion.angular = {0.0, 0.0, 10.0};
  ASSERT_EQ(test::run(world, 0.1), StepOutcome::moved);
  // Hertz on a pad of 30 mm: 3 pi / 16 of the radius of contact.
  const double depth = world.laws.compliant_depths.between(Material::rubber, Material::plastic);
  const double arm = 3.0 * std::acos(-1.0) / 16.0 * std::sqrt(0.03 * depth);
  const double inertia = ball.inertial.inertia(2, 2);
  EXPECT_NEAR(10.0 - ball.motion.angular.z(), 0.8 * kG * arm * 0.1 / inertia, 0.02 * 10.0);
  EXPECT_GT(10.0 - ball.motion.angular.z(), 0.5);
}

// A disc of 24 sides, its lower face triangulated in one of several ways.
TriangleMesh disc(double radius, double height, int kind) {
  constexpr int kSides = 24;
  const auto on_rim = [](int k) { return k % kSides; };
  TriangleMesh mesh;
  for (const double z : {-0.5 * height, 0.5 * height}) {
    for (int k = 0; k < kSides; ++k) {
      const double angle = 2.0 * std::acos(-1.0) * k / kSides;
      mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  }
  for (int k = 0; k < kSides; ++k) {
    mesh.triangles.push_back({on_rim(k), on_rim(k + 1), kSides + on_rim(k + 1)});
    mesh.triangles.push_back({on_rim(k), kSides + on_rim(k + 1), kSides + on_rim(k)});
  }
  for (int k = 1; k + 1 < kSides; ++k)
    mesh.triangles.push_back({kSides, kSides + k, kSides + k + 1});
  if (kind == 0) {  // from a vertex of the rim
    for (int k = 1; k + 1 < kSides; ++k) mesh.triangles.push_back({0, k + 1, k});
    return mesh;
  }
  // Around a vertex inside, in the middle or beside it, or around a ring of them.
  const auto middle = static_cast<int>(mesh.vertices.size());
  mesh.vertices.emplace_back(kind == 2 ? 0.4 * radius : 0.0, 0.0, -0.5 * height);
  if (kind < 3) {
    for (int k = 0; k < kSides; ++k) mesh.triangles.push_back({middle, on_rim(k + 1), on_rim(k)});
    return mesh;
  }
  for (int k = 0; k < kSides; ++k) {
    mesh.vertices.push_back(0.5 * (mesh.vertices[index(k)] + mesh.vertices[index(middle)]));
  }
  for (int k = 0; k < kSides; ++k) {
    const int here = middle + 1 + k;
    const int next = middle + 1 + on_rim(k + 1);
    mesh.triangles.push_back({middle, next, here});
    mesh.triangles.push_back({here, next, on_rim(k + 1)});
    mesh.triangles.push_back({here, on_rim(k + 1), on_rim(k)});
  }
  return mesh;
}

// A disc that spins on a floor stops after R w / (2 mu g) where its rim bears the weight, and after
// half as long again where it presses evenly: whatever the triangles of its face.
TEST(Laws, ADiscStopsByItsFriction) {
  constexpr double kRadius = 0.05;
  constexpr double kSpin = 16.7;  // [rad/s]
  for (int kind = 0; kind < 4; ++kind) {
    const TriangleMesh mesh = disc(kRadius, 0.02, kind);
    World world = on_plate({test::body_of("disc", mesh, 0.4, {0.0, 0.0, 0.01005})}, 0.5);
    ASSERT_EQ(test::run(world, 0.05), StepOutcome::moved);
    world.bodies[1].motion.angular = {0.0, 0.0, kSpin};
    double time = 0.0;
    while (world.bodies[1].motion.angular.norm() > 1e-6 && time < 1.0) {
      time += step_world(world, {.step = 5e-4}).time;
    }
    const double rim = kRadius * kSpin / (2.0 * 0.5 * kG);
    EXPECT_GE(time, 0.99 * rim) << kind;
    EXPECT_LE(time, 1.5 * rim) << kind;
    RecordProperty(std::to_string(kind), std::to_string(time));
  }
}

// A plate between two round pads, its weight 20 mm beside them: friction of 10 N bears 1 N, and
// that of the rims bears seven times the moment. One pad stands still, the other one is so heavy
// that it does not move in the time, and floats.
TEST(Laws, RoundPadsKeepAPlateLevel) {
  constexpr double kPress = 10.0;  // [N]
  constexpr double kHeavy = 1e5;   // [kg]
  for (int kind = 0; kind < 4; ++kind) {
    std::vector<WorldBody> bodies = {box("plate", {0.2, 0.01, 0.05}, 0.1, Vector3::Zero())};
    for (const double side : {-1.0, 1.0}) {
      const Matrix3 turned =
          Eigen::AngleAxisd(-side * 0.5 * std::acos(-1.0), Vector3::UnitX()).toRotationMatrix();
      bodies.push_back(test::body_of("pad", disc(0.015, 0.02, kind), kHeavy, Vector3::Zero()));
      bodies.back().motion.X_WB = pose_from(turned, Vector3(-0.02, side * 0.01505, 0.0));
    }
    World world = world_with(std::move(bodies), 0.5);
    world.bodies[1].is_fixed = true;
    world.bodies[2].force_W = Vector3(0.0, -kPress, kHeavy * kG);
    ASSERT_EQ(test::run(world, 1.0), StepOutcome::moved);
    const Pose& X_WB = world.bodies[0].motion.X_WB;
    EXPECT_LT(Eigen::AngleAxisd(X_WB.linear()).angle(), 0.01) << kind;
    EXPECT_LT(X_WB.translation().norm(), 1e-3) << kind;
  }
}

// Dzhanibekov's body through 1e5 steps of the world.
TEST(Laws, AFreeBodyKeepsMomentumAndEnergyAndTurnsOver) {
  World world = world_with({box("book", {0.2, 0.12, 0.03}, 1.0, Vector3::Zero())}, 0.5);
  world.gravity.setZero();
  WorldBody& book = world.bodies[0];
  book.motion.angular = {1e-3, 8.0, 0.0};
  const auto momentum = [&] {
    return Vector3(inertia_in_world(book.inertial, book.motion.X_WB) * book.motion.angular);
  };
  const Vector3 start = momentum();
  const double energy = energy_of(world);
  int turns = 0;
  bool up = true;
  double most = 0.0;
  for (int i = 0; i < 100000; ++i) {
    ASSERT_EQ(step_world(world).outcome, StepOutcome::moved);
    most = std::max(most, std::abs(energy_of(world) - energy));
    const double along = (book.motion.X_WB.linear().transpose() * book.motion.angular).y();
    if (std::abs(along) > 4.0 && (along > 0.0) != up) {
      up = !up;
      ++turns;
    }
  }
  EXPECT_GT(turns, 50);
  EXPECT_LT((momentum() - start).norm(), 1e-10 * start.norm());
  EXPECT_LT(most, 1e-4 * energy);
  RecordProperty("energy", std::to_string(most / energy));
}

// A top without gravity precesses about its momentum at L / I_t.
TEST(Laws, ASymmetricTopPrecesses) {
  World world =
      world_with({test::body_of("top", make_cylinder(0.05, 0.02, 24), 1.0, {0, 0, 0})}, 0.5);
  world.gravity.setZero();
  WorldBody& top = world.bodies[0];
  top.motion.angular = {10.0, 0.0, 40.0};
  const Vector3 momentum = inertia_in_world(top.inertial, top.motion.X_WB) * top.motion.angular;
  const Vector3 axis = top.motion.X_WB.linear().col(2);
  ASSERT_EQ(test::run(world, 0.5), StepOutcome::moved);
  const double angle = 0.5 * momentum.norm() / top.inertial.inertia(0, 0);
  const Vector3 expected = Eigen::AngleAxisd(angle, momentum.normalized()) * axis;
  EXPECT_LT((top.motion.X_WB.linear().col(2) - expected).norm(), 1e-9);
}

// Domes of small height, with bumps: the lowest places are inside of others that are as near as
// contacts are. Their bottoms once rocked for ever from one choice of contacts to the next.
TEST(Laws, WhatStandsOnAnUnevenBottomComesToRest) {
  constexpr double kEdge = 0.1;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Random random(seed);
    TriangleMesh mesh = make_box(Vector3::Constant(kEdge), 12);
    for (Vector3& p : mesh.vertices) {
      if (p.z() > -0.5 * kEdge + 1e-9) continue;
      const double dome = 3e-4 * p.head<2>().squaredNorm() / (kEdge * kEdge);
      p.z() += dome + random.uniform(0.0, 5e-5);
    }
    World world = on_plate({test::body_of("box", mesh, 1.0, {0.0, 0.0, 0.5 * kEdge + 1e-3})}, 0.5);
    ASSERT_EQ(test::run(world, 2.5), StepOutcome::moved);
    EXPECT_TRUE(world.bodies[1].asleep) << seed;
  }
}

// The force on a body from another, upwards [N].
double force_up(const World& world, int on, int from) {
  double impulse = 0.0;
  for (const WorldContact& contact : world.contacts) {
    if (contact.a.index == on && contact.b.index == from) impulse += contact.impulse_W.z();
    if (contact.b.index == on && contact.a.index == from) impulse -= contact.impulse_W.z();
  }
  return impulse / world.last_step;
}

// Bodies that do not touch are solved apart; what rests sleeps until it is hit, and bears meanwhile
// what it bore.
TEST(Laws, IslandsAreApartAndSleepUntilTheyAreHit) {
  World world = on_plate({box("low", {0.1, 0.1, 0.1}, 1.0, {0.0, 0.0, 0.05005}),
                          box("high", {0.1, 0.1, 0.1}, 1.0, {0.0, 0.0, 0.1501}),
                          box("alone", {0.1, 0.1, 0.1}, 1.0, {1.0, 0.0, 0.05005}),
                          box("falls", {0.1, 0.1, 0.1}, 1.0, {1.0, 0.0, 3.0})},
                         0.5);
  ASSERT_EQ(test::run(world, 0.6), StepOutcome::moved);
  // The plate, the two that lie on each other, the one alone, the one that falls.
  const Solids solids(world);
  const std::vector<Island> islands = islands_of(solids, world.memory);
  ASSERT_EQ(islands.size(), 4U);
  EXPECT_EQ(islands[1].movers, (std::vector<int>{1, 2}));
  EXPECT_TRUE(world.bodies[1].asleep);
  EXPECT_TRUE(world.bodies[2].asleep);
  EXPECT_TRUE(world.bodies[3].asleep);
  EXPECT_FALSE(world.bodies[4].asleep);
  const Pose before = world.bodies[1].motion.X_WB;
  EXPECT_EQ(step_world(world, {.step = 1e-3}).newton_steps, 0);
  EXPECT_EQ(world.bodies[1].motion.X_WB.matrix(), before.matrix());
  EXPECT_NEAR(force_up(world, 1, 0), 2.0 * kG, 1e-3);
  EXPECT_NEAR(force_up(world, 2, 1), kG, 1e-3);
  // It lands on the one alone, which wakes; the others sleep on.
  double woke = -1.0;
  for (double time = 0.6; time < 1.0; time += step_world(world).time) {
    if (woke < 0.0 && !world.bodies[3].asleep) woke = time;
    EXPECT_TRUE(world.bodies[1].asleep && world.bodies[2].asleep);
  }
  EXPECT_NEAR(woke, std::sqrt(2.0 * (3.0 - 0.15) / kG), 0.01);
}

// The same world on many threads at once.
TEST(Laws, TheSameBytesOnAnyThread) {
  const auto end = [] {
    World world = on_plate({}, 0.5);
    for (int i = 0; i < 4; ++i) {
      world.bodies.push_back(box("box" + std::to_string(i), {0.1, 0.08, 0.06}, 1.0,
                                 {0.02 * i, 0.01 * i, 0.1 + 0.15 * i}));
    }
    EXPECT_EQ(test::run(world, 0.6), StepOutcome::moved);
    Eigen::MatrixXd poses(16, 4);
    for (int i = 0; i < 4; ++i) {
      poses.col(i) = world.bodies[static_cast<std::size_t>(i) + 1].motion.X_WB.matrix().reshaped();
    }
    return poses;
  };
  const Eigen::MatrixXd alone = end();
  std::vector<Eigen::MatrixXd> found(3);
  std::vector<std::thread> threads;
  for (Eigen::MatrixXd& poses : found) threads.emplace_back([&] { poses = end(); });
  for (std::thread& thread : threads) thread.join();
  for (const Eigen::MatrixXd& poses : found) EXPECT_EQ(poses, alone);
}

// Without gravity viscous friction slows a joint by c / I: backward Euler, step by step.
TEST(Laws, ViscousFrictionSlowsAJoint) {
  Robot robot = find_robot("panda_arm");
  for (Joint& joint : robot.joints) joint.friction = {};
  robot.joints.back().friction.viscous = 0.02;
  const auto model = std::make_shared<const RobotModel>(make_robot_model(robot));
  World world;
  world.gravity.setZero();
  std::vector<double> dofs;
  for (const DegreeOfFreedom& dof : robot.dofs) dofs.push_back(dof.initial);
  world.robots.push_back(make_world_robot("arm", model, Pose::Identity(), dofs));
  WorldRobot& arm = world.robots[0];
  // All other joints are held.
  const Eigen::Index last = model->dofs() - 1;
  for (int d = 0; d < static_cast<int>(last); ++d) {
    arm.drives.push_back({.dof = d, .holds_rate = true});
  }
  arm.rate[last] = 1.0;
  const double inertia = model->dynamics->mass_matrix(joints_of(arm))(last, last);
  for (int i = 0; i < 20; ++i) ASSERT_EQ(step_world(world).outcome, StepOutcome::moved);
  EXPECT_NEAR(arm.rate[last], std::pow(1.0 + 2.5e-3 * 0.02 / inertia, -20), 1e-6);
}

// A step that leads beyond all numbers is named, and the world stays as it was.
TEST(Laws, WhatIsNotFiniteEndsWithTheLastGoodState) {
  World world = on_plate({box("box", {0.1, 0.1, 0.1}, 1.0, {0.0, 0.0, 0.3})}, 0.5);
  ASSERT_EQ(test::run(world, 0.1), StepOutcome::moved);
  const RigidMotion before = world.bodies[1].motion;
  for (const double force :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    world.bodies[1].force_W = {force, 0.0, 0.0};
    const StepResult result = step_world(world);
    EXPECT_EQ(result.outcome, StepOutcome::not_finite);
    EXPECT_EQ(result.time, 0.0);
    EXPECT_EQ(world.bodies[1].motion.X_WB.matrix(), before.X_WB.matrix());
    EXPECT_EQ(world.bodies[1].motion.linear, before.linear);
  }
}

}  // namespace
}  // namespace prehend
