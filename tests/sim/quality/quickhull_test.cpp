#include "sim/quality/quickhull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/sim/quality/known_sets.h"
#include "tests/support/grasp_families.h"

namespace prehend::test {
namespace {

PointHull quickhull_of(const Wrenches& wrenches) {
  const StartSimplex start = start_simplex(ColumnSupport(wrenches), false);
  EXPECT_FALSE(start.flat);
  return quickhull(wrenches, start);
}

Wrenches random_wrenches(Random& random, int count) {
  Wrenches wrenches(6, count);
  for (double& entry : wrenches.reshaped()) entry = random.uniform(-1.0, 1.0);
  return wrenches;
}

// The columns from the last to the first.
Wrenches reversed(const Wrenches& wrenches) { return wrenches.rowwise().reverse(); }

double size_of(const Wrenches& wrenches) { return wrenches.cwiseAbs().maxCoeff(); }

// That the facets bound all columns and pass through the corners they name, which are different
// ones, and that none has a border: each ridge of five corners belongs to two facets, or, where
// slivers of no width meet, to four.
void expect_closed(const PointHull& hull, const Wrenches& wrenches, const std::string& name) {
  ASSERT_EQ(hull.status, PointHullStatus::solid) << name;
  ASSERT_EQ(hull.normals.cols(), hull.offsets.size()) << name;
  ASSERT_EQ(hull.corners.cols(), hull.offsets.size()) << name;
  const double slack = 2e-11 * size_of(wrenches);
  std::map<std::array<int, 5>, int> ridges;
  for (Eigen::Index f = 0; f < hull.offsets.size(); ++f) {
    EXPECT_NEAR(hull.normals.col(f).norm(), 1.0, 1e-12) << name;
    const Eigen::VectorXd heights = wrenches.transpose() * hull.normals.col(f);
    EXPECT_LE(heights.maxCoeff(), hull.offsets[f] + slack) << name;
    Eigen::Matrix<int, 6, 1> corners = hull.corners.col(f);
    std::sort(corners.begin(), corners.end());
    EXPECT_EQ(std::adjacent_find(corners.begin(), corners.end()), corners.end()) << name;
    for (int left_out = 0; left_out < 6; ++left_out) {
      EXPECT_NEAR(heights[corners[left_out]], hull.offsets[f], slack) << name;
      std::array<int, 5> ridge;
      std::copy_if(corners.begin(), corners.end(), ridge.begin(),
                   [&](int corner) { return corner != corners[left_out]; });
      ++ridges[ridge];
    }
  }
  for (const auto& [ridge, facets] : ridges) EXPECT_EQ(facets % 2, 0) << name;
}

TEST(Quickhull, KnownSets) {
  for (const KnownSet& set : known_sets()) {
    const PointHull hull = quickhull_of(set.wrenches);
    expect_closed(hull, set.wrenches, set.name);
    const double scale = size_of(set.wrenches);
    EXPECT_NEAR(hull.volume, set.volume, 1e-10 * set.volume) << set.name;
    EXPECT_NEAR(hull.offsets.minCoeff(), set.epsilon, 1e-13 * scale) << set.name;
    EXPECT_EQ(hull.reach, set.wrenches.colwise().norm().maxCoeff()) << set.name;
    EXPECT_EQ(hull.joggle, 0.0);
  }
}

TEST(Quickhull, NumbersOfFacets) {
  EXPECT_EQ(quickhull_of(simplex().wrenches).offsets.size(), 7);
  EXPECT_EQ(quickhull_of(cross_polytope(Wrench::Ones()).wrenches).offsets.size(), 64);
  // A cyclic polytope has as many facets as there can be (McMullen 1970): n (n - 4) (n - 5) / 6 in
  // six dimensions. Its corners are on the trigonometric moment curve.
  for (const int n : {7, 12, 25}) {
    Wrenches wrenches(6, n);
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < 3; ++k) {
        const double angle = 2.0 * std::numbers::pi * j * (k + 1) / n;
        wrenches.col(j).segment<2>(2 * k) << std::cos(angle), std::sin(angle);
      }
    }
    EXPECT_EQ(quickhull_of(wrenches).offsets.size(), n * (n - 4) * (n - 5) / 6) << n;
  }
}

