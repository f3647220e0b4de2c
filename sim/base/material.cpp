#include "sim/base/material.h"

#include <string>

#include "sim/base/input_error.h"

namespace prehend {

Material material_named(std::string_view name) {
  if (const std::optional<Material> material = value_named<Material>(name)) return *material;
  throw InputError({.problem = "unknown material, known are glass, metal, plastic, wood and rubber",
                    .value = std::string(name)});
}

double density_of(Material material) {
  constexpr EnumArray<Material, double> kDensities{{2500.0, 2700.0, 1050.0, 700.0, 1100.0}};
  return kDensities[material];
}

}  // namespace prehend
