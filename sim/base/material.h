// Materials by name, and how heavy they are.
#pragma once

#include <array>
#include <string_view>

namespace prehend {

enum class Material { glass, metal, plastic, wood, rubber };

inline constexpr std::array<Material, 5> kMaterials = {
    Material::glass, Material::metal, Material::plastic, Material::wood, Material::rubber};

std::string_view material_name(Material material);

// Throws InputError that lists the names.
Material material_named(std::string_view name);

// Mass of a cubic metre [kg/m^3], a round figure of a typical material of each kind: soda-lime
// glass (EN 572-1), aluminium alloys (EN 1999-1-1), ABS, oak and beech (Wood Handbook, USDA Forest
// Products Laboratory, table 5-3), filled natural rubber. docs/robot-file.md has the table.
double density_of(Material material);

}  // namespace prehend
