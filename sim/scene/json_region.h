// Regions of an object's surface in scene and grasp files.
#pragma once

#include <vector>

#include "sim/base/json/json_pose.h"
#include "sim/scene/surface_region.h"

namespace prehend {

// A list of {"part": NAME} and {"inside": {shape}} (docs/reference/scene-file.md); the surfaces of
// parts are not known yet. Throws InputError that names the field.
std::vector<SurfaceRegion> read_regions(const JsonField& list);

// The list that read_regions reads.
nlohmann::ordered_json regions_to_json(const std::vector<SurfaceRegion>& regions);

}  // namespace prehend
