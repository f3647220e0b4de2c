#include "sim/scene/surface_region.h"

#include <algorithm>
#include <string_view>

#include "sim/base/input_error.h"
#include "sim/base/joined.h"
#include "sim/base/nearest_name.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/nearest_point.h"
#include "sim/shape/proximity.h"

namespace prehend {
namespace {

// A file gives material and part as one name, with a space between them; one of them may be empty.
std::string_view name_of_part(const MeshPart& part) {
  std::string_view name = part.name;
  if (name.starts_with(' ')) name.remove_prefix(1);
  if (name.ends_with(' ')) name.remove_suffix(1);
  return name;
}

bool is_called(std::string_view whole, std::string_view name) {
  if (whole == name) return true;
  if (whole.size() <= name.size()) return false;
  return (whole.starts_with(name) && whole[name.size()] == ' ') ||
         (whole.ends_with(name) && whole[whole.size() - name.size() - 1] == ' ');
}

bool is_near(const ProximityMesh& mesh, const Vector3& p, double margin) {
  const Bounds around{p - Vector3::Constant(margin), p + Vector3::Constant(margin)};
  std::vector<int> triangles;
  find_triangles_in(mesh, around, triangles);
  return std::any_of(triangles.begin(), triangles.end(), [&](int t) {
    return (nearest_point_on(corners_of(mesh.mesh(), t), p) - p).norm() <= margin;
  });
}

}  // namespace

bool is_part_called(const MeshPart& part, const std::string& name) {
  return is_called(name_of_part(part), name);
}

TriangleMesh part_surface(const std::string& name, const std::vector<MeshPart>& parts) {
  constexpr std::size_t kMostListed = 20;
  TriangleMesh surface;
  std::vector<std::string> names;
  std::vector<std::string> meant;  // and what they begin or end with
  for (const MeshPart& part : parts) {
    if (is_part_called(part, name)) append(surface, part.surface);
    const std::string whole(name_of_part(part));
    const bool listed = std::find(names.begin(), names.end(), whole) != names.end();
    if (listed || whole.empty() || names.size() >= kMostListed) continue;
    names.push_back(whole);
    meant.push_back(whole);
    if (const std::size_t space = whole.find(' '); space != whole.npos) {
      meant.push_back(whole.substr(0, space));
      meant.push_back(whole.substr(space + 1));
    }
  }
  require(!surface.empty(),
          {.problem = names.empty()
                          ? "the object has no parts with names; state a shape that it is inside"
                          : "no part of the mesh file is called that; " +
                                did_you_mean(name, meant) + "it has " + joined(names),
           .value = name});
  return surface;
}

void find_file_surface(const FileSurfaces& file, SurfaceRegion& region) {
  if (region.color) {
    region.surface = color_surface(*region.color, file.colors);
  } else if (!region.part.empty()) {
    region.surface = part_surface(region.part, file.parts);
  }
}

SurfaceRegions::SurfaceRegions(const std::vector<SurfaceRegion>& regions) {
  for (const SurfaceRegion& region : regions) {
    if (region.is_of_file()) {
      parts_.emplace_back(region.surface);
    } else if (region.beyond) {
      planes_.push_back(*region.beyond);
    } else {
      shapes_.push_back(region.inside);
    }
  }
}

bool SurfaceRegions::contain(const Vector3& p_O, double margin) const {
  return std::any_of(
             shapes_.begin(), shapes_.end(),
             [&](const Primitive& shape) { return signed_distance(shape, p_O) <= kMargin; }) ||
         std::any_of(planes_.begin(), planes_.end(),
                     [&](const BeyondPlane& plane) {
                       return plane.normal_O.dot(p_O - plane.point_O) >= -kMargin;
                     }) ||
         std::any_of(parts_.begin(), parts_.end(),
                     [&](const ProximityMesh& part) { return is_near(part, p_O, margin); });
}

}  // namespace prehend
