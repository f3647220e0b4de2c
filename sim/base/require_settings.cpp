#include "sim/base/require_settings.h"

#include <limits>

#include "sim/base/formatted.h"
#include "sim/base/input_error.h"

namespace prehend::detail {
namespace {

std::string path_of(const SettingPlace& place) {
  const std::string name(place.name.name);
  return place.outer == nullptr ? name : path_of(*place.outer) + "." + name;
}

// "" or what stands before the name of a setting in this struct.
std::string prefix_in_files(const SettingPlace* place) {
  if (place == nullptr) return "";
  const std::string_view name = place->name.in_files;
  const std::string outer = prefix_in_files(place->outer);
  return name.empty() ? outer : outer + std::string(name) + "_";
}

SettingFault fault_at(const SettingPlace& place, std::string problem, std::string value) {
  return {.path = path_of(place),
          .in_files = prefix_in_files(place.outer) + std::string(place.name.in_files),
          .problem = std::move(problem),
          .value = std::move(value)};
}

}  // namespace

SettingFault fault_of_range(const SettingPlace& place, const Range& range, double value) {
  // Whoever is below the range is not told of an end that nobody comes near.
  constexpr double kNobodyComesNear = 1e5;
  Range told = range;
  if (range.upper >= kNobodyComesNear && !(value > range.upper)) {
    told.upper = std::numeric_limits<double>::infinity();
  }
  return fault_at(place, told.words(), formatted("%.9g", value));
}

SettingFault fault_of_relation(const SettingPlace& place, std::string_view problem) {
  return fault_at(place, std::string(problem), "");
}

void refuse(const SettingFault& fault) {
  throw InputError({.field = fault.path, .problem = fault.problem, .value = fault.value});
}

}  // namespace prehend::detail
