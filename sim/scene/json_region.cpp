#include "sim/scene/json_region.h"

#include "sim/scene/json_primitive.h"

namespace prehend {

SurfaceRegion read_region_fields(const JsonField& field) {
  const int given = int{field.has("part")} + int{field.has("inside")} + int{field.has("beyond")};
  if (given != 1) field.fail("needs one of part, inside, beyond");
  SurfaceRegion region;
  if (field.has("part")) {
    region.part = field["part"].text();
    if (region.part.empty()) field["part"].fail("must not be empty");
  } else if (field.has("beyond")) {
    region.beyond = read_beyond(field["beyond"]);
  } else {
    region.inside = read_primitive(field["inside"]);
    if (is_curve(region.inside.shape)) {
      field["inside"]["shape"].fail("must be box, sphere, cylinder or cone");
    }
  }
  return region;
}

std::vector<SurfaceRegion> read_regions(const JsonField& list) {
  std::vector<SurfaceRegion> regions;
  for (const JsonField& field : list.items()) {
    field.allow_only({"part", "inside", "beyond"});
    regions.push_back(read_region_fields(field));
  }
  return regions;
}

nlohmann::ordered_json region_to_json(const SurfaceRegion& region) {
  if (!region.part.empty()) return {{"part", region.part}};
  if (region.beyond) return {{"beyond", beyond_to_json(*region.beyond)}};
  return {{"inside", primitive_to_json(region.inside)}};
}

nlohmann::ordered_json regions_to_json(const std::vector<SurfaceRegion>& regions) {
  auto list = nlohmann::ordered_json::array();
  for (const SurfaceRegion& region : regions) list.push_back(region_to_json(region));
  return list;
}

}  // namespace prehend
