#include "sim/quality/epsilon.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/quality/support.h"
#include "tests/sim/quality/known_sets.h"
#include "tests/support/grasp_families.h"

namespace prehend::test {
namespace {

TEST(Epsilon, KnownSets) {
  for (const KnownSet& set : known_sets()) {
    const EpsilonBracket bracket = epsilon_l1(set.wrenches);
    if (set.epsilon <= 0.0) {
      EXPECT_EQ(bracket.status, EpsilonStatus::no_force_closure) << set.name;
      EXPECT_EQ(bracket.upper, 0.0) << set.name;
      continue;
    }
    // Rounding of the set itself: the moved box loses six digits of its offset.
    const double tolerance = 1e-9 * set.epsilon + 1e-14 * set.wrenches.cwiseAbs().maxCoeff();
    EXPECT_EQ(bracket.status, EpsilonStatus::converged) << set.name;
    EXPECT_NEAR(bracket.lower, set.epsilon, tolerance) << set.name;
    EXPECT_NEAR(bracket.upper, set.epsilon, tolerance) << set.name;
  }
}

TEST(Epsilon, OriginOnTheBorderIsNoForceClosure) {
  for (const double inside : {0.0, 1e-15, 1e-12}) {
    const EpsilonBracket bracket = epsilon_l1(moved(box(Wrench::Ones()), 1.0 - inside).wrenches);
    EXPECT_EQ(bracket.status, EpsilonStatus::no_force_closure) << inside;
  }
}

TEST(Epsilon, TooLittleToSpanSixDimensions) {
  EXPECT_EQ(epsilon_l1(Wrenches(6, 0)).status, EpsilonStatus::no_force_closure);
  EXPECT_EQ(epsilon_l1(Wrenches::Zero(6, 9)).status, EpsilonStatus::no_force_closure);
  EXPECT_EQ(epsilon_l1(Wrenches::Ones(6, 9)).status, EpsilonStatus::no_force_closure);
  Random random(4);
  for (int missing = 0; missing < 6; ++missing) {
    KnownSet flat = box(Wrench::Ones());
    flat.wrenches.row(missing).setZero();
    EXPECT_EQ(epsilon_l1(flat.wrenches).status, EpsilonStatus::no_force_closure);
    EXPECT_EQ(epsilon_l1(turned(flat, random).wrenches).status, EpsilonStatus::no_force_closure);
  }
}

TEST(Epsilon, TwoPointContactsNeverHold) {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    const double friction = random.uniform(0.1, 2.0);
    Contacts contacts = rotated(ring_grasp(2, friction), random.rotation());
    EXPECT_FALSE(epsilon_l1(contact_wrenches(contacts, {})).force_closure());
    contacts = doubled(random, contacts, 0.0);
    EXPECT_FALSE(epsilon_l1(contact_wrenches(contacts, {})).force_closure());
  }
}

TEST(Epsilon, WeakestIsTheDisturbanceOpposedByTheNearestFacet) {
  Wrench lengths = Wrench::Ones();
  lengths[4] = 0.5;
  const EpsilonBracket bracket = epsilon_l1(moved(box(lengths), 0.0).wrenches);
  EXPECT_NEAR(bracket.weakest.norm(), 0.5, 1e-14);
  EXPECT_NEAR(std::abs(bracket.weakest[4]), 0.5, 1e-14);
  // Pushed along it, the set answers with no more than epsilon.
  const Wrenches wrenches = contact_wrenches(cube_grasp(0.6), {});
  const EpsilonBracket cube = epsilon_l1(wrenches);
  const double answer = (-cube.weakest.normalized().transpose() * wrenches).maxCoeff();
  EXPECT_NEAR(answer, cube.upper, 1e-14);
}

TEST(Epsilon, BracketHoldsWhereverGrowthEnds) {
  for (const NamedGrasp& grasp : grasp_families(8, 3)) {
    const Wrenches wrenches = contact_wrenches(grasp.contacts, {}, grasp.edges);
    const EpsilonBracket full = epsilon_l1(wrenches);
    for (const int facets : {0, 7, 20, 60, 150, 500}) {
      const EpsilonBracket part = epsilon_l1(wrenches, {.max_facets = facets});
      EXPECT_LE(part.lower, full.upper) << grasp.name << " after " << facets;
      EXPECT_GE(part.upper, full.lower) << grasp.name << " after " << facets;
      EXPECT_LE(part.lower, part.upper) << grasp.name << " after " << facets;
      EXPECT_TRUE(full.force_closure() || !part.force_closure()) << grasp.name;
    }
  }
}

TEST(Epsilon, BracketTightensWithFacets) {
  const Wrenches wrenches = contact_wrenches(octahedron_grasp(0.5), {});
  double width = HUGE_VAL;
  for (const int facets : {7, 50, 200, 1000, 5000}) {
    const EpsilonBracket bracket = epsilon_l1(wrenches, {.max_facets = facets});
    EXPECT_LE(bracket.upper - bracket.lower, width);
    width = bracket.upper - bracket.lower;
  }
  EXPECT_LE(width, 1e-9);
}

TEST(Epsilon, CutoffStopsOnlyWhatIsBelowIt) {
  for (const NamedGrasp& grasp : grasp_families(9, 3)) {
    const Wrenches wrenches = contact_wrenches(grasp.contacts, {}, grasp.edges);
    const EpsilonBracket full = epsilon_l1(wrenches);
    if (!full.force_closure()) continue;
    const EpsilonBracket above = epsilon_l1(wrenches, {.cutoff = 0.99 * full.lower});
    EXPECT_EQ(above.status, EpsilonStatus::converged) << grasp.name;
    EXPECT_EQ(above.upper, full.upper) << grasp.name;
    const EpsilonBracket below = epsilon_l1(wrenches, {.cutoff = 2.0 * full.upper});
    if (below.status == EpsilonStatus::below_cutoff) {
      EXPECT_LT(below.upper, 2.0 * full.upper) << grasp.name;
    } else {
      EXPECT_EQ(below.status, EpsilonStatus::converged) << grasp.name;
    }
    EXPECT_GE(below.upper, full.lower) << grasp.name;
    EXPECT_LE(below.lower, full.upper) << grasp.name;
  }
}

TEST(Epsilon, LooseToleranceIsKept) {
  for (const NamedGrasp& grasp : grasp_families(10, 2)) {
    const Wrenches wrenches = contact_wrenches(grasp.contacts, {}, grasp.edges);
    const EpsilonBracket full = epsilon_l1(wrenches);
    const EpsilonBracket loose = epsilon_l1(wrenches, {.relative_tolerance = 0.1});
    EXPECT_EQ(loose.force_closure(), full.force_closure()) << grasp.name;
    EXPECT_LE(loose.upper - loose.lower, 0.1 * loose.upper) << grasp.name;
    EXPECT_LE(loose.lower, full.upper) << grasp.name;
    EXPECT_GE(loose.upper, full.lower) << grasp.name;
  }
}

TEST(Epsilon, SameBitsEachTime) {
  for (const NamedGrasp& grasp : grasp_families(11, 1)) {
    const Wrenches wrenches = contact_wrenches(grasp.contacts, {}, grasp.edges);
    const EpsilonBracket first = epsilon_l1(wrenches);
    const EpsilonBracket second = epsilon_l1(wrenches);
    EXPECT_EQ(first.lower, second.lower) << grasp.name;
    EXPECT_EQ(first.upper, second.upper) << grasp.name;
    EXPECT_EQ(first.weakest, second.weakest) << grasp.name;
  }
}

TEST(Epsilon, RejectsNonsense) {
  Wrenches wrenches = box(Wrench::Ones()).wrenches;
  EXPECT_THROW(epsilon_l1(wrenches, {.relative_tolerance = -1.0}), InputError);
  wrenches(3, 17) = std::numeric_limits<double>::infinity();
  try {
    epsilon_l1(wrenches);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "wrenches[17]: not finite");
  }
}

