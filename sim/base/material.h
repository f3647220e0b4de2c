// The materials that robot and scene files can name, and their densities.
#pragma once

#include <array>
#include <string_view>

#include "sim/base/named_enum.h"

namespace prehend {

// What a link or an object is made of.
enum class Material { glass, metal, plastic, wood, rubber };

// Name in files: "glass", "metal", "plastic", "wood" or "rubber".
constexpr auto enum_names(Material /*of*/) {
  return std::to_array<std::string_view>({"glass", "metal", "plastic", "wood", "rubber"});
}

// The material with this name. Throws InputError that lists the known names for any other name.
Material material_named(std::string_view name);

// Density [kg/m^3], a round figure of a typical material of each kind: soda-lime glass (EN 572-1),
// aluminium alloys (EN 1999-1-1), ABS, oak and beech (Wood Handbook, USDA Forest Products
// Laboratory, table 5-3), filled natural rubber. docs/reference/robot-file.md has the table.
double density_of(Material material);

}  // namespace prehend
