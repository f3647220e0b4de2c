#include "sim/quality/forces.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/quality/epsilon.h"
#include "tests/sim/quality/force_checks.h"
#include "tests/support/grasp_families.h"
#include "tests/support/repeats.h"

namespace prehend::test {
namespace {

constexpr double kClose = 1e-8;  // relative: the gap asked of the solver is 1e-11
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const Wrench kWeight = wrench_of(0, 0, -7.0);

Contacts with_model(Contacts contacts, ContactModel model, double torsion = 0.0) {
  for (Contact& contact : contacts) {
    contact.model = model;
    contact.torsion = torsion;
  }
  return contacts;
}

// Two fingers on the x axis, squeezing.
Contacts two_fingers(double friction) { return ring_grasp(2, friction); }

double largest_normal(const Contacts& contacts, const Wrench& external,
                      const ForceOptions& options = {}) {
  const ContactForces forces = balancing_forces(contacts, {}, external, options);
  expect_balanced(contacts, {}, external, forces);
  EXPECT_LE(forces.lowest, forces.largest_normal * (1.0 + 1e-12));
  return forces.largest_normal;
}

TEST(Forces, TwoFingersHoldAWeight) {
  for (const double friction : {0.01, 0.3, 1.0, 3.0}) {
    const double normal = 7.0 / (2.0 * friction);
    EXPECT_NEAR(largest_normal(two_fingers(friction), kWeight) / normal, 1.0, kClose);
    const ContactForces shared = balancing_forces(two_fingers(friction), {}, kWeight,
                                                  {.measure = ForceMeasure::sum_of_normals});
    expect_balanced(two_fingers(friction), {}, kWeight, shared);
    EXPECT_NEAR(shared.sum_of_normals / (2.0 * normal), 1.0, kClose);
  }
}

TEST(Forces, RingHoldsAWeight) {
  for (int n = 2; n <= 16; ++n) {
    EXPECT_NEAR(largest_normal(ring_grasp(n, 0.4), kWeight), 7.0 / (0.4 * n), 1e-6);
  }
}

TEST(Forces, TripodCarriesBarycentrically) {
  // A plate on three frictionless supports: each carries the barycentric coordinate of the load.
  const Contacts feet = with_model(
      {{{1, 0, 0}, {0, 0, 1}, 0.5}, {{0, 1, 0}, {0, 0, 1}, 0.5}, {{0, 0, 0}, {0, 0, 1}, 0}},
      ContactModel::frictionless);
  const Eigen::Vector3d shares(0.5, 0.2, 0.3);
  const Eigen::Vector3d load(0.5, 0.2, 0.0);
  Wrench external = kWeight;
  external.tail<3>() = load.cross(kWeight.head<3>().eval());
  const ContactForces forces = balancing_forces(feet, {}, external);
  expect_balanced(feet, {}, external, forces, 1e-12);
  EXPECT_LE((forces.components.row(0).transpose() - 7.0 * shares).norm(), 1e-10);
  EXPECT_NEAR(forces.forces(2, 0), 3.5, 1e-10);
  // Outside of the triangle it tips.
  external.tail<3>() = Eigen::Vector3d(0.6, 0.6, 0.0).cross(kWeight.head<3>().eval());
  expect_separated(feet, {}, external, balancing_forces(feet, {}, external));
}

TEST(Forces, SoftFingersHoldATorque) {
  const WrenchFrame frame{Eigen::Vector3d(0.1, 0.2, 0.3), 4.0};
  const Contacts points = two_fingers(0.5);
  const Contacts soft = with_model(points, ContactModel::soft_finger, 0.02);
  Wrench external = wrench_of(0, 0, 0, 0.3 * frame.torque_scale);  // 0.3 Nm about the normals
  const ContactForces turned = balancing_forces(soft, frame, external);
  expect_balanced(soft, frame, external, turned);
  EXPECT_NEAR(turned.largest_normal, 0.3 / (2 * 0.5 * 0.02), 1e-6);
  EXPECT_NEAR(turned.components(3, 0), 0.15, 1e-8);  // normals are -x and x: opposite signs
  EXPECT_NEAR(turned.components(3, 1), -0.15, 1e-8);
  expect_separated(points, frame, external, balancing_forces(points, frame, external));
  // With a weight through the origin of the fingers on top: the ellipsoid.
  external.head<3>() = kWeight.head<3>();
  external.tail<3>() += frame.torque_scale * (-frame.torque_origin).cross(kWeight.head<3>().eval());
  const ContactForces both = balancing_forces(soft, frame, external);
  expect_balanced(soft, frame, external, both);
  EXPECT_NEAR(both.largest_normal, std::hypot(3.5, 0.15 / 0.02) / 0.5, 1e-6);
}

TEST(Forces, PyramidIsInsideTheCone) {
  // The first tangents of these fingers are along y: a corner points there. Turned by half a side's
  // angle the weight meets the middle of a side.
  for (const int edges : {4, 6, 12}) {
    const ForceOptions pyramid{.cone = FrictionCone::pyramid, .edges = edges};
    EXPECT_NEAR(largest_normal(two_fingers(0.5), wrench_of(0, -7.0, 0), pyramid), 7.0, 1e-7);
    const double angle = std::numbers::pi / edges;
    const Wrench turned = wrench_of(0, -7.0 * std::cos(angle), 7.0 * std::sin(angle));
    EXPECT_NEAR(largest_normal(two_fingers(0.5), turned, pyramid), 7.0 / std::cos(angle), 1e-7);
  }
  Random random(1);
  for (int i = 0; i < 30; ++i) {
    Contacts contacts = cube_grasp(random.uniform(0.2, 1.0));
    for (std::size_t k = 0; k < 4; ++k) {
      contacts[k].model = ContactModel::soft_finger;
      contacts[k].torsion = 0.2;
    }
    const Wrench external = (Wrench() << random.direction(), random.direction()).finished();
    const double exact = largest_normal(contacts, external);
    const double coarse =
        largest_normal(contacts, external, {.cone = FrictionCone::pyramid, .edges = 4});
    const double fine =
        largest_normal(contacts, external, {.cone = FrictionCone::pyramid, .edges = 8});
    EXPECT_LE(exact, fine + kClose);
    EXPECT_LE(fine, coarse + kClose);
  }
}

TEST(Forces, ZeroWrenchAndNoContacts) {
  const ContactForces rest = balancing_forces(two_fingers(0.5), {}, Wrench::Zero());
  EXPECT_EQ(rest.outcome, ForceOutcome::balanced);
  EXPECT_EQ(rest.forces, (Eigen::Matrix3Xd::Zero(3, 2)));
  EXPECT_EQ(balancing_forces({}, {}, Wrench::Zero()).outcome, ForceOutcome::balanced);
  expect_separated({}, {}, kWeight, balancing_forces({}, {}, kWeight));
}

TEST(Forces, TurnsAndScalesWithTheProblem) {
  Random random(2);
  for (const NamedGrasp& grasp : grasp_families(3, 2)) {
    const Wrench external = (Wrench() << random.direction(), random.direction()).finished();
    const ContactForces forces = balancing_forces(grasp.contacts, {}, external);
    const Eigen::Matrix3d R = random.rotation();
    Wrench turned = 1e5 * external;
    turned.head<3>() = R * turned.head<3>().eval();
    turned.tail<3>() = R * turned.tail<3>().eval();
    const ContactForces again = balancing_forces(rotated(grasp.contacts, R), {}, turned);
    ASSERT_EQ(forces.outcome, again.outcome) << grasp.name;
    EXPECT_NEAR(again.largest_normal, 1e5 * forces.largest_normal, 0.1 * forces.largest_normal)
        << grasp.name;
  }
}

// Four fingers, two on x and two on y; a joint each that bears its finger's normal force.
struct FourFingers {
  Contacts contacts = ring_grasp(4, 0.5);
  HandTorques hand{Eigen::MatrixXd::Zero(12, 4), Eigen::VectorXd::Constant(4, kInfinity), {}};