// The twelve facets of a box have 32 corners each, in one plane but for rounding. Of the simplices
// that a facet is divided into nearly all have the same plane exactly.
TEST(Quickhull, FacetsInOnePlaneShareIt) {
  Random random(51);
  for (int i = 0; i < 10; ++i) {
    const PointHull hull = quickhull_of(turned(box(Wrench::Ones()), random).wrenches);
    ASSERT_EQ(hull.status, PointHullStatus::solid);
    // A cube of five dimensions cannot be divided into fewer than 67 simplices (Hughes 1993).
    EXPECT_GE(hull.offsets.size(), 12 * 67);
    std::set<std::vector<double>> planes;
    for (Eigen::Index f = 0; f < hull.offsets.size(); ++f) {
      std::vector<double> plane(hull.normals.col(f).begin(), hull.normals.col(f).end());
      plane.push_back(hull.offsets[f]);
      planes.insert(plane);
    }
    EXPECT_LE(planes.size(), 24u);
  }
}

TEST(Quickhull, AgreesWithQhullOnGrasps) {
  for (const NamedGrasp& grasp : grasp_families(52, 2)) {
    const Wrenches wrenches = contact_wrenches(grasp.contacts, {}, grasp.edges);
    if (start_simplex(ColumnSupport(wrenches), false).flat) continue;
    const PointHull hull = quickhull_of(wrenches);
    if (hull.status == PointHullStatus::failed) {
      // Thinner than what can be proved.
      EXPECT_TRUE(grasp.name.starts_with("two, nearly") || grasp.name.starts_with("near flat"));
      continue;
    }
    expect_closed(hull, wrenches, grasp.name);
    PointHull other = point_hull(wrenches);
    if (other.status != PointHullStatus::solid) other = point_hull(wrenches, HullInput::joggled);
    EXPECT_NEAR(hull.volume, other.volume, 1e-7 * other.volume) << grasp.name;
    // Slivers between near-duplicates may have any plane that leaves all wrenches on one side. With
    // the origin inside, none of these is nearer to it than the nearest facet.
    const double nearest = other.offsets.minCoeff();
    if (nearest > 1e-6) {
      EXPECT_NEAR(hull.offsets.minCoeff(), nearest, 1e-10) << grasp.name;
    } else {
      EXPECT_LE(hull.offsets.minCoeff(), 1e-6) << grasp.name;
    }
  }
}

TEST(Quickhull, AgreesWithQhullOnSoftFingers) {
  Random random(53);
  for (const double torsion : {1e-3, 0.1, 1.0}) {
    Contacts contacts = random_grasp(random, 3, 0.5);
    for (Contact& contact : contacts) {
      contact.model = ContactModel::soft_finger;
      contact.torsion = torsion;
    }
    const Wrenches wrenches = contact_wrenches(contacts, {});
    const PointHull hull = quickhull_of(wrenches);
    expect_closed(hull, wrenches, std::to_string(torsion));
    const PointHull other = point_hull(wrenches);
    EXPECT_NEAR(hull.volume, other.volume, 1e-9 * other.volume) << torsion;
    EXPECT_NEAR(hull.offsets.minCoeff(), other.offsets.minCoeff(), 1e-11) << torsion;
  }
}

TEST(Quickhull, AgreesWithQhullOnRandomWrenches) {
  Random random(54);
  for (const int count : {8, 15, 40, 80}) {
    for (const double torque : {1.0, 1e-4, 1e4}) {
      for (const double shift : {0.0, 2.0}) {
        Wrenches wrenches = random_wrenches(random, count);
        wrenches.bottomRows<3>() *= torque;
        wrenches.row(0).array() += shift;
        const PointHull hull = quickhull_of(wrenches);
        expect_closed(hull, wrenches, "random");
        const PointHull other = point_hull(wrenches);
        EXPECT_EQ(hull.offsets.size(), other.offsets.size());
        EXPECT_NEAR(hull.volume, other.volume, 1e-10 * other.volume);
        EXPECT_NEAR(hull.offsets.minCoeff(), other.offsets.minCoeff(), 1e-12 * size_of(wrenches));
      }
    }
  }
}

