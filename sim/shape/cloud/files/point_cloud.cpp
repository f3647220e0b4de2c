#include "sim/shape/cloud/files/point_cloud.h"

#include <cmath>
#include <limits>
#include <string>

#include "sim/base/input_error.h"

namespace prehend {

void require_few(std::size_t count, std::string_view what) {
  require(count <= kMostReadings,
          {.problem = "more " + std::string(what) + " than the 10,000,000 that are read together",
           .value = std::to_string(count)});
}

float in_single(double value) {
  constexpr double kMost = std::numeric_limits<float>::max();
  if (std::abs(value) <= kMost || std::isnan(value)) return static_cast<float>(value);
  return std::numeric_limits<float>::infinity();
}

}  // namespace prehend
