// Random contacts with numbers of all magnitudes, inside the accepted ranges and beyond them: each
// grasp is refused with an InputError, or every measure of it is finite, with ordered bounds.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/base/range.h"
#include "sim/quality/forces.h"
#include "sim/quality/measures.h"
#include "sim/quality/ranges.h"
#include "sim/quality/wrench_slice.h"
#include "tests/support/repeats.h"

namespace prehend::test {
namespace {

constexpr int kCases = repeats(1500);

struct RandomCase {
  std::vector<Contact> contacts;
  WrenchFrame frame;
  MeasureOptions options;
  Wrench external = Wrench::Zero();  // of forces
  bool inside = true;                // whether all numbers are in their ranges
};

// Numbers are uniform in their logarithm from 1e-12 of the largest accepted one to that one; in a
// case that is to be refused, one in ten is beyond, up to the largest doubles.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : random_(seed) {}

  double uniform(double lowest, double highest) { return random_.uniform(lowest, highest); }
  bool chance(double part) { return uniform(0.0, 1.0) < part; }
  Eigen::Vector3d direction() { return random_.direction(); }

  double between(double lowest, double highest) {
    const double value = std::pow(10.0, uniform(std::log10(lowest), std::log10(highest)));
    return std::clamp(value, lowest, highest);
  }

  double size(double largest, RandomCase& made) {
    if (!made.inside && chance(0.1)) return largest * between(1.001, 1e290);
    return chance(0.1) ? 0.0 : between(1e-12 * largest, largest);
  }

  Eigen::Vector3d vector(double largest, RandomCase& made) {
    Eigen::Vector3d v;
    for (double& x : v) {
      const double sign = chance(0.5) ? 1.0 : -1.0;
      x = sign * size(largest, made);
    }
    return v;
  }

