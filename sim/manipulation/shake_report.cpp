#include "sim/manipulation/shake_report.h"

#include <algorithm>

namespace prehend {
namespace {

bool is_preparation(const ShakeTestReport& test) { return test.name == "prepare"; }

}  // namespace

int ShakeReport::survived() const {
  return static_cast<int>(std::count_if(tests.begin(), tests.end(), [](const auto& test) {
    return !is_preparation(test) && test.outcome == ShakeOutcome::survived;
  }));
}

int ShakeReport::count() const {
  return static_cast<int>(std::count_if(tests.begin(), tests.end(),
                                        [](const auto& test) { return !is_preparation(test); }));
}

bool ShakeReport::holds() const {
  return std::all_of(tests.begin(), tests.end(),
                     [](const auto& test) { return test.outcome == ShakeOutcome::survived; });
}

std::optional<double> ShakeReport::largest_pull() const {
  std::optional<double> weakest;
  for (const ShakeTestReport& test : tests) {
    if (!test.largest_pull) continue;
    weakest = std::min(weakest.value_or(kNoLimit), *test.largest_pull);
  }
  return weakest;
}

}  // namespace prehend
