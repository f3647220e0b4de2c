// One random case planned as a user would, and judged.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "benchmarks/soak/random_case.h"

namespace prehend::soak {

// What a case may use: more is a fault of its own ("slow", "large").
inline constexpr double kMostSeconds = 60.0;      // of processors
inline constexpr double kMostMegabytes = 1000.0;  // resident

struct CaseFindings {
  std::string words;                // what the case is
  std::string refused;              // the message of an InputError, empty without one
  bool interrupted = false;         // nothing of it counts
  std::vector<test::Fault> faults;  // what does not hold
  int grasps = 0;                   // stable ones that were judged
  int other_trials = 0;             // judged trials that did not end in a stable grasp
  int contacts = 0;
  int paths = 0;
  int postures = 0;          // of paths
  int epsilons = 0;          // that were compared
  int twice = 0;             // plans compared on one and two threads
  double epsilon = 0.0;      // largest relative difference
  double penetration = 0.0;  // deepest [m]
  double seconds = 0.0;      // of processors, of the library alone
  double megabytes = 0.0;    // most that was resident
};

// `interrupted` is asked every 50 ms, and ends the case.
CaseFindings run_case(std::uint64_t seed, std::uint64_t number,
                      const std::function<bool()>& interrupted);

}  // namespace prehend::soak
