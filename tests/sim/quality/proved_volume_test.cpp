#include "sim/quality/proved_volume.h"

#include <optional>

#include <gtest/gtest.h>

#include "tests/sim/quality/known_sets.h"
#include "tests/support/grasp_families.h"

namespace prehend::test {
namespace {

// The hull without one of its facets.
PointHull without(const PointHull& hull, Eigen::Index facet) {
  PointHull fewer = hull;
  const Eigen::Index last = hull.offsets.size() - 1;
  fewer.normals.col(facet) = hull.normals.col(last);
  fewer.offsets[facet] = hull.offsets[last];
  fewer.corners.col(facet) = hull.corners.col(last);
  fewer.normals.conservativeResize(Eigen::NoChange, last);
  fewer.offsets.conservativeResize(last);
  fewer.corners.conservativeResize(Eigen::NoChange, last);
  return fewer;
}

// The hull with one of its facets a second time.
PointHull with_twice(const PointHull& hull, Eigen::Index facet) {
  PointHull more = hull;
  const Eigen::Index count = hull.offsets.size();
  more.normals.conservativeResize(Eigen::NoChange, count + 1);
  more.offsets.conservativeResize(count + 1);
  more.corners.conservativeResize(Eigen::NoChange, count + 1);
  more.normals.col(count) = hull.normals.col(facet);
  more.offsets[count] = hull.offsets[facet];
  more.corners.col(count) = hull.corners.col(facet);
  return more;
}

// The facets that qhull finds are proved as well, and the volumes are those of the closed forms.
TEST(ProvedVolume, OfKnownSets) {
  for (const KnownSet& set : known_sets()) {
    const std::optional<double> volume = proved_volume(set.wrenches, point_hull(set.wrenches));
    ASSERT_TRUE(volume) << set.name;
    EXPECT_NEAR(*volume, set.volume, 1e-10 * set.volume) << set.name;
  }
}

TEST(ProvedVolume, RefusesMissingAndRepeatedFacets) {
  for (const KnownSet& set : {simplex(), cross_polytope(Wrench::Ones()), box(Wrench::Ones())}) {
    const PointHull hull = point_hull(set.wrenches);
    for (Eigen::Index facet = 0; facet < hull.offsets.size(); facet += 5) {
      EXPECT_FALSE(proved_volume(set.wrenches, without(hull, facet))) << set.name;
      EXPECT_FALSE(proved_volume(set.wrenches, with_twice(hull, facet))) << set.name;
    }
  }
  EXPECT_FALSE(proved_volume(simplex().wrenches, {}));
}

TEST(ProvedVolume, RefusesAPlaneThatIsOff) {
  for (const KnownSet& set : {simplex(), scaled(box(Wrench::Ones()), 1e3)}) {
    const PointHull hull = point_hull(set.wrenches);
    const double scale = set.wrenches.cwiseAbs().maxCoeff();
    for (const double shift : {-1e-10, 1e-10}) {
      PointHull moved = hull;
      moved.offsets[3] += shift * scale;
      EXPECT_FALSE(proved_volume(set.wrenches, moved)) << set.name;
      PointHull tilted = hull;
      tilted.normals.col(3) += shift * Wrench::Unit(2);
      tilted.normals.col(3) += shift * Wrench::Unit(4);
      EXPECT_FALSE(proved_volume(set.wrenches, tilted)) << set.name;
    }
    EXPECT_TRUE(proved_volume(set.wrenches, hull)) << set.name;
  }
}

// What is rounding in a cube changes the volume of a box that is 1e-5 thick.
TEST(ProvedVolume, RefusesAnErrorThatTheVolumeShows) {
  Wrench half = Wrench::Ones();
  for (const double thickness : {1.0, 1e-5}) {
    half[1] = thickness;
    const Wrenches wrenches = box(half).wrenches;
    PointHull hull = point_hull(wrenches);
    EXPECT_TRUE(proved_volume(wrenches, hull)) << thickness;
    hull.offsets[0] += 1e-11;
    EXPECT_EQ(proved_volume(wrenches, hull).has_value(), thickness == 1.0);
  }
}

TEST(ProvedVolume, RefusesAWrongCorner) {
  const Wrenches wrenches = simplex().wrenches;
  PointHull hull = point_hull(wrenches);
  // Of the seven corners, the one that facet 0 does not have.
  hull.corners(0, 0) = 21 - hull.corners.col(0).sum();
  EXPECT_FALSE(proved_volume(wrenches, hull));
}

TEST(ProvedVolume, RefusesAHullThatMissesAPoint) {
  const Wrenches wrenches = simplex().wrenches;
  Wrenches more(6, 8);
  more << wrenches, Wrench::Constant(1.0 / 6.0 + 1e-9);
  EXPECT_FALSE(proved_volume(more, point_hull(wrenches)));
  more.col(7) = Wrench::Constant(1.0 / 6.0 - 1e-9);
  EXPECT_TRUE(proved_volume(more, point_hull(wrenches)));
}

// A facet divided in two ways at once: it is covered twice.
TEST(ProvedVolume, RefusesFacetsThatOverlap) {
  const Wrenches wrenches = box(Wrench::Ones()).wrenches;
  PointHull hull = point_hull(wrenches);
  const Wrenches turned = wrenches.rowwise().reverse();
  const PointHull other = point_hull(turned);
  const Wrench normal = Wrench::Unit(0);
  for (Eigen::Index f = 0; f < other.offsets.size(); ++f) {
    if (other.normals.col(f).dot(normal) < 0.5) continue;
    hull = with_twice(hull, 0);
    const Eigen::Index last = hull.offsets.size() - 1;
    hull.normals.col(last) = other.normals.col(f);
    hull.offsets[last] = other.offsets[f];
    hull.corners.col(last) = 63 - other.corners.col(f).array();
  }
  EXPECT_FALSE(proved_volume(wrenches, hull));
}

}  // namespace
}  // namespace prehend::test
