// Regions of an object's surface in scene and grasp files.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "sim/base/json/json_pose.h"
#include "sim/scene/surface_region.h"

namespace prehend {

// The fields of a region.
inline constexpr auto kRegionFields =
    std::to_array<std::string_view>({"part", "color", "within", "inside", "beyond"});

// One of {"part": NAME}, {"color": COLOUR, "within": DISTANCE}, {"inside": {shape}} and {"beyond":
// {plane}} (docs/reference/scene-file.md) among other fields, which the caller allows; the surfaces
// of parts and colours are not known yet. Throws InputError that names the field.
SurfaceRegion read_region_fields(const JsonField& field);

// A list of these without other fields.
std::vector<SurfaceRegion> read_regions(const JsonField& list);

// The fields that read_region_fields reads.
nlohmann::ordered_json region_to_json(const SurfaceRegion& region);

// The list that read_regions reads.
nlohmann::ordered_json regions_to_json(const std::vector<SurfaceRegion>& regions);

}  // namespace prehend
