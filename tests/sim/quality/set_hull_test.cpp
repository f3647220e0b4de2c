#include "sim/quality/set_hull.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/quality/wrench_hull.h"
#include "sim/quality/wrench_space.h"
#include "tests/sim/quality/known_sets.h"
#include "tests/support/grasp_families.h"

namespace prehend::test {
namespace {

// A box by its support function: ties go to the positive side.
class Box final : public SupportMap {
 public:
  explicit Box(const Wrench& half) : half_(half) {}

  Wrench support(const Wrench& direction) const override {
    return (direction.array() < 0.0).select(-half_, half_);
  }

 private:
  Wrench half_;
};

class Ball final : public SupportMap {
 public:
  Ball(double radius, const Wrench& centre) : radius_(radius), centre_(centre) {}

  Wrench support(const Wrench& direction) const override {
    return centre_ + radius_ * direction.normalized();
  }

 private:
  double radius_;
  Wrench centre_;
};

TEST(SetHull, PolytopesAreFoundCompletely) {
  for (const KnownSet& set : known_sets()) {
    const SetHull hull = set_hull(ColumnSupport(set.wrenches));
    EXPECT_TRUE(hull.complete) << set.name;
    // Each facet may be short by 1e-9 of the size: felt where the set is thin.
    const double thinnest = set.wrenches.cwiseAbs().rowwise().maxCoeff().minCoeff();
    const double scale = set.wrenches.cwiseAbs().maxCoeff();
    const double tolerance = 1e-8 * scale / thinnest * set.volume;
    EXPECT_NEAR(hull.volume_lower, set.volume, tolerance) << set.name;
    EXPECT_NEAR(hull.volume_upper, set.volume, tolerance) << set.name;
    EXPECT_LE(hull.volume_lower, hull.volume_upper) << set.name;
    EXPECT_NEAR(hull.hull.offsets.minCoeff(), set.epsilon, 1e-8 * scale) << set.name;
  }
}

TEST(SetHull, BoxOfItsSupportFunction) {
  Wrench half;
  half << 1.0, 0.5, 2.0, 3.0, 0.25, 1.5;
  const SetHull hull = set_hull(Box(half));
  EXPECT_TRUE(hull.complete);
  EXPECT_NEAR(hull.volume_lower, 64.0 * half.prod(), 1e-9);
  EXPECT_NEAR(hull.volume_upper, 64.0 * half.prod(), 1e-9);
}

// A ball of radius r in six dimensions has the volume pi^3 / 6 r^6, wherever it is.
TEST(SetHull, BallIsBracketed) {
  for (const double radius : {1e-3, 1.0, 50.0}) {
    const double volume = std::pow(std::numbers::pi, 3) / 6.0 * std::pow(radius, 6);
    double lower = 0.0;
    double upper = std::numeric_limits<double>::infinity();
    for (const int points : {20, 60, 180}) {
      const SetHull hull = set_hull(Ball(radius, 0.4 * radius * Wrench::Ones()),
                                    {.relative_tolerance = 1e-9, .max_points = points});
      EXPECT_FALSE(hull.complete);
      EXPECT_LE(hull.volume_lower, volume) << points << " points";
      EXPECT_GE(hull.volume_upper, volume) << points << " points";
      EXPECT_GT(hull.volume_lower, lower) << points << " points";
      EXPECT_LT(hull.volume_upper, upper) << points << " points";
      lower = hull.volume_lower;
      upper = hull.volume_upper;
    }
  }
}

TEST(SetHull, LooseToleranceEndsEarlier) {
  const Ball ball(1.0, Wrench::Zero());
  const SetHull hull = set_hull(ball, {.relative_tolerance = 0.5, .max_points = 500});
  EXPECT_TRUE(hull.complete);
  const double volume = std::pow(std::numbers::pi, 3) / 6.0;
  EXPECT_LE(hull.volume_lower, volume);
  EXPECT_GE(hull.volume_upper, volume);
  // No facet is farther than the tolerance from the sphere.
  EXPECT_GE(hull.hull.offsets.minCoeff(), 0.5 - 1e-12);
}

TEST(SetHull, VolumeOfPyramidGraspsIsThatOfTheFullHull) {
  int checked = 0;
  for (const NamedGrasp& grasp : grasp_families(41, 1)) {
    if (grasp.contacts.size() > 8) continue;
    const Wrenches wrenches = contact_wrenches(grasp.contacts, {}, grasp.edges);
    const WrenchHull full = wrench_hull(wrenches);
    if (!full.force_closure() || full.min_offset < 1e-4) continue;
    ++checked;
    const SetHull hull =
        set_hull(*wrench_space(grasp.contacts, {}, {.edges = grasp.edges}), {.max_points = 500});
    EXPECT_TRUE(hull.complete) << grasp.name;
    // Facets 1e-9 short of the set, where the set may be 1e-4 thick.
    EXPECT_NEAR(hull.volume_lower, full.volume, 1e-4 * full.volume) << grasp.name;
    EXPECT_NEAR(hull.volume_upper, full.volume, 1e-4 * full.volume) << grasp.name;
    EXPECT_NEAR(hull.hull.offsets.minCoeff(), full.min_offset, 1e-8) << grasp.name;
  }
  EXPECT_GT(checked, 5);
}

// The full hull of four pyramids of 128 edges has hundreds of thousands of facets, and that of
// 1,024 far more. What is made of them is limited, and the bounds still hold the volumes of
// pyramids of 8 edges, which are inside, and of the exact cones, around them.
TEST(SetHull, FacetsOfPyramidsWithManyEdgesAreLimited) {
  const Contacts cube = cube_grasp(0.5);
  const Contacts contacts = {cube[0], cube[3], cube[5], cube[6]};
  const double inside = set_hull(*wrench_space(contacts, {}, {.edges = 8})).volume_lower;
  const double around =
      set_hull(*wrench_space(contacts, {}, {.cone = FrictionCone::exact})).volume_upper;
  for (const int edges : {128, 1024}) {
    const auto set = wrench_space(contacts, {}, {.edges = edges});
    for (const int limit : {3000, 30000}) {
      const SetHull hull = set_hull(*set, {.max_facets = limit});
      EXPECT_FALSE(hull.complete);
      EXPECT_LE(hull.hull.offsets.size(), limit);
      EXPECT_GT(hull.hull.offsets.size(), limit / 10);
      EXPECT_LE(hull.volume_lower, around);
      EXPECT_GE(hull.volume_upper, inside);
      EXPECT_LT(hull.volume_lower, hull.volume_upper);
      EXPECT_GT(hull.volume_lower, 0.2 * hull.volume_upper);
    }
    // Epsilon is that of all corners.
    EXPECT_EQ(grasp_epsilon(contacts, {}, {.edges = edges}).status, EpsilonStatus::converged);
  }
}

TEST(SetHull, FlatSetsHaveNoVolume) {
  Wrench half = Wrench::Ones();
  half[3] = 0.0;
  const Ball point(0.0, Wrench::Ones());
  for (const SetHull& hull :
       {set_hull(Box(half)), set_hull(point),
        set_hull(*wrench_space(ring_grasp(2, 0.5), {}, {.norm = WrenchNorm::linf}))}) {
    EXPECT_TRUE(hull.complete);
    EXPECT_EQ(hull.hull.status, PointHullStatus::flat);
    EXPECT_EQ(hull.volume_lower, 0.0);
    EXPECT_EQ(hull.volume_upper, 0.0);
  }
}

TEST(SetHull, RejectsAToleranceThatIsNotPositive) {
  const Box box(Wrench::Ones());
  for (const double tolerance : {0.0, -1.0, std::nan("")}) {
    EXPECT_THROW(set_hull(box, {.relative_tolerance = tolerance}), InputError);
  }
}

}  // namespace
}  // namespace prehend::test
