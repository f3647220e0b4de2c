// What `quality` says of random degenerate grasps, beside exact arithmetic.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace prehend::test {

// The cases of one kind of grasp (tests/support/degenerate_grasps.h).
struct ExactTally {
  std::string kind;
  int cases = 0;
  int closed = 0;      // in force closure
  int limited = 0;     // the status says that only bounds are known
  double worst = 0.0;  // largest relative difference of a converged bound
  std::vector<std::string> faults;
};

// Goes through a file of contacts, as the command does. So many cases of each kind, all different.
std::vector<ExactTally> exact_cases(int of_each_kind, std::uint64_t seed);

}  // namespace prehend::test
