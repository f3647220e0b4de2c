#include "planner/path/sample_count.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/base/input_error.h"

namespace prehend {

int step_count(double duration, double sample_time) {
  constexpr double kMost = 1e7;
  const double steps = std::ceil(duration / sample_time);
  if (!(steps <= kMost)) {
    throw InputError("joint path: takes " + std::to_string(duration) +
                     " s, too many samples: its limits or sample_time are too small");
  }
  return std::max(1, static_cast<int>(steps));
}

}  // namespace prehend
