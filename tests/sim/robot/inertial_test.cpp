// Mass, centre of mass and inertia against closed forms, moved and turned.
#include "sim/robot/inertial.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/robot/platform.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

// Relative, of sums over a few hundred triangles.
constexpr double kInertialRounding = 1e-12;

Matrix3 diagonal(double x, double y, double z) { return Vector3(x, y, z).asDiagonal(); }

void expect_near(const Inertial& found, const Inertial& expected, double relative) {
  EXPECT_NEAR(found.mass, expected.mass, relative * expected.mass);
  EXPECT_LT((found.center_of_mass - expected.center_of_mass).norm(), relative);
  EXPECT_LT((found.inertia - expected.inertia).norm(), relative * expected.inertia.norm());
}

Inertial box(const Vector3& s, double mass) {
  const Vector3 q = mass / 12.0 * s.cwiseAbs2();
  return {mass, Vector3::Zero(), diagonal(q.y() + q.z(), q.x() + q.z(), q.x() + q.y())};
}

TEST(Inertial, OfABox) {
  const Vector3 size(0.1, 0.2, 0.3);
  const double mass = 2700.0 * size.prod();
  expect_near(inertial_of_density(make_box(size), 2700.0), box(size, mass), kInertialRounding);
  expect_near(inertial_of_mass(make_box(size), 3.5), box(size, 3.5), kInertialRounding);
}

// A prism of n sides with its corners on the circle: area n/2 r^2 sin(2 pi / n), and the polar
// moment of that area over it r^2 (2 + cos(2 pi / n)) / 6.
TEST(Inertial, OfACylinder) {
  const double r = 0.04;
  const double h = 0.2;
  const int n = 30;
  const double step = 2.0 * std::numbers::pi / n;
  const double mass = 1000.0 * 0.5 * n * r * r * std::sin(step) * h;
  const double polar = mass * r * r * (2.0 + std::cos(step)) / 6.0;
  const double across = 0.5 * polar + mass * h * h / 12.0;
  const Inertial found = inertial_of_density(make_cylinder(r, h, n), 1000.0);
  expect_near(found, {mass, Vector3::Zero(), diagonal(across, across, polar)}, 1e-10);
  EXPECT_NEAR(polar, 0.5 * mass * r * r, 0.02 * polar) << "near the round one";
}

TEST(Inertial, OfASphere) {
  const double r = 0.05;
  const double mass = 0.7;
  const Inertial found = inertial_of_mass(make_sphere(r, 5), mass);
  // Corners lie on the sphere, so the solid is a little smaller.
  const double moment = 0.4 * mass * r * r;
  expect_near(found, {mass, Vector3::Zero(), diagonal(moment, moment, moment)}, 2e-3);
  EXPECT_LT(found.inertia(0, 0), moment);
}

TEST(Inertial, MovesAndTurnsWithItsBody) {
  Random random(311);
  TriangleMesh mesh = make_box({0.1, 0.2, 0.3});
  append(mesh, transformed(make_sphere(0.03, 2), translation({0.2, 0.1, 0.0})));
  for (int i = 0; i < 20; ++i) {
    const Pose X = random.pose(0.5);
    expect_near(transformed(inertial_of_density(mesh, 800.0), X),
                inertial_of_density(transformed(mesh, X), 800.0), 1e-9);
  }
}

TEST(Inertial, TwoHalvesAddUpByTheParallelAxisTheorem) {
  const Inertial half = inertial_of_mass(make_box({0.1, 0.2, 0.15}), 1.0);
  Matrix3 sum = Matrix3::Zero();
  for (const double z : {-0.075, 0.075}) {
    const Inertial part = transformed(half, translation({0.0, 0.0, z}));
    const Vector3& c = part.center_of_mass;
    sum += part.inertia + part.mass * (c.squaredNorm() * Matrix3::Identity() - c * c.transpose());
  }
  EXPECT_LT((sum - box({0.1, 0.2, 0.3}, 2.0).inertia).norm(), 1e-14);
}

TEST(Inertial, OfAMountedBaseIsInTheFrameOfWhatCarriesIt) {
  MountedRobot arm{.name = "arm", .robot = {}};
  arm.robot.dofs = {{.name = "turn"}};
  arm.robot.joints = {{.name = "turn"}};
  arm.robot.chains = {{.name = "arm", .first_joint = 0, .joint_count = 1}};
  arm.robot.links = {{"foot", "metal", -1, make_box({1.0, 1.0, 1.0})}};
  Random random(312);
  const TriangleMesh mesh = make_box({0.1, 0.2, 0.3});
  MountedRobot tool{.name = "tool", .robot = {}, .parent = 0, .X_MR = random.pose(1.0)};
  tool.robot.links = {{"body", "metal", -1, mesh, inertial_of_mass(mesh, 2.0)}};
  const AssembledPlatform whole = assemble({"both", {arm, tool}});
  const Link& body = whole.robot.links.back();
  expect_near(body.inertial, inertial_of_mass(body.mesh, 2.0), 1e-9);
}

TEST(InertiaDefect, KnowsWhatNoBodyHas) {
  EXPECT_EQ(inertia_defect(diagonal(1.0, 2.0, 3.0)), "");
  EXPECT_EQ(inertia_defect(diagonal(1.0, 0.0, 1.0)), "") << "a rod";
  EXPECT_NE(inertia_defect(diagonal(1.0, 2.0, 3.1)), "");
  EXPECT_NE(inertia_defect(diagonal(-0.1, 2.0, 2.0)), "");
  EXPECT_NE(inertia_defect(diagonal(NAN, 2.0, 2.0)), "");
  Matrix3 skewed = diagonal(1.0, 1.0, 1.0);
  skewed(0, 1) = 0.1;
  EXPECT_EQ(inertia_defect(skewed), "must be symmetric");
  Random random(313);
  const Matrix3 turn = random.rotation();
  EXPECT_EQ(inertia_defect(turn * diagonal(1.0, 2.0, 3.0) * turn.transpose()), "");
  EXPECT_NE(inertia_defect(turn * diagonal(1.0, 2.0, 3.5) * turn.transpose()), "");
}

}  // namespace
}  // namespace prehend