// An ellipsoid with semi-axes along the coordinate axes: smooth, so that growth never ends exactly.
class Ellipsoid final : public SupportMap {
 public:
  Ellipsoid(const Wrench& semi_axes, const Wrench& centre)
      : semi_axes_(semi_axes), centre_(centre) {}

  Wrench support(const Wrench& direction) const override {
    const Wrench stretched = semi_axes_.cwiseProduct(direction);
    return centre_ + semi_axes_.cwiseProduct(stretched) / stretched.norm();
  }

 private:
  Wrench semi_axes_;
  Wrench centre_;
};

TEST(Epsilon, SmoothSetIsBracketed) {
  Wrench semi_axes;
  semi_axes << 1.0, 0.9, 0.8, 0.7, 0.6, 0.05;
  const Ellipsoid ellipsoid(semi_axes, Wrench::Zero());
  const EpsilonBracket bracket = epsilon(ellipsoid, {.relative_tolerance = 1e-2});
  EXPECT_EQ(bracket.status, EpsilonStatus::converged);
  EXPECT_LE(bracket.lower, 0.05);
  EXPECT_GE(bracket.upper, 0.05 * (1.0 - 1e-12));
  EXPECT_GE(bracket.lower, 0.99 * bracket.upper);
}

// Descent changes the upper bound only, and on an ellipsoid beside the origin it finds the minimum
// long before the facets do.
TEST(Epsilon, DescentLowersTheUpperBound) {
  Wrench semi_axes;
  semi_axes << 1.0, 0.9, 0.8, 0.7, 0.6, 0.5;
  const Ellipsoid ellipsoid(semi_axes, Wrench::Constant(0.1));
  const EpsilonBracket fine = epsilon(ellipsoid, {.relative_tolerance = 1e-3});
  const EpsilonBracket plain = epsilon(ellipsoid, {.max_facets = 1000});
  const EpsilonBracket lower = epsilon(ellipsoid, {.max_facets = 1000, .descent_steps = 12});
  EXPECT_LT(lower.upper, plain.upper);
  EXPECT_GE(lower.upper, fine.lower);
  EXPECT_LE(lower.upper, 1.001 * fine.upper);
  EXPECT_LE(lower.lower, fine.upper);
  EXPECT_NEAR(lower.weakest.norm(), lower.upper, 1e-14);
  // Along its weakest disturbance the set reaches exactly as far as the upper bound.
  const Wrench normal = -lower.weakest.normalized();
  EXPECT_NEAR(normal.dot(ellipsoid.support(normal)), lower.upper, 1e-14);
}

TEST(Epsilon, DescentFindsTheProofThatThereIsNone) {
  const Ellipsoid ball(Wrench::Ones(), Wrench::Constant(0.41));  // its centre 1.004 away
  const EpsilonBracket bracket = epsilon(ball, {.max_facets = 0, .descent_steps = 50});
  EXPECT_EQ(bracket.status, EpsilonStatus::no_force_closure);
}

TEST(Epsilon, SmoothSetRunsIntoItsLimit) {
  const Ellipsoid ball(Wrench::Ones(), Wrench::Unit(2) * 0.5);
  const EpsilonBracket bracket = epsilon(ball, {.relative_tolerance = 1e-9, .max_facets = 20000});
  EXPECT_EQ(bracket.status, EpsilonStatus::limit);
  EXPECT_GT(bracket.lower, 0.0);
  EXPECT_LE(bracket.lower, 0.5);
  EXPECT_GE(bracket.upper, 0.5 * (1.0 - 1e-12));
}

TEST(Epsilon, SmoothSetBesideTheOrigin) {
  const Ellipsoid ball(Wrench::Ones(), Wrench::Ones());
  EXPECT_EQ(epsilon(ball).status, EpsilonStatus::no_force_closure);
}

}  // namespace
}  // namespace prehend::test
