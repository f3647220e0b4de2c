#include "sim/base/material.h"

#include <string>

#include "sim/base/input_error.h"

namespace prehend {
namespace {

struct Properties {
  std::string_view name;
  double density;  // kg/m^3
};

// In the order of Material.
constexpr std::array<Properties, 5> kProperties = {{{"glass", 2500.0},
                                                    {"metal", 2700.0},
                                                    {"plastic", 1050.0},
                                                    {"wood", 700.0},
                                                    {"rubber", 1100.0}}};

const Properties& of(Material material) {
  return kProperties.at(static_cast<std::size_t>(material));
}

}  // namespace

std::string_view material_name(Material material) { return of(material).name; }

Material material_named(std::string_view name) {
  for (const Material material : kMaterials) {
    if (material_name(material) == name) return material;
  }
  throw InputError({.problem = "unknown material, known are glass, metal, plastic, wood and rubber",
                    .value = std::string(name)});
}

double density_of(Material material) { return of(material).density; }

}  // namespace prehend
