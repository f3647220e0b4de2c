#include "sim/quality/measures.h"

#include <set>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/quality/wrench_hull.h"
#include "tests/support/grasp_families.h"

namespace prehend::test {
namespace {

MeasureOptions everything() {
  MeasureOptions options;
  options.task = TaskGravity{};
  options.surface = cube_grasp(0.5);
  options.noise.samples = 20;
  options.jacobian = Eigen::MatrixXd::Identity(3, 3);
  return options;
}

TEST(Measures, AllAreBoundsThatDoNotCross) {
  Random random(30);
  std::set<std::string_view> names;
  for (const NamedMeasure& named : measures()) {
    EXPECT_TRUE(names.insert(named.name).second) << named.name;
    for (const Contacts& contacts :
         {Contacts{}, random_grasp(random, 1, 0.5), random_grasp(random, 5, 0.7)}) {
      const Interval value = named.measure(contacts, {}, everything());
      EXPECT_LE(value.lower, value.upper) << named.name;
      EXPECT_GE(value.lower, 0.0) << named.name;
    }
  }
}

TEST(Measures, EpsilonAndVolumeAreThoseOfTheHull) {
  const Contacts contacts = octahedron_grasp(0.5);
  const WrenchHull hull = wrench_hull(contact_wrenches(contacts, {}));
  const Interval epsilon = find_measure("epsilon")->measure(contacts, {}, {});
  EXPECT_NEAR(epsilon.lower, hull.min_offset, 1e-9);
  const Interval volume = find_measure("volume")->measure(contacts, {}, {});
  EXPECT_NEAR(volume.lower, hull.volume, 1e-6 * hull.volume);
  EXPECT_NEAR(volume.upper, hull.volume, 1e-6 * hull.volume);
  EXPECT_EQ(find_measure("force_closure")->measure(contacts, {}, {}).lower, 1.0);
}

TEST(Measures, SayWhatTheyMiss) {
  for (const char* name : {"task_resistance", "object_wrench_ratio", "manipulability"}) {
    try {
      find_measure(name)->measure(octahedron_grasp(0.5), {}, {});
      ADD_FAILURE() << name;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind(name, 0), 0U) << error.what();
    }
  }
  EXPECT_EQ(find_measure("beauty"), nullptr);
}

}  // namespace
}  // namespace prehend::test
