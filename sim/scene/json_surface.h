// Materials of one's own, and parts of surfaces that are made of them, in scene files.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/base/json/json_field.h"
#include "sim/scene/surface_material.h"

namespace prehend {

struct Scene;

// Materials of a scene file by their names.
using NamedMaterials = std::map<std::string, SurfaceMaterial, std::less<>>;

// An object of {NAME: {"like": MATERIAL, "friction": ..., "compliant_depth": ...}}
// (docs/reference/scene-file.md). Throws InputError that names the field.
NamedMaterials read_materials(const JsonField& object);

// A list of regions (json_region.h) with a "material" each, which may be one of `named`; the
// surfaces of parts and colours are not known yet. Throws InputError that names the field.
std::vector<MaterialRegion> read_surfaces(const JsonField& list, const NamedMaterials& named);

// Fills in the surfaces of regions that read_surfaces read from the list. Throws InputError that
// names the field for a part or colour that the file does not have, and for a region without any
// surface of the mesh.
void find_surfaces(const JsonField& list, const FileSurfaces& file, const TriangleMesh& mesh,
                   std::vector<MaterialRegion>& surfaces);

// What these functions read; the materials are those of all surfaces of the scene.
nlohmann::ordered_json surfaces_to_json(const std::vector<MaterialRegion>& surfaces);
nlohmann::ordered_json materials_to_json(const Scene& scene);

}  // namespace prehend
