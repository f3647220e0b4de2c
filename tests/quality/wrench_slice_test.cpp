#include "sim/quality/wrench_slice.h"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sim/quality/set_hull.h"
#include "sim/quality/wrench_space.h"
#include "tests/quality/grasp_families.h"

namespace prehend::test {
namespace {

// The hull of +-2 e_i: |x|_1 <= 2.
PointHull cross_polytope() {
  Eigen::MatrixXd points(6, 12);
  points << 2.0 * Eigen::MatrixXd::Identity(6, 6), -2.0 * Eigen::MatrixXd::Identity(6, 6);
  return point_hull(points);
}

double volume_of(const WrenchSlice& slice) {
  double volume = 0.0;
  for (const auto& t : slice.triangles.colwise()) {
    const Eigen::Vector3d a = slice.vertices.col(t[0]);
    const Eigen::Vector3d b = slice.vertices.col(t[1]);
    volume += a.dot(b.cross(Eigen::Vector3d(slice.vertices.col(t[2])))) / 6.0;
  }
  return volume;
}

// |x|_1 <= 2 - |v|_1: an octahedron of volume 4/3 r^3.
TEST(WrenchSlice, OfACrossPolytopeIsAnOctahedron) {
  for (const double v : {0.0, 0.5, -1.5}) {
    const WrenchSlice slice = wrench_slice(cross_polytope(), {{0, 2, 4}, {0.0, v, 0.0}});
    const double r = 2.0 - std::abs(v);
    EXPECT_EQ(slice.coordinates, (std::array<int, 3>{1, 3, 5}));
    ASSERT_EQ(slice.vertices.cols(), 6) << v;
    EXPECT_EQ(slice.triangles.cols(), 8);
    EXPECT_NEAR(slice.volume, 4.0 / 3.0 * r * r * r, 1e-9);
    EXPECT_NEAR(volume_of(slice), slice.volume, 1e-9);  // outward and closed
    EXPECT_NEAR(slice.vertices.cwiseAbs().maxCoeff(), r, 1e-9);
  }
}

TEST(WrenchSlice, OutsideIsEmpty) {
  EXPECT_TRUE(wrench_slice(cross_polytope(), {{3, 4, 5}, {2.5, 0.0, 0.0}}).empty());
  EXPECT_TRUE(wrench_slice(cross_polytope(), {{3, 4, 5}, {2.0, 0.0, 0.0}}).empty());  // a point
}

// Every point of a section, with the fixed coordinates, is in the hull, and a little farther is
// not.
TEST(WrenchSlice, VerticesAreOnTheHull) {
  Random random(21);
  for (int i = 0; i < 10; ++i) {
    const Contacts contacts = random_grasp(random, random.integer(4, 7), 0.6);
    const SetHull set = set_hull(*wrench_space(contacts, {}));
    const FixedCoordinates fixed{{1, 3, 5}, {0.02, -0.01, 0.03}};
    const WrenchSlice slice = wrench_slice(set.hull, fixed);
    for (const auto& vertex : slice.vertices.colwise()) {
      Wrench wrench;
      wrench << vertex[0], 0.02, vertex[1], -0.01, vertex[2], 0.03;
      const double slack = (set.hull.offsets - set.hull.normals.transpose() * wrench).minCoeff();
      EXPECT_NEAR(slack, 0.0, 1e-8);
    }
  }
}

// Facets that are nearly parallel to the section are cut very far away from it.
TEST(WrenchSlice, FlatBoxesTurnedByNextToNothing) {
  for (const double angle : {0.0, 1e-12, 1e-10, 3e-9, 1e-7, 1e-5}) {
    Eigen::MatrixXd corners(6, 64);
    for (int i = 0; i < 64; ++i) {
      for (int d = 0; d < 6; ++d)
        corners(d, i) = ((i >> d & 1) != 0 ? 1.0 : -1.0) * (d < 3 ? 1 : 0.1);
    }
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
    for (int i = 0; i < 64; ++i) {
      corners({0, 3}, i) = (turn * Eigen::Vector2d(corners({0, 3}, i))).eval();
    }
    const WrenchSlice slice =
        wrench_slice(point_hull(corners), {{0, 1, 2}, Eigen::Vector3d::Zero()});
    EXPECT_NEAR(slice.volume, 0.2 * 0.2 * 0.2, 1e-6) << angle;
    EXPECT_EQ(slice.vertices.cols(), 8) << angle;
  }
}

TEST(WrenchSlice, RefusesWhatIsNoSection) {
  EXPECT_THROW(wrench_slice({}), std::invalid_argument);
  EXPECT_THROW(wrench_slice(cross_polytope(), {{1, 1, 2}, {}}), std::invalid_argument);
  EXPECT_THROW(wrench_slice(cross_polytope(), {{1, 2, 6}, {}}), std::invalid_argument);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(wrench_slice(cross_polytope(), {{1, 2, 3}, {0.0, nan, 0.0}}), std::invalid_argument);
}

}  // namespace
}  // namespace prehend::test
