#include "sim/quality/point_hull.h"

#include <cmath>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "tests/support/grasp_families.h"

namespace prehend::test {
namespace {

// The 2^d corners of [-1, 1]^d.
Eigen::MatrixXd cube_points(int d) {
  Eigen::MatrixXd points(d, 1 << d);
  for (int corner = 0; corner < 1 << d; ++corner) {
    for (int i = 0; i < d; ++i) points(i, corner) = ((corner >> i) & 1) != 0 ? 1.0 : -1.0;
  }
  return points;
}

// The origin and the unit vectors: volume 1 / d!.
Eigen::MatrixXd corner_simplex(int d) {
  Eigen::MatrixXd points = Eigen::MatrixXd::Zero(d, d + 1);
  points.rightCols(d).setIdentity();
  return points;
}

Eigen::MatrixXd cloud(Random& random, int d, int count) {
  Eigen::MatrixXd points(d, count);
  for (double& entry : points.reshaped()) entry = random.uniform(-1.0, 1.0);
  return points;
}

// That the facets bound all points and pass through the corners they name, up to `slack`.
void expect_consistent(const PointHull& hull, const Eigen::MatrixXd& points, double slack) {
  ASSERT_EQ(hull.status, PointHullStatus::solid) << hull.message;
  ASSERT_EQ(hull.normals.rows(), points.rows());
  ASSERT_EQ(hull.normals.cols(), hull.offsets.size());
  ASSERT_EQ(hull.corners.rows(), points.rows());
  ASSERT_EQ(hull.corners.cols(), hull.offsets.size());
  for (Eigen::Index f = 0; f < hull.offsets.size(); ++f) {
    EXPECT_NEAR(hull.normals.col(f).norm(), 1.0, 1e-12);
    const Eigen::VectorXd reached = points.transpose() * hull.normals.col(f);
    EXPECT_LE(reached.maxCoeff(), hull.offsets[f] + slack) << "facet " << f;
    for (const int corner : hull.corners.col(f)) {
      ASSERT_GE(corner, 0);
      ASSERT_LT(corner, points.cols());
      EXPECT_NEAR(reached[corner], hull.offsets[f], slack) << "facet " << f << ", point " << corner;
    }
  }
}

// The sum of the simplices between a point inside and the facets' corners.
double volume_of_facets(const PointHull& hull, const Eigen::MatrixXd& points) {
  const Eigen::VectorXd centre = points.rowwise().mean();
  const Eigen::Index d = points.rows();
  double volume = 0.0;
  for (Eigen::Index f = 0; f < hull.offsets.size(); ++f) {
    Eigen::MatrixXd edges(d, d);
    for (Eigen::Index i = 0; i < d; ++i) edges.col(i) = points.col(hull.corners(i, f)) - centre;
    volume += std::abs(edges.determinant());
  }
  return volume / std::tgamma(static_cast<double>(d) + 1.0);
}

TEST(PointHull, CubesOfAnyDimension) {
  for (int d = 2; d <= 7; ++d) {
    const Eigen::MatrixXd points = cube_points(d);
    const PointHull hull = point_hull(points);
    expect_consistent(hull, points, 1e-12);
    EXPECT_NEAR(hull.volume, std::pow(2.0, d), 1e-9) << d;
    EXPECT_NEAR(volume_of_facets(hull, points), std::pow(2.0, d), 1e-9) << d;
    EXPECT_NEAR(hull.offsets.minCoeff(), 1.0, 1e-12) << d;
    EXPECT_NEAR(hull.offsets.maxCoeff(), 1.0, 1e-12) << d;
    EXPECT_EQ(hull.joggle, 0.0);
  }
}

TEST(PointHull, SimplicesOfAnyDimension) {
  for (int d = 2; d <= 8; ++d) {
    const Eigen::MatrixXd points = corner_simplex(d);
    const PointHull hull = point_hull(points);
    expect_consistent(hull, points, 1e-13);
    EXPECT_EQ(hull.offsets.size(), d + 1);
    EXPECT_NEAR(hull.volume * std::tgamma(d + 1.0), 1.0, 1e-12) << d;
    // d facets pass through the origin, one does not.
    EXPECT_NEAR(hull.offsets.maxCoeff(), 1.0 / std::sqrt(d), 1e-12);
    EXPECT_NEAR(hull.offsets.minCoeff(), 0.0, 1e-15);
  }
}

TEST(PointHull, FacetsOfRandomPointsBoundThem) {
  Random random(31);
  for (int d = 2; d <= 6; ++d) {
    const Eigen::MatrixXd points = cloud(random, d, 8 * d);
    const PointHull hull = point_hull(points);
    expect_consistent(hull, points, 1e-11);
    EXPECT_NEAR(volume_of_facets(hull, points), hull.volume, 1e-10 * hull.volume) << d;
    const PointHull moved = point_hull(points.array() + 10.0);
    EXPECT_NEAR(moved.volume, hull.volume, 1e-9 * hull.volume) << d;
  }
}

// A point inside is nobody's corner, and corners are counted in the caller's order.
TEST(PointHull, CornersAreColumnsOfThePoints) {
  Eigen::MatrixXd points(3, 9);
  points << Eigen::Vector3d(0.1, 0.2, 0.3), cube_points(3);
  const PointHull hull = point_hull(points);
  expect_consistent(hull, points, 1e-12);
  EXPECT_EQ(hull.corners.minCoeff(), 1);
  EXPECT_EQ(hull.corners.maxCoeff(), 8);
}

TEST(PointHull, FewOrFlatPointsAreFlat) {
  Random random(32);
  for (int d = 2; d <= 6; ++d) {
    for (int count = 0; count <= d; ++count) {
      EXPECT_EQ(point_hull(cloud(random, d, count)).status, PointHullStatus::flat);
    }
    Eigen::MatrixXd flat = cloud(random, d, 4 * d);
    flat.row(d - 1) = flat.row(0);
    const PointHull hull = point_hull(flat);
    EXPECT_EQ(hull.status, PointHullStatus::flat) << d;
    EXPECT_EQ(hull.volume, 0.0);
    for (const double value : {0.0, 0.3}) {
      const Eigen::MatrixXd one = Eigen::MatrixXd::Constant(d, 4 * d, value);
      EXPECT_EQ(point_hull(one).status, PointHullStatus::flat) << d;
    }
  }
}

TEST(PointHull, JoggledHullIsOffByTheJoggle) {
  for (int d = 3; d <= 6; ++d) {
    const Eigen::MatrixXd points = cube_points(d);
    const PointHull hull = point_hull(points, HullInput::joggled);
    ASSERT_EQ(hull.status, PointHullStatus::solid) << hull.message;
    EXPECT_GT(hull.joggle, 0.0);
    EXPECT_LT(hull.joggle, 1e-6);
    // Offsets move by at most the length of the joggle in d dimensions, the volume by that times
    // the surface, d 2^d.
    const double moved = std::sqrt(d) * hull.joggle;
    expect_consistent(hull, points, 3.0 * moved);
    EXPECT_NEAR(hull.volume, std::pow(2.0, d), 2.0 * d * std::pow(2.0, d) * moved) << d;
  }
}

TEST(PointHull, SameBitsEachTime) {
  Random random(33);
  const Eigen::MatrixXd points = cloud(random, 6, 40);
  for (const HullInput input : {HullInput::as_given, HullInput::joggled}) {
    const PointHull first = point_hull(points, input);
    const PointHull second = point_hull(points, input);
    EXPECT_EQ(first.volume, second.volume);
    EXPECT_EQ(first.offsets, second.offsets);
    EXPECT_EQ(first.corners, second.corners);
  }
}

}  // namespace
}  // namespace prehend::test
