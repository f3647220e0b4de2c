// Forces by the barrier in the multipliers, beside the general program for the same problem.
#include "sim/quality/barrier_forces.h"

#include <gtest/gtest.h>

#include "sim/quality/force_program.h"
#include "tests/sim/quality/force_checks.h"
#include "tests/support/grasp_families.h"
#include "tests/support/repeats.h"

namespace prehend::test {
namespace {

constexpr ForceMeasure kForceMeasures[] = {ForceMeasure::sum_of_normals,
                                           ForceMeasure::largest_normal};
constexpr FrictionCone kFrictionCones[] = {FrictionCone::pyramid, FrictionCone::exact};

Wrench random_wrench(Random& random) {
  return (Wrench() << random.direction(), random.vector(0.0, 1.0)).finished();
}

ProposedForces program_forces(const ForceBalance& balance, const ForceOptions& options) {
  const ForceProgram program(balance, options);
  const ConicSolution solution =
      solve(program.program(), {.tolerance = 1e-11, .infeasible_tolerance = 1e-12});
  return {program.components(solution), program.separation(solution)};
}

bool proves_impossible(const ForceBalance& balance, const ForceOptions& options,
                       const ProposedForces& forces) {
  return balance.lower_bound(forces.separation, ForceMeasure::sum_of_normals,
                             options.residual_tolerance) > kLargestForce;
}

// Good forces with a good proof; between the bounds of others.
void expect_least(const ForceBalance& balance, const ForceOptions& options,
                  const ProposedForces& found, const ProposedForces& others) {
  const double lowest = balance.lower_bound(found.separation, options.measure);
  const double reached = balance.measure(found.components);
  EXPECT_LE(balance.residual(found.components), options.residual_tolerance);
  EXPECT_LE(balance.torque_excess(found.components), options.residual_tolerance);
  EXPECT_LE(reached - lowest, options.gap_tolerance * reached);
  EXPECT_LE(lowest, balance.measure(others.components) * (1.0 + 1e-9));
  EXPECT_GE(reached, balance.lower_bound(others.separation, options.measure) * (1.0 - 1e-9));
}

// Both ways to the same smallest measure. Few of the impossible are left to the program to prove.
TEST(BarrierForces, AreThoseOfTheProgram) {
  Random random(3);
  int impossible = 0;
  int proved = 0;
  int balanced = 0;
  constexpr int kRounds = repeats(2);
  for (const NamedGrasp& grasp : grasp_families(5, kRounds)) {
    for (const ForceMeasure measure : kForceMeasures) {
      for (const FrictionCone cone : kFrictionCones) {
        SCOPED_TRACE(grasp.name + " " + std::to_string(static_cast<int>(measure)) + " " +
                     std::to_string(static_cast<int>(cone)));
        const ForceOptions options{.measure = measure, .cone = cone};
        const Wrench wrench = random_wrench(random).normalized();
        const ForceBalance balance(grasp.contacts, {}, wrench, 1.0, nullptr, options);
        const ProposedForces expected = program_forces(balance, options);
        const ProposedForces found = barrier_forces(balance, options);
        if (proves_impossible(balance, options, expected)) {
          ++impossible;
          proved += proves_impossible(balance, options, found) ? 1 : 0;
          continue;
        }
        expect_least(balance, options, found, expected);
        ++balanced;
      }
    }
  }
  EXPECT_GT(impossible, 10 * kRounds);
  EXPECT_GE(proved, impossible * 3 / 4);
  EXPECT_GT(balanced, 30 * kRounds);
}

// Joints that bear little bind, those without an effort bear nothing.
TEST(BarrierForces, KeepJointLimits) {
  Random random(4);
  int bound = 0;
  for (int round = 0; round < repeats(60); ++round) {
    const int contacts = 6 + static_cast<int>(random.index(8));
    const Contacts grasp = random_grasp(random, contacts, 0.5);
    HandTorques hand{Eigen::MatrixXd::Zero(3 * contacts, 3), Eigen::Vector3d(0.0, 0.05, 0.2), {}};
    for (double& entry : hand.jacobian.reshaped()) entry = random.uniform(-0.1, 0.1);
    for (const ForceMeasure measure : kForceMeasures) {
      const ForceOptions options{.measure = measure};
      const Wrench wrench = random_wrench(random).normalized();
      const ForceBalance balance(grasp, {}, wrench, 1.0, &hand, options);
      const ForceBalance unlimited(grasp, {}, wrench, 1.0, nullptr, options);
      const ProposedForces expected = program_forces(balance, options);
      if (proves_impossible(balance, options, expected)) continue;
      const ProposedForces found = barrier_forces(balance, options);
      expect_least(balance, options, found, expected);
      const double free = unlimited.measure(barrier_forces(unlimited, options).components);
      bound += balance.measure(found.components) > free * (1.0 + 1e-4) ? 1 : 0;
    }
  }
  EXPECT_GT(bound, repeats(60));
}

// Two fingers cannot turn about the line between them: five equations remain. Nor does a joint
// without an effort that no contact loads have a multiplier.
TEST(BarrierForces, LeaveOutWhatContactsCannotDo) {
  const Contacts fingers = ring_grasp(2, 0.5);
  const HandTorques idle{Eigen::MatrixXd::Zero(6, 1), Eigen::VectorXd::Zero(1), {}};
  for (const ForceMeasure measure : kForceMeasures) {
    const ForceOptions options{.measure = measure};
    const Wrench weight = wrench_of(0, 0, -1);
    for (const HandTorques* hand : {static_cast<const HandTorques*>(nullptr), &idle}) {
      const ForceBalance balance(fingers, {}, weight, 1.0, hand, options);
      const ProposedForces found = barrier_forces(balance, options);
      EXPECT_LE(balance.residual(found.components), options.residual_tolerance);
      EXPECT_NEAR(balance.measure(found.components),
                  measure == ForceMeasure::sum_of_normals ? 2.0 : 1.0, 1e-6);
    }
  }
}

TEST(BarrierForces, BalanceTwoThousandContacts) {
  Random random(8);
  const Contacts contacts = random_grasp(random, 2000, 0.5);
  const Wrench external = 7.0 * random_wrench(random);
  for (const ForceMeasure measure : kForceMeasures) {
    for (const FrictionCone cone : kFrictionCones) {
      const ForceOptions options{.measure = measure, .cone = cone};
      const ContactForces forces = balancing_forces(contacts, {}, external, options);
      EXPECT_EQ(forces.outcome, ForceOutcome::balanced);
      EXPECT_LE(forces.gap, options.gap_tolerance);
      EXPECT_LE(forces.residual, options.residual_tolerance);
    }
  }
}

// Nothing turns a plate without friction about its normal, however many fingers push on it.
TEST(BarrierForces, ProveWhatContactsCannotDo) {
  Random random(10);
  Contacts contacts = random_grasp(random, 300, 0.0);
  for (Contact& contact : contacts) {
    contact.normal = Eigen::Vector3d(0.0, 0.0, contact.position.x() > 0.0 ? 1.0 : -1.0);
  }
  const Wrench external = wrench_of(0, 0, 1, 0, 0, 0.1);
  for (const ForceMeasure measure : kForceMeasures) {
    const ContactForces forces =
        balancing_forces(contacts, {}, external, ForceOptions{.measure = measure});
    expect_separated(contacts, {}, external, forces);
  }
}

// Contacts that all push upwards cannot hold a load that lifts.
TEST(BarrierForces, ProveTheImpossible) {
  Random random(9);
  Contacts contacts = random_grasp(random, 500, 0.2);
  for (Contact& contact : contacts) {
    contact.normal = Eigen::Vector3d::UnitZ();
  }
  const Wrench external = wrench_of(0, 0, 5.0);
  for (const ForceMeasure measure : kForceMeasures) {
    const ContactForces forces =
        balancing_forces(contacts, {}, external, ForceOptions{.measure = measure});
    ASSERT_EQ(forces.outcome, ForceOutcome::impossible);
    expect_separated(contacts, {}, external, forces);
  }
}

}  // namespace
}  // namespace prehend::test