  FourFingers() {
    for (int i = 0; i < 4; ++i) {
      hand.jacobian.block<3, 1>(3 * i, i) = contacts[static_cast<std::size_t>(i)].normal;
    }
  }
  ContactForces forces() const { return balancing_forces(contacts, {}, kWeight, hand); }
};

TEST(Forces, JointLimitsBind) {
  FourFingers fingers;
  const double free = 7.0 / (4 * 0.5);
  EXPECT_NEAR(fingers.forces().largest_normal, free, 1e-7);
  for (const double limit : {0.0, 0.5, 3.0}) {  // of the fingers on x: the others take over
    fingers.hand.limits[0] = fingers.hand.limits[2] = limit;
    const ContactForces forces = fingers.forces();
    expect_balanced(fingers.contacts, {}, kWeight, forces);
    EXPECT_NEAR(forces.largest_normal, 2.0 * free - limit, 1e-7) << limit;
    EXPECT_LE(forces.components(0, 0), limit * (1.0 + 1e-8) + 1e-8);
  }
}

TEST(Forces, JointLimitsProveTheImpossible) {
  FourFingers fingers;
  for (const double limit : {0.0, 1.0, 3.49}) {
    fingers.hand.limits.setConstant(limit);
    const ContactForces forces = fingers.forces();
    ASSERT_EQ(forces.outcome, ForceOutcome::impossible) << limit;
    const double power = forces.separating.dot(kWeight);
    const Eigen::VectorXd& l = forces.torque_multipliers;
    EXPECT_GT(power, l.cwiseAbs().sum() * limit);
    // Each joint adds its multiplier to the power of its finger's normal force.
    for (int i = 0; i < 4; ++i) {
      const Contact& contact = fingers.contacts[static_cast<std::size_t>(i)];
      EXPECT_GE(lowest_power(contact, {}, forces.separating) + l[i], -1e-9 * power);
    }
  }
  fingers.hand.limits.setConstant(3.51);
  EXPECT_EQ(fingers.forces().outcome, ForceOutcome::balanced);
}

TEST(Forces, SpinLoadsJointsWithTorsion) {
  const Contacts soft = with_model(two_fingers(0.5), ContactModel::soft_finger, 0.1);
  const Wrench external = wrench_of(0, 0, 0, 1.0);
  HandTorques hand{Eigen::MatrixXd::Zero(6, 1), Eigen::VectorXd::Constant(1, 0.2),
                   Eigen::MatrixXd::Zero(2, 1)};
  hand.spin(0, 0) = 1.0;  // the first finger cannot hold more than 0.2 Nm
  const ContactForces forces = balancing_forces(soft, {}, external, hand);
  expect_balanced(soft, {}, external, forces);
  EXPECT_NEAR(std::abs(forces.components(3, 0)), 0.2, 1e-7);
  EXPECT_NEAR(forces.largest_normal, 0.8 / (0.5 * 0.1), 1e-6);
}

TEST(Forces, ResistanceIsOneOverTheSmallestForces) {
  const Resistance weight = wrench_resistance(two_fingers(0.5), {}, wrench_of(0, 0, -1));
  EXPECT_NEAR(weight.lower, 1.0, kClose);
  EXPECT_NEAR(weight.upper, 1.0, kClose);
  EXPECT_LE(weight.lower, weight.upper * (1.0 + 1e-12));
  const Resistance none = wrench_resistance(two_fingers(0.5), {}, wrench_of(0, 0, 0, 1));
  EXPECT_EQ(none.outcome, ForceOutcome::impossible);
  EXPECT_EQ(none.upper, 0.0);
  EXPECT_EQ(wrench_resistance(two_fingers(0.5), {}, Wrench::Zero()).lower, kInfinity);
}

TEST(Forces, ResistanceToTheWeakestDisturbanceIsEpsilon) {
  const ForceOptions l1{.measure = ForceMeasure::sum_of_normals, .cone = FrictionCone::pyramid};
  int held = 0;
  for (const NamedGrasp& grasp : grasp_families(5, 3)) {
    const EpsilonBracket epsilon = epsilon_l1(contact_wrenches(grasp.contacts, {}));
    if (!epsilon.force_closure()) continue;
    ++held;
    const Resistance k = wrench_resistance(grasp.contacts, {}, epsilon.weakest.normalized(), l1);
    EXPECT_LE(k.lower, epsilon.upper * (1.0 + 1e-6)) << grasp.name;
    EXPECT_GE(k.upper, epsilon.lower * (1.0 - 1e-6)) << grasp.name;
    EXPECT_LE(k.upper - k.lower, 1e-6 * k.upper) << grasp.name;
  }
  EXPECT_GT(held, 20);
}

// Any wrench, for grasps of all kinds, a third of them with soft fingers.
TEST(Forces, ThousandRandomProblems) {
  Random random(6);
  int problems = 0;
  int impossible = 0;
  for (NamedGrasp& grasp : grasp_families(7, 44)) {
    if (++problems > 1000) break;
    SCOPED_TRACE(grasp.name);
    if (problems % 3 == 0) {
      grasp.contacts =
          with_model(grasp.contacts, ContactModel::soft_finger, random.uniform(0.0, 0.3));
    }
    const double load = std::pow(10.0, random.uniform(-3.0, 3.0));
    const Wrench external =
        load * (Wrench() << random.direction(), random.vector(0.0, 1.0)).finished();
    const ContactForces forces = balancing_forces(grasp.contacts, {}, external);
    if (forces.outcome == ForceOutcome::impossible) {
      ++impossible;
      expect_separated(grasp.contacts, {}, external, forces);
      EXPECT_FALSE(epsilon_l1(contact_wrenches(grasp.contacts, {})).force_closure());
    } else {
      expect_balanced(grasp.contacts, {}, external, forces);
    }
  }
  EXPECT_GT(impossible, 100);
  EXPECT_LT(impossible, 500);
}

TEST(Forces, RejectsWhatMakesNoSense) {
  const Contacts contacts = two_fingers(0.5);
  const auto rejects = [&](const Wrench& external, const ForceOptions& options) {
    EXPECT_THROW(balancing_forces(contacts, {}, external, options), InputError);
  };
  rejects(wrench_of(std::nan(""), 0, 0), {});
  rejects(kWeight, {.edges = 2});
  rejects(kWeight, {.residual_tolerance = 0.0});
  rejects(kWeight, {.gap_tolerance = -1.0});
  Contacts bad = contacts;
  bad[0].friction = -1.0;
  EXPECT_THROW(balancing_forces(bad, {}, kWeight), InputError);
  const auto rejects_hand = [&](const HandTorques& hand) {
    EXPECT_THROW(balancing_forces(contacts, {}, kWeight, hand), InputError);
  };
  const HandTorques good{Eigen::MatrixXd::Zero(6, 2), Eigen::Vector2d(1, 1), {}};
  EXPECT_NO_THROW(balancing_forces(contacts, {}, kWeight, good));
  rejects_hand({Eigen::MatrixXd::Zero(5, 2), good.limits, {}});
  rejects_hand({good.jacobian, Eigen::VectorXd::Ones(3), {}});
  rejects_hand({good.jacobian, Eigen::Vector2d(1, -1), {}});
  rejects_hand({good.jacobian, Eigen::Vector2d(1, std::nan("")), {}});
  rejects_hand({good.jacobian, good.limits, Eigen::MatrixXd::Zero(3, 2)});
  rejects_hand({Eigen::MatrixXd::Constant(6, 2, kInfinity), good.limits, {}});
}

// Each finger pushes with a joint at an arm of 0.1 m.
TEST(Forces, TimesBorneByTwoFingers) {
  const double friction = 0.5;
  const Contacts fingers = two_fingers(friction);
  HandTorques hand{Eigen::MatrixXd::Zero(6, 2), Eigen::Vector2d(0.3, 0.2), {}};
  for (int i = 0; i < 2; ++i) {
    hand.jacobian.block<3, 1>(3 * i, i) = 0.1 * fingers[static_cast<std::size_t>(i)].normal;
  }
  // The weaker finger pushes with 2 N, and so does the other against it.
  const double times = 2.0 * friction * 2.0 / 7.0;
  EXPECT_NEAR(times_borne(fingers, {}, kWeight, hand, 1e6), times, 1e-5 * times);
  EXPECT_EQ(times_borne(fingers, {}, kWeight, hand, 0.25), 0.25);
  hand.limits.setConstant(kInfinity);
  EXPECT_EQ(times_borne(fingers, {}, kWeight, hand, 1e6), 1e6);
  EXPECT_EQ(times_borne(fingers, {}, wrench_of(0, 0, 0, 1, 0, 0), hand, 1e6), 0.0);
  EXPECT_EQ(times_borne(fingers, {}, Wrench::Zero(), hand, 3.0), 3.0);
}

// So many times the wrench are balanced, a little more are not. The limits bind: each contact force
// loads joints, as those of a hand do.
TEST(Forces, TimesBorneAreTheMost) {
  Random random(12);
  int limited = 0;
  for (int round = 0; round < repeats(40); ++round) {
    const Contacts grasp = random_grasp(random, 4, 0.6);
    HandTorques hand{Eigen::MatrixXd::Zero(12, 10), Eigen::VectorXd::Constant(10, 0.5), {}};
    for (double& entry : hand.jacobian.reshaped()) entry = random.uniform(-0.1, 0.1);
    const Wrench wrench = (Wrench() << random.direction(), random.vector(0.0, 0.1)).finished();
    const double times = times_borne(grasp, {}, wrench, hand, 1e6);
    if (times == 0.0 || times == 1e6) continue;
    ++limited;
    const ForceOptions sum{.measure = ForceMeasure::sum_of_normals};
    EXPECT_EQ(balancing_forces(grasp, {}, 0.999 * times * wrench, hand, sum).outcome,
              ForceOutcome::balanced);
    EXPECT_NE(balancing_forces(grasp, {}, 1.001 * times * wrench, hand, sum).outcome,
              ForceOutcome::balanced);
  }
  EXPECT_GT(limited, repeats(8));
}

// Thousands of corners, with joint limits and without.
TEST(Forces, OfPyramidsWithManyEdges) {
  const std::vector<Contact> contacts = ring_grasp(4, 0.5);
  Wrench weight = Wrench::Zero();
  weight[2] = -3.0;
  const ForceOptions many{.cone = FrictionCone::pyramid, .edges = 1024};
  const ContactForces pyramids = balancing_forces(contacts, {}, weight, many);
  const ContactForces cones = balancing_forces(contacts, {}, weight);
  EXPECT_EQ(pyramids.outcome, ForceOutcome::balanced);
  EXPECT_GE(pyramids.largest_normal, cones.lowest);
  // The pyramids are narrower by 1 - cos(pi / 1024) = 5e-6.
  EXPECT_LE(pyramids.largest_normal, (1.0 + 1e-5) * cones.largest_normal);
  const HandTorques hand{Eigen::MatrixXd::Ones(12, 1), Eigen::VectorXd::Constant(1, 100.0), {}};
  const ContactForces held = balancing_forces(contacts, {}, weight, hand, many);
  EXPECT_EQ(held.outcome, ForceOutcome::balanced);
  EXPECT_NEAR(held.largest_normal, pyramids.largest_normal, 1e-6);
}

}  // namespace
}  // namespace prehend::test
