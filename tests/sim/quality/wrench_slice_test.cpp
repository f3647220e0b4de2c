#include "sim/quality/wrench_slice.h"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/quality/epsilon.h"
#include "sim/quality/set_hull.h"
#include "sim/quality/wrench_hull.h"
#include "sim/quality/wrench_space.h"
#include "tests/support/grasp_families.h"

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

WrenchSections sections_of(const Wrenches& wrenches) {
  return wrench_sections(wrench_hull(wrenches).points);
}

// Of the plane of a section's triangle from the origin.
double offset_of(const WrenchSlice& slice, Eigen::Index triangle) {
  const Eigen::Vector3d a = slice.vertices.col(slice.triangles(0, triangle));
  const Eigen::Vector3d b = slice.vertices.col(slice.triangles(1, triangle));
  const Eigen::Vector3d c = slice.vertices.col(slice.triangles(2, triangle));
  return (b - a).cross(c - a).normalized().dot(a);
}

// Slivers have no direction to speak of.
bool is_sliver(const WrenchSlice& slice, Eigen::Index triangle) {
  const Eigen::Vector3d a = slice.vertices.col(slice.triangles(0, triangle));
  const Eigen::Vector3d b = slice.vertices.col(slice.triangles(1, triangle));
  const Eigen::Vector3d c = slice.vertices.col(slice.triangles(2, triangle));
  const double size = slice.vertices.cwiseAbs().maxCoeff();
  return (b - a).cross(c - a).norm() < 1e-6 * size * size;
}

// Epsilon is the largest ball in six dimensions, so in each section there is one as large.
TEST(WrenchSections, TheBallOfEpsilonIsInBoth) {
  int looked_at = 0;
  for (const NamedGrasp& grasp : grasp_families(22, 2)) {
    const Wrenches wrenches = contact_wrenches(grasp.contacts, {}, grasp.edges);
    const double ball = epsilon_l1(wrenches).lower;
    if (ball < 1e-3) continue;
    ++looked_at;
    const WrenchSections sections = sections_of(wrenches);
    for (const WrenchSlice* slice : {&sections.forces, &sections.torques}) {
      ASSERT_FALSE(slice->empty()) << grasp.name;
      for (Eigen::Index t = 0; t < slice->triangles.cols(); ++t) {
        if (is_sliver(*slice, t)) continue;
        EXPECT_GE(offset_of(*slice, t), ball * (1.0 - 1e-6)) << grasp.name;
      }
    }
  }
  EXPECT_GE(looked_at, 10);
}

// Wrenches whose squares are no doubles: the same sections, as many times larger.
TEST(WrenchSections, OfAnySizeAreTheSame) {
  Random random(23);
  const Wrenches wrenches = contact_wrenches(random_grasp(random, 5, 0.5), {});
  const PointHull hull = wrench_hull(wrenches).points;
  const WrenchSections plain = wrench_sections(hull);
  ASSERT_FALSE(plain.forces.empty() || plain.torques.empty());
  for (const double size : {1e6, 1e80, 1e-80, 1e140, 1e-140}) {
    const WrenchSections sections = sections_of(size * wrenches);
    EXPECT_EQ(sections.forces.vertices.cols(), plain.forces.vertices.cols()) << size;
    EXPECT_EQ(sections.torques.vertices.cols(), plain.torques.vertices.cols()) << size;
    for (const auto& vertex : sections.forces.vertices.colwise()) {
      const Eigen::Vector3d force = vertex / size;
      const Eigen::VectorXd slack = hull.offsets - hull.normals.topRows<3>().transpose() * force;
      EXPECT_NEAR(slack.minCoeff(), 0.0, 1e-8) << size;
    }
    for (const auto& vertex : sections.torques.vertices.colwise()) {
      const Eigen::Vector3d torque = vertex / size;
      const Eigen::VectorXd slack =
          hull.offsets - hull.normals.bottomRows<3>().transpose() * torque;
      EXPECT_NEAR(slack.minCoeff(), 0.0, 1e-8) << size;
    }
  }
  const double volume = sections_of(1e80 * wrenches).forces.volume;
  EXPECT_NEAR(volume / 1e240, plain.forces.volume, 1e-6 * plain.forces.volume);
}

TEST(WrenchSections, OfWhatIsFlatAreEmpty) {
  const auto expect_empty = [](const WrenchSections& sections) {
    EXPECT_TRUE(sections.forces.empty() && sections.torques.empty());
    EXPECT_EQ(sections.forces.volume, 0.0);
    EXPECT_EQ(sections.torques.vertices.size(), 0);
  };
  expect_empty(wrench_sections({}));
  expect_empty(sections_of(Wrenches(6, 0)));
  expect_empty(sections_of(contact_wrenches(ring_grasp(2, 0.5), {})));
  expect_empty(sections_of(contact_wrenches(octahedron_grasp(0.0), {})));
  PointHull failed = cross_polytope();
  failed.status = PointHullStatus::failed;
  expect_empty(wrench_sections(failed));
  // Solid, but away from the wrenches without torque.
  Wrenches away(6, 12);
  away << Eigen::MatrixXd::Identity(6, 6), -Eigen::MatrixXd::Identity(6, 6);
  away.row(4).array() += 5.0;
  const WrenchSections sections = sections_of(away);
  EXPECT_TRUE(sections.forces.empty());
  EXPECT_NEAR(sections.torques.volume, 4.0 / 3.0, 1e-9);  // the octahedron moved with it
}

TEST(WrenchSlice, RefusesWhatIsNoSection) {
  EXPECT_THROW(wrench_slice({}), InputError);
  EXPECT_THROW(wrench_slice(cross_polytope(), {{1, 1, 2}, {}}), InputError);
  EXPECT_THROW(wrench_slice(cross_polytope(), {{1, 2, 6}, {}}), InputError);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(wrench_slice(cross_polytope(), {{1, 2, 3}, {0.0, nan, 0.0}}), InputError);
}

}  // namespace
}  // namespace prehend::test