TEST(Quickhull, DoesNotDependOnTheOrderOfTheColumns) {
  Random random(55);
  const Wrenches generic = random_wrenches(random, 40);
  EXPECT_EQ(quickhull_of(generic).offsets.size(), quickhull_of(reversed(generic)).offsets.size());
  for (const Wrenches& wrenches :
       {generic, box(Wrench::Ones()).wrenches, contact_wrenches(cube_grasp(0.5), {})}) {
    const PointHull hull = quickhull_of(wrenches);
    const PointHull other = quickhull_of(reversed(wrenches));
    EXPECT_NEAR(other.volume, hull.volume, 1e-12 * hull.volume);
    EXPECT_NEAR(other.offsets.minCoeff(), hull.offsets.minCoeff(), 1e-13);
  }
}

// Powers of two scale without rounding.
TEST(Quickhull, ScalesExactly) {
  Random random(56);
  const Wrenches wrenches = random_wrenches(random, 30);
  const PointHull hull = quickhull_of(wrenches);
  for (const int exponent : {-140, -20, 3, 140}) {
    const PointHull scaled = quickhull_of(std::ldexp(1.0, exponent) * wrenches);
    EXPECT_EQ(scaled.volume, std::ldexp(hull.volume, 6 * exponent)) << exponent;
    EXPECT_EQ(scaled.offsets, std::ldexp(1.0, exponent) * hull.offsets) << exponent;
    EXPECT_EQ(scaled.normals, hull.normals) << exponent;
    EXPECT_EQ(scaled.corners, hull.corners) << exponent;
  }
}

// Volumes that are no normal doubles are not computed.
TEST(Quickhull, ExtremeSizesAreNotProved) {
  for (const double size : {1e-60, 1e60}) {
    EXPECT_EQ(quickhull_of(size * simplex().wrenches).status, PointHullStatus::failed) << size;
  }
}

// Columns 0 to 19 are inside, the next 64 are the corners of a box, and the last 64 are again.
TEST(Quickhull, CopiesAndPointsInsideAreNoCorners) {
  Random random(57);
  const Wrenches corners = box(Wrench::Ones()).wrenches;
  Wrenches wrenches(6, 148);
  wrenches << 0.9 * random_wrenches(random, 20), corners, corners;
  const PointHull hull = quickhull_of(wrenches);
  expect_closed(hull, wrenches, "copies");
  EXPECT_NEAR(hull.volume, 64.0, 1e-10);
  EXPECT_GE(hull.corners.minCoeff(), 20);
  const std::set<int> used(hull.corners.data(), hull.corners.data() + hull.corners.size());
  EXPECT_EQ(used.size(), 64u);
}

// Pairs of wrenches at all distances around what counts as rounding: what is said is right.
TEST(Quickhull, NearDuplicatesAreRightOrNotProved) {
  Random random(58);
  int solid = 0;
  for (int digits = 6; digits <= 16; ++digits) {
    const Wrenches once = random_wrenches(random, 30);
    Wrenches wrenches(6, 60);
    wrenches << once, once + std::pow(10.0, -digits) * random_wrenches(random, 30);
    const PointHull hull = quickhull_of(wrenches);
    if (hull.status != PointHullStatus::solid) continue;
    ++solid;
    expect_closed(hull, wrenches, std::to_string(digits));
    // The hull moves by 10^-digits sqrt(6) at most; its volume by that times the surface, which is
    // less than 100 times the volume.
    const PointHull other = quickhull_of(once);
    EXPECT_NEAR(hull.volume, other.volume, (300.0 * std::pow(10.0, -digits) + 1e-8) * other.volume);
  }
  EXPECT_GE(solid, 8);
}

