#include "sim/shape/contact/cup_seal.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend::test {
namespace {

constexpr double kRadius = 0.015;
constexpr double kTravel = 0.01;

// In the plane z = height, looking down.
CupLip lip_at(double x, double y, double height, double travel = kTravel) {
  return {.center = {x, y, height}, .axis = -Vector3::UnitZ(), .radius = kRadius, .travel = travel};
}

CupLip moved(const CupLip& lip, const Pose& X) {
  CupLip other = lip;
  other.center = X * lip.center;
  other.axis = X.linear() * lip.axis;
  return other;
}

// The same in many poses of mesh and cup.
void expect_everywhere(const TriangleMesh& mesh, const CupLip& lip, SealEnd end) {
  Random random(3);
  for (int i = 0; i < 6; ++i) {
    const Pose X = i == 0 ? Pose::Identity() : random.pose(0.3);
    const ProximityMesh placed(transformed(mesh, X));
    const CupSeal seal = cup_seal(placed, moved(lip, X));
    EXPECT_EQ(name_of(seal.end), name_of(end)) << i;
  }
}

// A box of 0.1 m whose upper face is z = 0.
TriangleMesh block(double width = 0.1) {
  return transformed(make_box({width, width, 0.05}),
                     pose_from(Matrix3::Identity(), {0, 0, -0.025}));
}

TEST(CupSeal, HoldsOnAPlane) {
  const ProximityMesh mesh(block());
  const CupSeal seal = cup_seal(mesh, lip_at(0.01, -0.02, 0.002));
  EXPECT_EQ(seal.end, SealEnd::sealed);
  EXPECT_NEAR(seal.strain, 0.0, 1e-12);
  EXPECT_NEAR(seal.press, 0.002, 1e-12);
  EXPECT_NEAR(seal.nearest, 0.002, 1e-12);
  EXPECT_LT((seal.center - Vector3(0.01, -0.02, 0.0)).norm(), 1e-12);
  expect_everywhere(block(), lip_at(0.01, -0.02, 0.002), SealEnd::sealed);
}

// Tilted by the angle a, the plane lies 2 r tan a apart along the axis.
TEST(CupSeal, TiltsAsFarAsItGivesWay) {
  const ProximityMesh mesh(block(0.3));
  for (const double angle : {0.1, 0.2, 0.3, 0.31, 0.33, 0.4}) {
    CupLip lip = lip_at(0.0, 0.0, 0.0);
    lip.axis = Vector3(std::sin(angle), 0.0, -std::cos(angle));
    const CupSeal seal = cup_seal(mesh, lip);
    const double apart = 2.0 * kRadius * std::tan(angle);
    EXPECT_EQ(seal.end, apart <= kTravel ? SealEnd::sealed : SealEnd::too_curved) << angle;
    EXPECT_NEAR(seal.press - seal.nearest, apart, 1e-9);
  }
}

// The depth of a cylinder of radius R under the lip at the angle a, across its axis at r cos a.
double cylinder_depth(double cylinder, double angle) {
  const double x = kRadius * std::cos(angle);
  return cylinder - std::sqrt(cylinder * cylinder - x * x);
}

// The longest spring of a ring on a cylinder, and the limit of ever shorter springs: the slope of
// the lip is d' = x y / (r sqrt(R^2 - x^2)), largest where (x / r)^2 = q - sqrt(q^2 - q) with q =
// (R / r)^2.
TEST(CupSeal, StretchesOnACylinder) {
  for (const double cylinder : {0.017, 0.025, 0.06}) {
    const TriangleMesh side = transformed(
        make_cylinder(cylinder, 0.2, 1000),
        pose_from(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vector3::UnitY()).toRotationMatrix() *
                      Eigen::AngleAxisd(0.3, Vector3::UnitZ()).toRotationMatrix(),
                  {0, 0, -cylinder}));
    CupLip lip = lip_at(0.0, 0.0, 0.0, 0.1);
    const CupSeal seal = cup_seal(ProximityMesh(side), lip);
    const double q = cylinder * cylinder / (kRadius * kRadius);
    const double u = q - std::sqrt(q * q - q);
    const double steepest = std::sqrt(u * (1.0 - u) / (q - u));
    const double limit = std::hypot(1.0, steepest) - 1.0;
    // Springs of a turn / 32 miss the steepest place by up to half of that, and are straight.
    EXPECT_NEAR(seal.strain, limit, 0.06 * limit) << cylinder;
    EXPECT_LE(seal.strain, limit + 1e-4);
    EXPECT_EQ(seal.end, limit > 0.1 ? SealEnd::too_curved : SealEnd::sealed) << cylinder;
    // The mesh is inside the cylinder by R (1 - cos(pi / 1000)), below 4e-7.
    EXPECT_NEAR(seal.press - seal.nearest, cylinder_depth(cylinder, 0.0), 1e-6);
    lip.travel = 0.99 * cylinder_depth(cylinder, 0.0);
    EXPECT_EQ(cup_seal(ProximityMesh(side), lip).end, SealEnd::too_curved);
  }
}

