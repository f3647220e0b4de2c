#include "sim/scene/json_region.h"

#include "sim/scene/json_primitive.h"

namespace prehend {
namespace {

SurfaceRegion read_region(const JsonField& field) {
  field.allow_only({"part", "inside"});
  if (field.has("part") == field.has("inside")) field.fail("needs one of part, inside");
  SurfaceRegion region;
  if (field.has("part")) {
    region.part = field["part"].text();
    if (region.part.empty()) field["part"].fail("must not be empty");
  } else {
    region.inside = read_primitive(field["inside"]);
    if (is_curve(region.inside.shape)) {
      field["inside"]["shape"].fail("must be box, sphere, cylinder or cone");
    }
  }
  return region;
}

}  // namespace

std::vector<SurfaceRegion> read_regions(const JsonField& list) {
  std::vector<SurfaceRegion> regions;
  for (const JsonField& field : list.items()) regions.push_back(read_region(field));
  return regions;
}

nlohmann::ordered_json regions_to_json(const std::vector<SurfaceRegion>& regions) {
  auto list = nlohmann::ordered_json::array();
  for (const SurfaceRegion& region : regions) {
    if (region.part.empty()) {
      list.push_back({{"inside", primitive_to_json(region.inside)}});
    } else {
      list.push_back({{"part", region.part}});
    }
  }
  return list;
}

}  // namespace prehend
