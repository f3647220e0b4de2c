// Random grasps of degenerate kinds, through the reader and the measures of `quality` and through
// exact arithmetic (exact_cases.h). Some minutes for 3,000.
//   compare_exactly [CASES OF EACH KIND [SEED]]
// Prints a table and each fault. Exit status 1 after a fault.
#include <cstdio>
#include <exception>
#include <string>

#include "benchmarks/sim/quality/exact_cases.h"

int main(int argc, char** argv) {
  try {
    const int of_each_kind = argc > 1 ? std::stoi(argv[1]) : 170;
    const std::uint64_t seed = argc > 2 ? std::stoull(argv[2]) : 1;
    std::size_t faults = 0;
    std::printf("| kind | cases | force closure | bounds only | largest difference | faults |\n");
    std::printf("|---|--:|--:|--:|--:|--:|\n");
    for (const prehend::test::ExactTally& tally : prehend::test::exact_cases(of_each_kind, seed)) {
      std::printf("| %s | %d | %d | %d | %.0e | %zu |\n", tally.kind.c_str(), tally.cases,
                  tally.closed, tally.limited, tally.worst, tally.faults.size());
      std::fflush(stdout);
      for (const std::string& fault : tally.faults) std::fprintf(stderr, "%s\n", fault.c_str());
      faults += tally.faults.size();
    }
    return faults == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "compare_exactly: %s\n", error.what());
    return 2;
  }
}