// Boxes that become thinner and thinner. Once the errors of the planes show in the volume, nothing
// is said.
TEST(Quickhull, ThinBoxesAreRightOrNotProved) {
  Random random(59);
  for (const double thickness : {1e-2, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
    Wrench half = Wrench::Ones();
    half[2] = thickness;
    const KnownSet set = turned(box(half), random);
    const PointHull hull = quickhull_of(set.wrenches);
    const bool solid = hull.status == PointHullStatus::solid;
    EXPECT_TRUE(solid || thickness < 1e-5) << thickness;
    if (solid) {
      EXPECT_NEAR(hull.volume, set.volume, 2e-8 * set.volume) << thickness;
    }
    // Rounding of the coordinates alone may change the volume by more.
    EXPECT_FALSE(solid && thickness < 1e-7) << thickness;
  }
}

TEST(Quickhull, SameBitsEachTime) {
  for (const NamedGrasp& grasp : grasp_families(60, 1)) {
    const Wrenches wrenches = contact_wrenches(grasp.contacts, {}, grasp.edges);
    if (start_simplex(ColumnSupport(wrenches), false).flat) continue;
    const PointHull first = quickhull_of(wrenches);
    const PointHull second = quickhull_of(wrenches);
    EXPECT_EQ(first.volume, second.volume) << grasp.name;
    EXPECT_EQ(first.offsets, second.offsets) << grasp.name;
    EXPECT_EQ(first.corners, second.corners) << grasp.name;
  }
}

// Points in space: inside and on a ball, and on the lattice of a cube, where most are in one plane
// or on one line with others.
std::vector<Eigen::Matrix3Xd> clouds_in_space(Random& random) {
  std::vector<Eigen::Matrix3Xd> clouds;
  for (const int count : {4, 5, 20, 300}) {
    Eigen::Matrix3Xd cloud(3, count);
    for (double& entry : cloud.reshaped()) entry = random.uniform(-1.0, 1.0);
    clouds.push_back(cloud);
    clouds.push_back(cloud.colwise().normalized());
  }
  Eigen::Matrix3Xd lattice(3, 125);
  for (int i = 0; i < 125; ++i) lattice.col(i) << i % 5, i / 5 % 5, i / 25;
  clouds.push_back(lattice);
  const Eigen::AngleAxisd turn(0.7, Eigen::Vector3d(1.0, 2.0, -0.5).normalized());
  clouds.emplace_back(turn.toRotationMatrix() * lattice);
  return clouds;
}

TEST(Quickhull, InSpaceIsThatOfQhull) {
  Random random(61);
  for (const Eigen::Matrix3Xd& cloud : clouds_in_space(random)) {
    const PointHull hull = quickhull(cloud);
    const PointHull other = point_hull(cloud);
    ASSERT_EQ(hull.status, PointHullStatus::solid) << cloud.cols();
    EXPECT_NEAR(hull.volume, other.volume, 1e-10 * other.volume) << cloud.cols();
    EXPECT_EQ(hull.reach, other.reach);
    std::map<std::array<int, 2>, int> edges;
    for (Eigen::Index f = 0; f < hull.offsets.size(); ++f) {
      const Eigen::VectorXd heights = cloud.transpose() * hull.normals.col(f);
      EXPECT_LE(heights.maxCoeff(), hull.offsets[f] + 1e-10) << cloud.cols();
      for (int k = 0; k < 3; ++k) {
        const int from = hull.corners(k, f);
        const int to = hull.corners((k + 1) % 3, f);
        EXPECT_NEAR(heights[from], hull.offsets[f], 1e-10) << cloud.cols();
        ++edges[{std::min(from, to), std::max(from, to)}];
      }
    }
    // Slivers of no width may meet in one edge.
    for (const auto& [edge, faces] : edges) EXPECT_EQ(faces % 2, 0) << cloud.cols();
  }
}

TEST(Quickhull, OfWhatIsFlatInSpaceNothingIsSaid) {
  Eigen::Matrix3Xd flat(3, 9);
  for (int i = 0; i < 9; ++i) flat.col(i) << i % 3, i / 3, 1.0;
  EXPECT_EQ(quickhull(flat).status, PointHullStatus::failed);
  EXPECT_EQ(quickhull(Eigen::Matrix3Xd(flat.leftCols(3))).status, PointHullStatus::failed);
  EXPECT_EQ(quickhull(Eigen::Matrix3Xd(Eigen::Matrix3Xd::Ones(3, 5))).status,
            PointHullStatus::failed);
  EXPECT_EQ(quickhull(Eigen::Matrix3Xd(3, 0)).status, PointHullStatus::failed);
  flat(2, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(quickhull(flat).status, PointHullStatus::failed);
}

}  // namespace
}  // namespace prehend::test
