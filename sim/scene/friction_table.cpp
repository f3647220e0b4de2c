#include "sim/scene/friction_table.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/base/input_error.h"
#include "sim/base/range.h"
#include "sim/quality/ranges.h"

namespace prehend {
namespace {

std::size_t place_of(Material material) { return static_cast<std::size_t>(material); }

void require_friction(Material a, Material b, double friction) {
  try {
    checked_friction(friction);
  } catch (const InputError& error) {
    throw InputError({.field = error.field(),
                      .problem = error.problem() + " between " + std::string(name_of(a)) + " and " +
                                 std::string(name_of(b)),
                      .value = error.value()});
  }
}

}  // namespace

double checked_friction(double friction) {
  if (friction >= 0.0 && friction <= kLargestFriction) return friction;
  throw InputError(
      {.field = "friction", .problem = "must be from 0 to 1e6", .value = std::to_string(friction)});
}

// Rows and columns are in the order of Material: glass, metal, plastic, wood, rubber.
FrictionTable::FrictionTable()
    : values_{{{0.2, 0.2, 0.2, 0.3, 1.0},
               {0.2, 0.2, 0.2, 0.3, 1.0},
               {0.2, 0.2, 0.3, 0.4, 1.0},
               {0.3, 0.3, 0.4, 0.4, 1.0},
               {1.0, 1.0, 1.0, 1.0, 2.0}}} {}

double FrictionTable::between(Material a, Material b) const {
  return values_[place_of(a)][place_of(b)];
}

void FrictionTable::set(Material a, Material b, double friction) {
  require_friction(a, b, friction);
  values_[place_of(a)][place_of(b)] = friction;
  values_[place_of(b)][place_of(a)] = friction;
}

std::optional<double> KineticFriction::between(Material a, Material b) const {
  return values_[place_of(a)][place_of(b)];
}

void KineticFriction::set(Material a, Material b, std::optional<double> friction) {
  if (friction) require_friction(a, b, *friction);
  values_[place_of(a)][place_of(b)] = friction;
  values_[place_of(b)][place_of(a)] = friction;
}

bool KineticFriction::empty() const {
  return std::all_of(values_.begin(), values_.end(), [](const auto& row) {
    return std::none_of(row.begin(), row.end(),
                        [](const auto& value) { return value.has_value(); });
  });
}

FrictionTable sliding_friction(const FrictionTable& statics, const KineticFriction& kinetic) {
  FrictionTable table = statics;
  for (const Material a : kAll<Material>) {
    for (const Material b : kAll<Material>) {
      if (const std::optional<double> own = kinetic.between(a, b)) table.set(a, b, *own);
    }
  }
  return table;
}

std::optional<double> FrictionDeviations::between(Material a, Material b) const {
  return values_[place_of(a)][place_of(b)];
}

void FrictionDeviations::set(Material a, Material b, std::optional<double> deviation) {
  constexpr double kLargest = 10.0;
  require(!deviation || (*deviation >= 0.0 && *deviation <= kLargest),
          {.field = "deviation",
           .problem = "must be from 0 to 10",
           .value = std::to_string(deviation.value_or(0.0))});
  values_[place_of(a)][place_of(b)] = deviation;
  values_[place_of(b)][place_of(a)] = deviation;
}

double CompliantDepths::of(Material material) const { return values_[place_of(material)]; }

void CompliantDepths::set(Material material, double depth) {
  if (!std::isfinite(depth) || depth < 0.0) {
    throw InputError(
        {.field = "depth",
         .problem = "must be finite and not negative for " + std::string(name_of(material)),
         .value = std::to_string(depth)});
  }
  values_[place_of(material)] = depth;
}

double CompliantDepths::between(Material a, Material b) const { return std::max(of(a), of(b)); }

}  // namespace prehend
