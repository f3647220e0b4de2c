#include "benchmarks/suite/sample_grasps.h"

#include "sim/quality/epsilon.h"
#include "tests/support/grasp_families.h"

namespace prehend::bench {

std::vector<std::vector<Contact>> holding_grasps(int contacts, int count) {
  // Three random contacts hold rarely.
  constexpr int kTries = 20000;
  constexpr double kFriction = 0.8;
  Random random(static_cast<std::uint64_t>(contacts));
  std::vector<std::vector<Contact>> grasps;
  for (int i = 0; i < kTries && grasps.size() < static_cast<std::size_t>(count); ++i) {
    const std::vector<Contact> grasp = test::random_grasp(random, contacts, kFriction);
    if (epsilon_l1(contact_wrenches(grasp, {})).force_closure()) grasps.push_back(grasp);
  }
  return grasps;
}

}  // namespace prehend::bench