// The lip of a cup on a sphere is a circle of it: nothing stretches, and the sphere reaches R -
// sqrt(R^2 - r^2) into the cup, which must be as deep.
TEST(CupSeal, OnASphereNeedsADeepCup) {
  for (const double sphere : {0.02, 0.03, 0.1}) {
    const double bulge = sphere - std::sqrt(sphere * sphere - kRadius * kRadius);
    const TriangleMesh ball = transformed(make_geodesic_sphere(sphere, 40),
                                          pose_from(Matrix3::Identity(), {0, 0, -sphere}));
    const ProximityMesh mesh(ball);
    const CupSeal deep = cup_seal(mesh, lip_at(0.0, 0.0, -bulge, 1.02 * bulge));
    EXPECT_EQ(deep.end, SealEnd::sealed) << sphere;
    EXPECT_LT(deep.strain, 1e-3);
    EXPECT_NEAR(deep.press, 0.0, 2e-5);
    EXPECT_EQ(cup_seal(mesh, lip_at(0.0, 0.0, -bulge, 0.97 * bulge)).end, SealEnd::too_curved);
  }
}

TEST(CupSeal, DoesNotHoldBesideTheObjectNorOnItsEdges) {
  expect_everywhere(block(), lip_at(0.04, 0.0, 0.001), SealEnd::off_surface);
  expect_everywhere(block(), lip_at(0.0499, 0.0499, 0.001), SealEnd::off_surface);
  expect_everywhere(block(), lip_at(0.034, 0.0, 0.001), SealEnd::sealed);
  // Along the diagonal onto an edge.
  CupLip lip = lip_at(0.05, 0.0, 0.0);
  lip.axis = Vector3(-1.0, 0.0, -1.0).normalized();
  lip.center -= 0.002 * lip.axis;
  expect_everywhere(block(), lip, SealEnd::edge);
  // A step of 5 mm, which is higher than the slope of either face explains.
  TriangleMesh step = block();
  append(step, transformed(make_box({0.05, 0.1, 0.005}),
                           pose_from(Matrix3::Identity(), {0.025, 0.0, 0.0025})));
  expect_everywhere(step, lip_at(0.001, 0.0, 0.006), SealEnd::edge);
  expect_everywhere(step, lip_at(0.025, 0.0, 0.006), SealEnd::sealed);
}

// Half of a plate with a round hole in its middle.
TriangleMesh half_plate(double hole, double side) {
  std::vector<Eigen::Vector2d> corners = {
      {0.05, 0.0}, {0.05, side * 0.05}, {-0.05, side * 0.05}, {-0.05, 0.0}};
  constexpr int kCorners = 24;
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = side * std::numbers::pi * (1.0 - static_cast<double>(i) / kCorners);
    corners.emplace_back(hole * std::cos(angle), hole * std::sin(angle));
  }
  if (side < 0.0) std::reverse(corners.begin(), corners.end());
  return make_prism(corners, -0.01, 0.0);
}

TEST(CupSeal, LeaksThroughHoles) {
  TriangleMesh plate = half_plate(0.006, 1.0);
  append(plate, half_plate(0.006, -1.0));
  // The hole inside of the lip, and beside it.
  expect_everywhere(plate, lip_at(0.001, 0.001, 0.001), SealEnd::gap);
  expect_everywhere(plate, lip_at(0.03, 0.01, 0.001), SealEnd::sealed);
  // A mesh from which triangles are missing, so that rays come to the back of the bottom.
  TriangleMesh open =
      transformed(make_box({0.1, 0.1, 0.05}, 25), pose_from(Matrix3::Identity(), {0, 0, -0.025}));
  std::erase_if(open.triangles, [&](const Triangle& t) {
    const Vector3 middle = (open.vertices[static_cast<std::size_t>(t[0])] +
                            open.vertices[static_cast<std::size_t>(t[1])] +
                            open.vertices[static_cast<std::size_t>(t[2])]) /
                           3.0;
    return middle.z() > -1e-9 && std::abs(middle.x()) < 0.0055 && std::abs(middle.y()) < 0.0055;
  });
  expect_everywhere(open, lip_at(0.0, 0.0, 0.001), SealEnd::gap);
  expect_everywhere(open, lip_at(0.013, 0.0, 0.001), SealEnd::gap);
  expect_everywhere(open, lip_at(0.03, 0.0, 0.001), SealEnd::sealed);
}

TEST(CupSeal, LeaksThroughWhatIsPorous) {
  const ProximityMesh mesh(block());
  const auto right = [](const Vector3& p) { return p.x() > 0.0; };
  EXPECT_EQ(cup_seal(mesh, lip_at(-0.02, 0.0, 0.001), right).end, SealEnd::sealed);
  EXPECT_EQ(cup_seal(mesh, lip_at(-0.01, 0.0, 0.001), right).end, SealEnd::porous);
  EXPECT_EQ(cup_seal(mesh, lip_at(0.02, 0.0, 0.001), right).end, SealEnd::porous);
}

}  // namespace
}  // namespace prehend::test