 private:
  Random random_;
};

void add_contact(RandomNumbers& numbers, const Contact& like, bool together, RandomCase& made) {
  Contact contact = like;
  contact.normal = numbers.direction();
  if (together) {
    // Around a ball of the first contact's distance, which most often is force closure.
    contact.position = -like.position.norm() * contact.normal;
  } else {
    contact.position = numbers.vector(kFarthest, made);
    contact.friction = numbers.size(kLargestFriction, made);
    contact.torsion = numbers.size(kFarthest, made);
  }
  if (contact.position.cwiseAbs().maxCoeff() > kFarthest) made.inside = false;
  made.contacts.push_back(contact);
}

RandomCase random_case(std::uint64_t seed) {
  RandomNumbers numbers(seed);
  RandomCase made;
  made.inside = !numbers.chance(0.2);
  Contact like;
  like.position = numbers.vector(0.5 * kFarthest, made);
  like.friction = numbers.size(kLargestFriction, made);
  like.torsion = numbers.size(kFarthest, made);
  const bool together = numbers.chance(0.6);
  const int count = static_cast<int>(numbers.uniform(2.0, 7.0));
  for (int i = 0; i < count; ++i) {
    like.model = kAll<ContactModel>[static_cast<std::size_t>(numbers.uniform(0.0, 3.0))];
    add_contact(numbers, like, together, made);
  }
  made.frame.torque_origin = together ? Eigen::Vector3d::Zero() : numbers.vector(kFarthest, made);
  made.frame.torque_scale = numbers.between(kSmallestTorqueScale, kLargestTorqueScale);
  const double radius = like.position.norm();
  if (together && radius > 1e-9) made.frame.torque_scale = std::min(1.0 / radius, 1e9);
  made.external.head<3>() = numbers.vector(kLargestLoad, made);
  made.external.tail<3>() = made.frame.torque_scale * numbers.vector(kLargestLoad, made);
  WrenchSpaceOptions& space = made.options.space;
  space.norm = numbers.chance(0.5) ? WrenchNorm::l1 : WrenchNorm::linf;
  space.cone = numbers.chance(0.5) ? FrictionCone::pyramid : FrictionCone::exact;
  space.force = numbers.chance(0.5) ? UnitForce::at_most : UnitForce::exactly;
  space.edges = static_cast<int>(numbers.between(3.0, 12.0));
  made.options.task = TaskWrenches{{made.external}};
  made.options.noise.samples = 3;
  made.options.hull.max_points = 40;
  return made;
}

// Whether the case is in its ranges after all: `inside` says only that no number was made beyond.
bool accepted(const RandomCase& made) {
  try {
    check_contacts(made.contacts, made.frame);
  } catch (const InputError&) {
    return false;
  }
  return true;
}

void expect_ordered(const Interval& interval, const std::string& what) {
  EXPECT_TRUE(std::isfinite(interval.lower)) << what << interval.lower;
  EXPECT_TRUE(std::isfinite(interval.upper)) << what << interval.upper;
  EXPECT_LE(interval.lower, interval.upper) << what;
}

// Measures that take many times as long as the others are `slow`.
void expect_sound_measures(const RandomCase& made, bool slow, const std::string& what) {
  std::vector<std::string> names = {"volume", "smallest_singular_value", "isotropy"};
  if (slow) names.emplace_back("robust_percentile_5");
  for (const std::string& name : names) {
    expect_ordered(find_measure(name)->measure(made.contacts, made.frame, made.options),
                   what + name);
  }
  const Measure task = find_measure("task_resistance")->measure;
  if (made.external.stableNorm() >= kSmallestTask) {
    expect_ordered(task(made.contacts, made.frame, made.options), what + "task");
  } else {
    EXPECT_THROW(task(made.contacts, made.frame, made.options), InputError) << what;
  }
}

void expect_sound_forces(const RandomCase& made, const std::string& what) {
  const ContactForces forces =
      balancing_forces(made.contacts, made.frame, made.external,
                       {.cone = made.options.space.cone, .edges = made.options.space.edges});
  EXPECT_TRUE(forces.components.allFinite()) << what;
  EXPECT_TRUE(forces.forces.allFinite()) << what;
  EXPECT_TRUE(std::isfinite(forces.residual)) << what;
  EXPECT_TRUE(std::isfinite(forces.gap)) << what;
  EXPECT_TRUE(forces.separating.allFinite()) << what;
  EXPECT_TRUE(forces.outcome == ForceOutcome::impossible || std::isfinite(forces.lowest)) << what;
}

void expect_sound_sections(const RandomCase& made, const std::string& what) {
  const SetHull hull =
      set_hull(*wrench_space(made.contacts, made.frame, made.options.space), {.max_points = 40});
  const WrenchSections sections = wrench_sections(hull.hull);
  EXPECT_TRUE(sections.forces.vertices.allFinite()) << what;
  EXPECT_TRUE(sections.torques.vertices.allFinite()) << what;
}

TEST(RandomExtremes, AreRefusedOrGiveFiniteNumbersInOrder) {
  int refused = 0;
  int held = 0;
  for (std::uint64_t seed = 1; seed <= kCases; ++seed) {
    const RandomCase made = random_case(seed);
    const std::string what = "case " + std::to_string(seed) + " ";
    if (!accepted(made)) {
      ++refused;
      EXPECT_THROW(grasp_epsilon(made.contacts, made.frame, made.options.space), InputError);
      EXPECT_THROW(balancing_forces(made.contacts, made.frame, made.external), InputError);
      continue;
    }
    try {
      const EpsilonBracket bracket = grasp_epsilon(made.contacts, made.frame, made.options.space);
      EXPECT_TRUE(bracket.weakest.allFinite()) << what;
      held += bracket.force_closure() ? 1 : 0;
      expect_ordered({bracket.lower, bracket.upper}, what + "epsilon ");
      expect_sound_measures(made, seed % 10 == 0, what);
      if (seed % 10 == 0) expect_sound_sections(made, what);
      expect_sound_forces(made, what);
    } catch (const InputError& error) {
      // The wrench to be balanced is the only thing left that may be beyond its range.
      EXPECT_FALSE(made.inside) << what << error.what();
    } catch (const std::exception& error) {
      ADD_FAILURE() << what << error.what();
    }
  }
  // The test would say nothing if most cases were alike.
  EXPECT_GT(refused, kCases / 20);
  EXPECT_GT(held, kCases / 20);
}

}  // namespace
}  // namespace prehend::test
