#include "sim/shape/cloud/files/depth_checks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"

namespace prehend {
namespace {

constexpr std::size_t kFewestReadings = 10;

}  // namespace

void check_camera(const DepthCamera& camera) {
  const auto focal = [](double f, const char* field) {
    require(f > 0.0 && f <= 1e6, {.field = field,
                                  .problem = "must be above 0 and at most 1e6 pixels",
                                  .value = formatted("%.6g", f)});
  };
  focal(camera.fx, "fx");
  focal(camera.fy, "fy");
  const auto near = [](double c, int size, const char* field) {
    require(c >= -0.5 * size && c <= 1.5 * size,
            {.field = field,
             .problem = formatted("is far outside the image, which has %d pixels there", size),
             .value = formatted("%.6g", c)});
  };
  near(camera.cx, camera.width, "cx");
  near(camera.cy, camera.height, "cy");
}

void require_plausible(std::vector<float>& distances) {
  constexpr float kFar = 50.0F;
  constexpr float kFarMiddle = 20.0F;
  constexpr float kNearMiddle = 0.005F;
  require(distances.size() >= kFewestReadings,
          {.problem = formatted("only %zu readings; at least %zu are needed", distances.size(),
                                kFewestReadings)});
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  const float nearest = *std::min_element(distances.begin(), middle + 1);
  const bool far = nearest > kFar || *middle > kFarMiddle;
  require(!far, {.field = "unit",
                 .problem = "distances look like millimetres that were read in metres: state the "
                            "unit",
                 .value = formatted("middle distance %.4g m", static_cast<double>(*middle))});
  require(*middle >= kNearMiddle,
          {.field = "unit",
           .problem = "distances are smaller than any camera's: state the unit",
           .value = formatted("middle distance %.4g m", static_cast<double>(*middle))});
}

DepthView checked_view(const DepthCamera& camera, std::vector<float> depth) {
  try {
    check_camera(camera);
  } catch (const InputError& error) {
    throw error.under("camera");
  }
  require(depth.size() == index(camera.width) * index(camera.height),
          {.field = "depth", .problem = "has another size than its camera's image"});
  std::vector<float> readings;
  for (float& z : depth) {
    if (!std::isfinite(z) || z <= 0.0F) {
      z = 0.0F;
    } else {
      readings.push_back(z);
    }
  }
  require_plausible(readings);
  return {camera, std::move(depth)};
}

}  // namespace prehend
