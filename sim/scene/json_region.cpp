#include "sim/scene/json_region.h"

#include <optional>
#include <string>

#include "sim/base/range.h"
#include "sim/scene/json_primitive.h"

namespace prehend {
namespace {

// "#rrggbb", or a list of red, green and blue.
Vector3 read_color(const JsonField& field) {
  if (field.is_list()) {
    const std::vector<double> parts = field.numbers(3, kFraction);
    return {parts[0], parts[1], parts[2]};
  }
  const std::optional<Vector3> color = field.is_text() ? color_in_text(field.text()) : std::nullopt;
  if (!color) field.fail(std::string(kColorWords) + ", or three numbers from 0 to 1");
  return *color;
}

ColorRange read_color_range(const JsonField& field) {
  return {read_color(field["color"]),
          field.number_or("within", ColorRange::kWithin,
                          {.lower = 0.0, .upper = ColorRange::kFarthest})};
}

// As a word where that reads back as the same numbers.
nlohmann::ordered_json color_range_to_json(const ColorRange& range) {
  nlohmann::ordered_json json;
  const std::string word = color_text(range.color);
  if (color_in_text(word) == range.color) {
    json["color"] = word;
  } else {
    json["color"] = {range.color.x(), range.color.y(), range.color.z()};
  }
  if (range.within != ColorRange::kWithin) json["within"] = range.within;
  return json;
}

}  // namespace

SurfaceRegion read_region_fields(const JsonField& field) {
  const int given = int{field.has("part")} + int{field.has("color")} + int{field.has("inside")} +
                    int{field.has("beyond")};
  if (given != 1) field.fail("needs one of part, color, inside, beyond");
  if (field.has("within") && !field.has("color")) field["within"].fail("only beside color");
  SurfaceRegion region;
  if (field.has("part")) {
    region.part = field["part"].text();
    if (region.part.empty()) field["part"].fail("must not be empty");
  } else if (field.has("color")) {
    region.color = read_color_range(field);
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
    field.allow_only(kRegionFields);
    regions.push_back(read_region_fields(field));
  }
  return regions;
}

nlohmann::ordered_json region_to_json(const SurfaceRegion& region) {
  if (!region.part.empty()) return {{"part", region.part}};
  if (region.color) return color_range_to_json(*region.color);
  if (region.beyond) return {{"beyond", beyond_to_json(*region.beyond)}};
  return {{"inside", primitive_to_json(region.inside)}};
}

nlohmann::ordered_json regions_to_json(const std::vector<SurfaceRegion>& regions) {
  auto list = nlohmann::ordered_json::array();
  for (const SurfaceRegion& region : regions) list.push_back(region_to_json(region));
  return list;
}

}  // namespace prehend
