#include "sim/scene/surface_region.h"

#include <algorithm>
#include <string_view>

#include "sim/base/input_error.h"
#include "sim/base/joined.h"
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

TriangleMesh part_surface(const std::string& name, const std::vector<MeshPart>& parts) {
  constexpr std::size_t kMostListed = 20;
  TriangleMesh surface;
  std::vector<std::string_view> names;
  for (const MeshPart& part : parts) {
    const std::string_view whole = name_of_part(part);
    if (is_called(whole, name)) append(surface, part.surface);
    const bool listed = std::find(names.begin(), names.end(), whole) != names.end();
    if (!listed && !whole.empty() && names.size() < kMostListed) names.push_back(whole);
  }
  require(!surface.empty(),
          {.problem = names.empty()
                          ? "the object has no parts with names; state a shape that it is inside"
                          : "no part of the mesh file is called that; it has " + joined(names),
           .value = name});
  return surface;
}

SurfaceRegions::SurfaceRegions(const std::vector<SurfaceRegion>& regions) {
  for (const SurfaceRegion& region : regions) {
    if (region.part.empty()) {
      shapes_.push_back(region.inside);
    } else {
      parts_.emplace_back(region.surface);
    }
  }
}

bool SurfaceRegions::contain(const Vector3& p_O, double margin) const {
  return std::any_of(
             shapes_.begin(), shapes_.end(),
             [&](const Primitive& shape) { return signed_distance(shape, p_O) <= kMargin; }) ||
         std::any_of(parts_.begin(), parts_.end(),
                     [&](const ProximityMesh& part) { return is_near(part, p_O, margin); });
}

}  // namespace prehend
