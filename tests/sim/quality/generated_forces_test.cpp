// Forces of many contacts by column generation, beside the one program of all contacts.
#include "sim/quality/generated_forces.h"

#include <gtest/gtest.h>

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

// Both ways to the same smallest measure, and to the same verdict where there is none.
TEST(GeneratedForces, AreThoseOfOneProgram) {
  Random random(3);
  int impossible = 0;
  int balanced = 0;
  constexpr int kRounds = repeats(2);
  for (const NamedGrasp& grasp : grasp_families(5, kRounds)) {
    for (const ForceMeasure measure : kForceMeasures) {
      for (const FrictionCone cone : kFrictionCones) {
        SCOPED_TRACE(grasp.name + " " + std::to_string(static_cast<int>(measure)) + " " +
                     std::to_string(static_cast<int>(cone)));
        const ForceOptions options{.measure = measure, .cone = cone};
        const Wrench wrench = random_wrench(random).normalized();
        const ContactForces expected = balancing_forces(grasp.contacts, {}, wrench, options);
        const ForceBalance balance(grasp.contacts, {}, wrench, 1.0, nullptr, options);
        const GeneratedForces found = generate_forces(balance, measure, options.gap_tolerance);
        const double sum = balance.lower_bound(found.separation, ForceMeasure::sum_of_normals,
                                               options.residual_tolerance);
        if (expected.outcome == ForceOutcome::impossible) {
          EXPECT_GT(sum, kLargestForce);
          ++impossible;
          continue;
        }
        ASSERT_EQ(expected.outcome, ForceOutcome::balanced);
        const double lowest = balance.lower_bound(found.separation, measure);
        const double reached = balance.measure(found.components);
        EXPECT_LE(balance.residual(found.components), options.residual_tolerance);
        EXPECT_LE(reached - lowest, options.gap_tolerance * reached);
        EXPECT_LE(lowest, balance.measure(expected.components) * (1.0 + 1e-9));
        EXPECT_GE(reached, expected.lowest * (1.0 - 1e-9));
        ++balanced;
      }
    }
  }
  EXPECT_GT(impossible, 10 * kRounds);
  EXPECT_GT(balanced, 30 * kRounds);
}

TEST(GeneratedForces, BalanceTwoThousandContacts) {
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

// Contacts that all push upwards cannot hold a load that lifts.
TEST(GeneratedForces, ProveTheImpossible) {
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
