// The separating bound against distances of convex meshes by trying every pair.
#include "sim/shape/separation.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/convex_hull.h"
#include "sim/shape/proximity.h"
#include "tests/support/brute_force.h"

namespace prehend {
namespace {

// A few products of coordinates below a metre.
constexpr double kSeparationRounding = 1e-15;

TriangleMesh cloud_hull(Random& random, int count) {
  std::vector<Vector3> points;
  for (int i = 0; i < count; ++i) points.push_back(random.in_box(0.04));
  return convex_hull(points);
}

std::vector<TriangleMesh> convex_meshes() {
  Random random(31);
  return {make_box({0.02, 0.05, 0.1}), make_sphere(0.03, 2),   make_cylinder(0.03, 0.08, 24),
          cloud_hull(random, 12),      cloud_hull(random, 60), make_box({0.2, 0.2, 0.002})};
}

ConvexPoints points_of(const TriangleMesh& mesh) { return ConvexPoints(mesh.vertices); }

TEST(Separation, IsALowerBoundNearTheDistanceAndNotPositiveWhereSetsMeet) {
  Random random(32);
  const std::vector<TriangleMesh> meshes = convex_meshes();
  int apart = 0;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    for (std::size_t k = 0; k < meshes.size(); ++k) {
      for (int n = 0; n < 12; ++n) {
        const Pose X_AB = random.pose(random.uniform(0.01, 0.2));
        const auto a = test::soup(meshes[i]);
        const auto b = test::soup(meshes[k], X_AB);
        const bool meet = test::surfaces_meet(a, b) || test::one_holds_the_other(a, b);
        const double distance = meet ? 0.0 : test::surface_gap(a, b);
        Vector3 direction = Vector3::Zero();
        const double bound =
            separation(points_of(meshes[i]), points_of(meshes[k]), X_AB, direction);
        const std::string what =
            std::to_string(i) + " and " + std::to_string(k) + ", pose " + std::to_string(n);
        ASSERT_LE(bound, distance + kSeparationRounding) << what;
        if (meet) continue;
        ++apart;
        ASSERT_GE(bound, 0.85 * distance) << what << ", distance " << distance;
      }
    }
  }
  EXPECT_GT(apart, 100);
}

// Round sets that nearly touch are where a search for the direction takes longest.
TEST(Separation, IsNearTheDistanceOfSetsThatNearlyTouch) {
  Random random(34);
  const std::vector<TriangleMesh> meshes = {make_sphere(0.03, 3), make_cylinder(0.03, 0.08, 96),
                                            make_box({0.3, 0.3, 0.002}), cloud_hull(random, 200)};
  const std::vector<ProximityMesh> bodies(meshes.begin(), meshes.end());
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    for (std::size_t k = 0; k < meshes.size(); ++k) {
      for (int n = 0; n < 60; ++n) {
        const Matrix3 turn = random.rotation();
        const Pose far = pose_from(turn, 0.4 * random.direction());
        const TriangleGap gap =
            triangle_gap(bodies[i], bodies[k], far, find_gap(bodies[i], bodies[k], far).pair);
        // Moved along their common normal, the nearest points of convex sets stay the nearest.
        const double distance = std::pow(10.0, random.uniform(-4.0, -2.0));
        const Vector3 between = far * gap.p_B - gap.p_A;
        const Pose X_AB = translation((distance / gap.distance - 1.0) * between) * far;
        Vector3 direction = Vector3::Zero();
        const double bound =
            separation(points_of(meshes[i]), points_of(meshes[k]), X_AB, direction);
        ASSERT_LE(bound, distance + kSeparationRounding);
        ASSERT_GE(bound, 0.85 * distance) << i << " and " << k << ", pose " << n;
      }
    }
  }
}

TEST(Separation, LeavesADirectionThatGivesItsBound) {
  Random random(33);
  const TriangleMesh box = make_box({0.02, 0.05, 0.1});
  for (int n = 0; n < 50; ++n) {
    const Matrix3 turn = random.rotation();
    const Pose X_AB = pose_from(turn, 0.2 * random.direction());
    Vector3 direction = random.in_box(1.0);
    const double bound = separation(points_of(box), points_of(box), X_AB, direction);
    ASSERT_NEAR(direction.norm(), 1.0, 1e-12);
    double nearest_b = 1e9;
    double farthest_a = -1e9;
    for (const Vector3& p : box.vertices) {
      farthest_a = std::max(farthest_a, direction.dot(p));
      nearest_b = std::min(nearest_b, direction.dot(X_AB * p));
    }
    // The bound is less by the errors of a search in single precision.
    EXPECT_LE(bound, nearest_b - farthest_a + kSeparationRounding);
    EXPECT_NEAR(nearest_b - farthest_a, bound, 4.0 * points_of(box).search_error());
    // The bound found once is at least found again from where it was left.
    EXPECT_GE(separation(points_of(box), points_of(box), X_AB, direction),
              bound - points_of(box).search_error());
  }
}

TEST(Separation, OfSinglePointsIsTheirDistance) {
  const ConvexPoints origin{{Vector3::Zero()}};
  for (const double length : {1e-6, 0.01, 10.0}) {
    Vector3 direction(1.0, 2.0, -3.0);
    const Vector3 shift = length * Vector3(0.6, 0.0, -0.8);
    EXPECT_NEAR(separation(origin, origin, translation(shift), direction), length, 1e-14 * length);
  }
}

TEST(Separation, OfEqualSetsAtOnePlaceIsNotPositive) {
  Vector3 direction = Vector3::Zero();
  const ConvexPoints box = points_of(make_box({0.1, 0.1, 0.1}));
  EXPECT_LE(separation(box, box, Pose::Identity(), direction), 0.0);
  const ConvexPoints point{{Vector3(0.01, 0.0, 0.0)}};
  EXPECT_LE(separation(point, point, Pose::Identity(), direction), 0.0);
}

}  // namespace
}  // namespace prehend
