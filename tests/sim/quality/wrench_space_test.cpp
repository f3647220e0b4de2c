#include "sim/quality/wrench_space.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/quality/wrench_hull.h"
#include "tests/support/grasp_families.h"

namespace prehend::test {
namespace {

// Between bounds of one and the same value, for sets of size 1 to 30.
constexpr double kRounding = 1e-13;

constexpr WrenchSpaceOptions kExact = {.cone = FrictionCone::exact};
constexpr WrenchSpaceOptions kSum = {.norm = WrenchNorm::linf};
constexpr WrenchSpaceOptions kExactSum = {.norm = WrenchNorm::linf, .cone = FrictionCone::exact};

Wrench random_direction(Random& random) {
  Wrench direction;
  for (double& entry : direction) entry = random.uniform(-1.0, 1.0);
  return direction.normalized();
}

Contacts soft(Contacts contacts, double torsion) {
  for (Contact& contact : contacts) {
    contact.model = ContactModel::soft_finger;
    contact.torsion = torsion;
  }
  return contacts;
}

double value(const SupportMap& set, const Wrench& direction) {
  return direction.dot(set.support(direction));
}

// Few contacts of several models, most of them in force closure.
std::vector<Contacts> small_grasps() {
  Random random(51);
  std::vector<Contacts> grasps;
  for (int i = 0; i < 4; ++i) {
    const double friction = random.uniform(0.4, 1.0);
    const auto turn = [&](const Contacts& contacts) {
      return rotated(contacts, random.rotation());
    };
    grasps.push_back(turn(ring_grasp(3, friction)));
    grasps.push_back(random_grasp(random, 3, friction));
    grasps.push_back(soft(turn(ring_grasp(2, friction)), 0.3));
    grasps.push_back(turn(ring_grasp(3, friction)));
    grasps.back()[0].model = ContactModel::frictionless;
  }
  return grasps;
}

// Every sum of one column of each contact, each with the origin among its columns or without.
Wrenches all_sums(const Contacts& contacts, int edges, UnitForce force) {
  Wrenches sums = Wrenches::Zero(6, 1);
  for (const Contact& contact : contacts) {
    Wrenches columns = contact_wrenches({&contact, 1}, {}, edges);
    if (force == UnitForce::at_most) {
      columns.conservativeResize(Eigen::NoChange, columns.cols() + 1);
      columns.rightCols<1>().setZero();
    }
    Wrenches next(6, sums.cols() * columns.cols());
    for (Eigen::Index j = 0; j < columns.cols(); ++j) {
      next.middleCols(j * sums.cols(), sums.cols()) = sums.colwise() + columns.col(j);
    }
    sums = next;
  }
  return sums;
}

TEST(WrenchSpace, SumOfPyramidsIsTheHullOfAllSums) {
  int hold = 0;
  for (const UnitForce force : {UnitForce::at_most, UnitForce::exactly}) {
    for (const Contacts& contacts : small_grasps()) {
      for (const int edges : {3, 4}) {
        const WrenchHull hull = wrench_hull(all_sums(contacts, edges, force));
        const WrenchSpaceOptions space = {.norm = WrenchNorm::linf, .edges = edges, .force = force};
        const EpsilonBracket bracket = grasp_epsilon(contacts, {}, space);
        ASSERT_EQ(bracket.force_closure(), hull.force_closure());
        if (!hull.force_closure()) continue;
        ++hold;
        EXPECT_EQ(bracket.status, EpsilonStatus::converged);
        EXPECT_NEAR(bracket.lower, hull.min_offset, 1e-9);
        EXPECT_NEAR(bracket.upper, hull.min_offset, 1e-9);
      }
    }
  }
  EXPECT_GT(hold, 20);
}

TEST(WrenchSpace, SupportIsTheSumOrTheBestOfTheContacts) {
  Random random(52);
  Contacts contacts = random_grasp(random, 5, 0.7);
  contacts[1].model = ContactModel::frictionless;
  contacts[2].model = ContactModel::soft_finger;
  contacts[2].torsion = 0.2;
  for (const FrictionCone cone : {FrictionCone::pyramid, FrictionCone::exact}) {
    for (const UnitForce force : {UnitForce::at_most, UnitForce::exactly}) {
      const auto sum = wrench_space(contacts, {}, {WrenchNorm::linf, cone, 8, force});
      const auto hull = wrench_space(contacts, {}, {WrenchNorm::l1, cone, 8, force});
      for (int i = 0; i < 100; ++i) {
        const Wrench direction = random_direction(random);
        double total = 0.0;
        double best = -std::numeric_limits<double>::infinity();
        for (const Contact& contact : contacts) {
          const double one =
              value(*wrench_space({&contact, 1}, {}, {WrenchNorm::l1, cone, 8, force}), direction);
          total += one;
          best = std::max(best, one);
        }
        EXPECT_NEAR(value(*sum, direction), total, 1e-14);
        EXPECT_NEAR(value(*hull, direction), best, 1e-14);
      }
    }
  }
}

// The farthest of the normal force and the rim of its cone, in closed form: n . p + friction
// sqrt(|p_t|^2 + (torsion w . n)^2), p the velocity of the contact point for a twist (v, w).
TEST(WrenchSpace, ExactConeHasItsClosedForm) {
  Random random(53);
  for (const ContactModel model :
       {ContactModel::frictionless, ContactModel::point, ContactModel::soft_finger}) {
    const Contact contact = {{0.3, -0.2, 0.5}, random.direction(), 0.6, model, 0.25};
    const WrenchFrame frame = {.torque_origin = {0.1, 0.1, 0.0}, .torque_scale = 2.0};
    const auto set = wrench_space({&contact, 1}, frame,
                                  {.cone = FrictionCone::exact, .force = UnitForce::exactly});
    for (int i = 0; i < 100; ++i) {
      const Wrench twist = random_direction(random);
      const Eigen::Vector3d turning = frame.torque_scale * twist.tail<3>();
      const Eigen::Vector3d velocity =
          twist.head<3>() + turning.cross(contact.position - frame.torque_origin);
      const double along = velocity.dot(contact.normal);
      const double slip = (velocity - along * contact.normal).norm();
      const double spin = turning.dot(contact.normal);
      double expected = along;
      if (model == ContactModel::point) expected += 0.6 * slip;
      if (model == ContactModel::soft_finger) expected += 0.6 * std::hypot(slip, 0.25 * spin);
      EXPECT_NEAR(value(*set, twist), expected, 1e-14);
    }
  }
}

// Along the normal nothing but rounding tells where on the rim of the cone the farthest point is;
// it must still be a point of the cone.
TEST(WrenchSpace, AlongTheNormalThePointIsInTheExactCone) {
  Random random(57);
  for (int i = 0; i < 1000; ++i) {
    const Contact contact = {{0.3, -0.2, 0.5}, random.direction(), 0.6, ContactModel::point};
    const auto set =
        wrench_space({&contact, 1}, {}, {.cone = FrictionCone::exact, .force = UnitForce::exactly});
    Wrench direction = Wrench::Zero();
    direction.head<3>() = contact.normal;
    const Eigen::Vector3d force = set->support(direction).head<3>();
    const double along = force.dot(contact.normal);
    EXPECT_NEAR(along, 1.0, 1e-14);
    EXPECT_LE((force - along * contact.normal).norm(), contact.friction * (1.0 + 1e-14));
  }
}

TEST(WrenchSpace, SetsContainEachOther) {
  for (const NamedGrasp& grasp : grasp_families(54, 1)) {
    const auto ask = [&](WrenchNorm norm, FrictionCone cone, UnitForce force) {
      return grasp_epsilon(grasp.contacts, {}, {norm, cone, 8, force},
                           {.relative_tolerance = 1e-2, .max_facets = 3000});
    };
    using enum WrenchNorm;
    using enum FrictionCone;
    const EpsilonBracket l1_pyramid = ask(l1, pyramid, UnitForce::at_most);
    const EpsilonBracket l1_exact = ask(l1, exact, UnitForce::at_most);
    const EpsilonBracket sum_pyramid = ask(linf, pyramid, UnitForce::at_most);
    const EpsilonBracket sum_exact = ask(linf, exact, UnitForce::at_most);
    EXPECT_LE(l1_pyramid.lower, sum_pyramid.upper + kRounding) << grasp.name;
    EXPECT_LE(l1_exact.lower, sum_exact.upper + kRounding) << grasp.name;
    EXPECT_LE(l1_pyramid.lower, l1_exact.upper + kRounding) << grasp.name;
    EXPECT_LE(sum_pyramid.lower, sum_exact.upper + kRounding) << grasp.name;
    for (const FrictionCone cone : {pyramid, exact}) {
      EXPECT_LE(ask(linf, cone, UnitForce::exactly).lower,
                ask(linf, cone, UnitForce::at_most).upper + kRounding)
          << grasp.name;
    }
    // The sum of n sets reaches at most n times as far as their hull.
    const auto count = static_cast<double>(grasp.contacts.size());
    EXPECT_LE(sum_exact.lower, count * l1_exact.upper + kRounding) << grasp.name;
    EXPECT_EQ(l1_pyramid.force_closure(), sum_pyramid.force_closure()) << grasp.name;
    EXPECT_EQ(l1_exact.force_closure(), sum_exact.force_closure()) << grasp.name;
  }
}

TEST(WrenchSpace, OriginDoesNotMatterToTheHull) {
  for (const NamedGrasp& grasp : grasp_families(55, 1)) {
    const WrenchSpaceOptions exactly = {.force = UnitForce::exactly};
    const EpsilonBracket with = epsilon(*wrench_space(grasp.contacts, {}, {}));
    const EpsilonBracket without = epsilon(*wrench_space(grasp.contacts, {}, exactly));
    EXPECT_EQ(with.force_closure(), without.force_closure()) << grasp.name;
    EXPECT_NEAR(with.lower, without.lower, 2e-9) << grasp.name;
  }
}

// The cone lies between a pyramid inside of it and one around it, whose friction is larger by
// 1 / cos(pi / edges).
TEST(WrenchSpace, ExactConeLiesBetweenPyramids) {
  Random random(56);
  for (int i = 0; i < 8; ++i) {
    const Contacts contacts = random_grasp(random, 4 + i % 3, random.uniform(0.3, 1.0));
    for (const WrenchSpaceOptions& space : {kExact, kExactSum}) {
      const EpsilonBracket exact = grasp_epsilon(contacts, {}, space);
      for (const int edges : {4, 8, 64}) {
        const WrenchSpaceOptions pyramid = {.norm = space.norm, .edges = edges};
        const EpsilonOptions loose = {.relative_tolerance = 1e-3, .max_facets = 30000};
        Contacts around = contacts;
        for (Contact& contact : around) contact.friction /= std::cos(std::numbers::pi / edges);
        const EpsilonBracket inner = grasp_epsilon(contacts, {}, pyramid, loose);
        const EpsilonBracket outer = grasp_epsilon(around, {}, pyramid, loose);
        EXPECT_LE(inner.lower, exact.upper + kRounding) << edges << " edges";
        EXPECT_GE(outer.upper, exact.lower - kRounding) << edges << " edges";
        if (edges < 64 || !exact.force_closure()) continue;
        // 64 edges are 0.12 % of the friction short of the cone; 1 % is the bracket's.
        EXPECT_NEAR(inner.lower, exact.upper, 0.03 * exact.upper);
      }
    }
  }
}

TEST(WrenchSpace, SoftFingerWithoutTorsionIsAPoint) {
  Random random(57);
  for (int i = 0; i < 5; ++i) {
    const Contacts points = random_grasp(random, 4, 0.8);
    const Contacts fingers = soft(points, 0.0);
    for (const WrenchSpaceOptions& space : {kExact, kExactSum}) {
      const auto of_points = wrench_space(points, {}, space);
      const auto of_fingers = wrench_space(fingers, {}, space);
      for (int j = 0; j < 50; ++j) {
        const Wrench direction = random_direction(random);
        EXPECT_EQ(of_points->support(direction), of_fingers->support(direction));
      }
    }
    for (const WrenchSpaceOptions& space : {WrenchSpaceOptions{}, kSum}) {
      const EpsilonBracket of_points = grasp_epsilon(points, {}, space);
      const EpsilonBracket of_fingers = grasp_epsilon(fingers, {}, space);
      EXPECT_NEAR(of_points.upper, of_fingers.upper, 1e-9);
    }
  }
}

TEST(WrenchSpace, AntipodalPairHoldsWithSoftFingersOnly) {
  Random random(58);
  for (int i = 0; i < 5; ++i) {
    const Contacts pair = rotated(ring_grasp(2, 0.5), random.rotation());
    for (const WrenchSpaceOptions& space : {WrenchSpaceOptions{}, kSum, kExact, kExactSum}) {
      EXPECT_EQ(grasp_epsilon(pair, {}, space).status, EpsilonStatus::no_force_closure);
      EXPECT_TRUE(grasp_epsilon(soft(pair, 0.1), {}, space).force_closure());
    }
  }
}

TEST(WrenchSpace, TurningAndMovingAGraspChangesNothing) {
  Random random(59);
  for (int i = 0; i < 5; ++i) {
    const Contacts contacts = soft(random_grasp(random, 4, 0.7), 0.1 * i);
    const WrenchFrame frame = {.torque_origin = {0.1, 0.2, -0.1}, .torque_scale = 0.8};
    const Eigen::Matrix3d rotation = random.rotation();
    const Eigen::Vector3d shift(3.0, -2.0, 1.0);
    Contacts carried = rotated(contacts, rotation);
    for (Contact& contact : carried) contact.position += shift;
    const WrenchFrame carried_frame = {rotation * frame.torque_origin + shift, frame.torque_scale};
    for (const WrenchSpaceOptions& space : {kExact, kExactSum}) {
      const auto set = wrench_space(contacts, frame, space);
      const auto carried_set = wrench_space(carried, carried_frame, space);
      for (int j = 0; j < 50; ++j) {
        const Wrench direction = random_direction(random);
        Wrench turned;
        turned << rotation * direction.head<3>(), rotation * direction.tail<3>();
        EXPECT_NEAR(value(*set, direction), value(*carried_set, turned), 1e-13);
      }
      const EpsilonBracket here = grasp_epsilon(contacts, frame, space);
      const EpsilonBracket there = grasp_epsilon(carried, carried_frame, space);
      EXPECT_EQ(here.force_closure(), there.force_closure());
      EXPECT_LE(here.lower, there.upper + kRounding);
      EXPECT_LE(there.lower, here.upper + kRounding);
    }
  }
}

// A set added to itself is twice the set.
TEST(WrenchSpace, EveryContactTwiceDoublesTheSum) {
  Random random(60);
  for (int i = 0; i < 5; ++i) {
    const Contacts contacts = random_grasp(random, 4, 0.8);
    for (const UnitForce force : {UnitForce::at_most, UnitForce::exactly}) {
      const WrenchSpaceOptions space = {.norm = WrenchNorm::linf, .force = force};
      const EpsilonBracket once = grasp_epsilon(contacts, {}, space);
      const EpsilonBracket twice = grasp_epsilon(doubled(random, contacts, 0.0), {}, space);
      EXPECT_NEAR(twice.lower, 2.0 * once.lower, 4e-9);
      EXPECT_NEAR(twice.upper, 2.0 * once.upper, 4e-9);
    }
  }
}

// Symmetric sums start with the origin on an edge of the first simplex: growth once took that for
// a surface dented by rounding and gave up.
TEST(WrenchSpace, SymmetricSumsDoNotStall) {
  Random random(61);
  for (int i = 0; i < 60; ++i) {
    const double friction = random.uniform(0.1, 1.0);
    const Eigen::Matrix3d rotation = random.rotation();
    for (const Contacts& contacts :
         {octahedron_grasp(friction), ring_grasp(3 + i % 6, friction), cube_grasp(friction),
          jaw_grasp(0.1, friction), rotated(octahedron_grasp(friction), rotation),
          rotated(cube_grasp(friction), rotation)}) {
      for (const WrenchSpaceOptions& space : {kSum, kExactSum}) {
        const EpsilonBracket bracket = grasp_epsilon(contacts, {}, space, {.max_facets = 1000});
        EXPECT_NE(bracket.status, EpsilonStatus::stalled) << friction;
        EXPECT_TRUE(bracket.force_closure()) << friction;
      }
    }
  }
}

TEST(GraspEpsilon, OfPyramidsIsThatOfTheirWrenches) {
  for (const NamedGrasp& grasp : grasp_families(62, 1)) {
    const EpsilonBracket bracket = grasp_epsilon(grasp.contacts, {}, {.edges = grasp.edges});
    const EpsilonBracket expected = epsilon_l1(contact_wrenches(grasp.contacts, {}, grasp.edges));
    EXPECT_EQ(bracket.lower, expected.lower) << grasp.name;
    EXPECT_EQ(bracket.upper, expected.upper) << grasp.name;
    EXPECT_EQ(bracket.weakest, expected.weakest) << grasp.name;
  }
}

TEST(GraspEpsilon, ExactConesEndWithinTheirOptions) {
  Random random(63);
  for (int i = 0; i < 20; ++i) {
    const Contacts contacts = random_grasp(random, 4, random.uniform(0.3, 1.0));
    const EpsilonBracket bracket = grasp_epsilon(contacts, {}, kExact);
    if (!bracket.force_closure()) continue;
    EXPECT_EQ(bracket.status, EpsilonStatus::converged);
    EXPECT_GE(bracket.lower, 0.99 * bracket.upper);
  }
  const EpsilonBracket ring = grasp_epsilon(ring_grasp(8, 0.5), {}, kExact);
  EXPECT_TRUE(ring.force_closure());
  EXPECT_GE(ring.lower, 0.96 * ring.upper);
}

// Any torque about an axis of the octahedron is up to the friction of four contacts, and a soft
// finger's own torsion is up to two more.
TEST(GraspEpsilon, UpperBoundIsAtMostTheSupportAlongTheAxes) {
  for (const double friction : {0.1, 0.3, 0.5}) {
    const Contacts contacts = octahedron_grasp(friction);
    EXPECT_LE(grasp_epsilon(contacts, {}, kExactSum).upper, 4.0 * friction + 1e-14);
    EXPECT_LE(grasp_epsilon(contacts, {}, kExact).upper, friction + 1e-14);
    EXPECT_LE(grasp_epsilon(soft(contacts, 0.5), {}, kExactSum).upper, 5.0 * friction + 1e-14);
  }
}

TEST(GraspEpsilon, NoContactsHoldNothing) {
  for (const WrenchSpaceOptions& space : {WrenchSpaceOptions{}, kSum, kExact, kExactSum}) {
    const EpsilonBracket bracket = grasp_epsilon({}, {}, space);
    EXPECT_EQ(bracket.status, EpsilonStatus::no_force_closure);
    EXPECT_EQ(bracket.upper, 0.0);
  }
}

TEST(GraspEpsilon, RejectsNonsense) {
  Contacts contacts = cube_grasp(0.5);
  const WrenchSpaceOptions two_edges = {.norm = WrenchNorm::linf, .edges = 2};
  EXPECT_THROW(grasp_epsilon(contacts, {}, two_edges), InputError);
  EXPECT_THROW(grasp_epsilon(contacts, {}, {.edges = 2}), InputError);
  // An exact cone has no edges to count.
  EXPECT_NO_THROW(grasp_epsilon(contacts, {}, {.cone = FrictionCone::exact, .edges = 2}));
  contacts[3].friction = -0.1;
  for (const WrenchSpaceOptions& space : {WrenchSpaceOptions{}, kSum, kExact, kExactSum}) {
    try {
      wrench_space(contacts, {}, space);
      FAIL();
    } catch (const InputError& error) {
      EXPECT_STREQ(error.what(), "contacts[3].friction: must be from 0 to 1e+06 (-0.1)");
    }
  }
}

}  // namespace
}  // namespace prehend::test
