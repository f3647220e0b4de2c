#include "sim/shape/contact/soft_patch.h"

#include <numbers>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

constexpr double kGap = 5e-5;
constexpr double kDepth = 1e-3;

// A pad of 20 x 30 mm under the object, its face `kGap` below the plane z = 0.
const ProximityMesh& pad() {
  static const ProximityMesh mesh(make_box({0.02, 0.03, 0.01}));
  return mesh;
}
const Pose kPadBelow = translation({0.0, 0.0, -0.005 - kGap});

std::vector<SoftPatch> patches_of(const TriangleMesh& object_W, const Pose& X_WO) {
  SoftPatchWorkspace workspace;
  const Pose X_OW = X_WO.inverse();
  std::vector<SoftPatch> patches;
  soft_patches(ProximityMesh(transformed(object_W, X_OW)), pad(), X_OW * kPadBelow, kDepth,
               workspace, patches);
  for (SoftPatch& patch : patches) {
    patch.position = X_WO * patch.position;
    patch.normal = X_WO.linear() * patch.normal;
  }
  return patches;
}

// Mean distance from the centre of a rectangle, by a fine grid.
double mean_distance(double width, double height) {
  constexpr int kCells = 400;
  double sum = 0.0;
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      sum += std::hypot(width * ((i + 0.5) / kCells - 0.5), height * ((j + 0.5) / kCells - 0.5));
    }
  }
  return sum / (kCells * kCells);
}

TEST(SoftPatch, AFlatFaceIsPressedEvenly) {
  Random random(7);
  const TriangleMesh box = transformed(make_box({0.012, 0.1, 0.04}, 6), translation({0, 0, 0.02}));
  for (int i = 0; i < 5; ++i) {
    const auto patches = patches_of(box, i == 0 ? Pose::Identity() : random.pose(1.0));
    ASSERT_EQ(patches.size(), 1U);
    EXPECT_LT(patches[0].position.norm(), 1e-9);
    EXPECT_NEAR(patches[0].normal.z(), 1.0, 1e-12);
    EXPECT_NEAR(patches[0].force, 0.012 * 0.03 * (kDepth - kGap), 1e-12);
    EXPECT_NEAR(patches[0].gap, kGap, 1e-12);
    // Triangles of 5 mm sample the distances to 3 %.
    EXPECT_NEAR(patches[0].torsion / mean_distance(0.012, 0.03), 1.0, 0.03);
  }
}

// A paraboloid cap of radius a = sqrt(2 R d) is pressed like d - r^2 / 2R: force pi R d^2, mean
// distance 8 a / 15.
TEST(SoftPatch, ASphereIsPressedOnItsCap) {
  const double radius = 0.03;
  const TriangleMesh ball =
      transformed(make_sphere(radius, 6), translation({0.002, 0.001, radius}));
  const auto patches = patches_of(ball, Pose::Identity());
  ASSERT_EQ(patches.size(), 1U);
  const double depth = kDepth - kGap;
  EXPECT_NEAR(patches[0].force / (std::numbers::pi * radius * depth * depth), 1.0, 0.05);
  EXPECT_NEAR(patches[0].torsion / (8.0 / 15.0 * std::sqrt(2.0 * radius * depth)), 1.0, 0.05);
  EXPECT_NEAR(patches[0].position.x(), 0.002, 2e-4);
  EXPECT_NEAR(patches[0].position.y(), 0.001, 2e-4);
  EXPECT_NEAR(patches[0].position.z(), 0.0, 2e-5);  // on the ball, not inside
  EXPECT_NEAR(patches[0].normal.z(), 1.0, 1e-3);
}

TEST(SoftPatch, TwoFeetAreTwoPatches) {
  TriangleMesh feet = transformed(make_box({0.004, 0.02, 0.02}), translation({-0.007, 0, 0.01}));
  append(feet, transformed(make_box({0.002, 0.02, 0.02}), translation({0.007, 0, 0.01})));
  const auto patches = patches_of(feet, Pose::Identity());
  ASSERT_EQ(patches.size(), 2U);
  EXPECT_NEAR(patches[0].position.x(), -0.007, 1e-9);
  EXPECT_NEAR(patches[1].position.x(), 0.007, 1e-9);
  EXPECT_NEAR(patches[0].force, 2.0 * patches[1].force, 1e-12);
}

// Under an edge the centre of pressure is as far from the face on the one side as from that on the
// other: rounding must not choose between them.
TEST(SoftPatch, UnderAnEdgeThePlaceDoesNotDependOnRounding) {
  Random random(8);
  // Lying along y on one of its 60 edges.
  const Matrix3 lying{{0, -1, 0}, {0, 0, 1}, {-1, 0, 0}};
  const TriangleMesh prism =
      transformed(make_cylinder(0.03, 0.01, 60), pose_from(lying, {0, 0, 0.03}));
  const auto level = patches_of(prism, Pose::Identity());
  ASSERT_EQ(level.size(), 1U);
  EXPECT_NEAR(level[0].position.norm(), 0.0, 1e-9);
  for (int i = 0; i < 20; ++i) {
    const auto patches = patches_of(prism, random.pose(1.0));
    ASSERT_EQ(patches.size(), 1U);
    EXPECT_LT((patches[0].position - level[0].position).norm(), 1e-9);
  }
}

// The moment of the pressure about any point is that of the resultant at the patch's position.
TEST(SoftPatch, ThePlaceIsOnTheLineOfTheForce) {
  const TriangleMesh ball = transformed(make_sphere(0.03, 6), translation({0.0095, 0.001, 0.03}));
  const auto patches = patches_of(ball, Pose::Identity());
  ASSERT_EQ(patches.size(), 1U);
  // The pad ends at x = 10 mm: the cap is cut off, and the force leans. All normals of the ball
  // pass through its centre, so that the line of the resultant does too.
  const Vector3 arm = patches[0].position - Vector3(0.0095, 0.001, 0.03);
  EXPECT_LT(arm.cross(patches[0].normal).norm(), 1e-4);
  EXPECT_GT(patches[0].normal.x(), 1e-3);
}

TEST(SoftPatch, NothingWithinTheDepthIsNoPatch) {
  const TriangleMesh far = transformed(make_box({0.01, 0.01, 0.01}), translation({0, 0, 0.0065}));
  EXPECT_TRUE(patches_of(far, Pose::Identity()).empty());
}

}  // namespace
}  // namespace prehend
