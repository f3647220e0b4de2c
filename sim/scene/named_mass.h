// The mass of an object whose mesh file names what its pieces are made of.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/scene/scene.h"
#include "sim/shape/files/mesh_file.h"

namespace prehend {

struct NamedMaterial {
  std::string_view name;
  double density = 0.0;  // kg/m^3
};

// The first material that is a word of this name, "steel" of "HammerSteel.001 head". Densities are
// typical ones at room temperature (CRC Handbook of Chemistry and Physics, "Density of Various
// Solids").
std::optional<NamedMaterial> material_in(std::string_view name);

// The parts of a mesh that is made larger by a factor.
std::vector<MeshPart> scaled(std::vector<MeshPart> parts, double factor);

// Spreads the mass of an object of which only the whole may be stated [kg] by the densities of its
// pieces (MassOfParts), and adds a note. A piece has the name of the smallest part whose bounds
// contain it. Changes nothing unless the material of each piece is known and they are of more than
// one: what is filled evenly weighs the same all over, and a can named after its metal is hollow.
void spread_named_mass(GraspableBody& object, const std::vector<MeshPart>& parts,
                       std::optional<double> mass, std::vector<std::string>& notes);

}  // namespace prehend
