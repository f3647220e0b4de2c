#include "planner/show/picture/vertex_arrays.h"

#include <map>
#include <string>

#include "planner/show/picture/surface_detail.h"
#include "sim/base/input_error.h"
#include "sim/shape/mesh_checks.h"

namespace prehend {
namespace {

// Coordinates are checked as they will be stored: large doubles become infinite in single
// precision.
void check(const TriangleMesh& mesh) {
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!mesh.vertices[v].cast<float>().allFinite()) {
      throw InputError(
          {.field = "mesh.vertices[" + std::to_string(v) + "]", .problem = "must be finite"});
    }
  }
  require_valid_indices(mesh, "mesh");
}

std::array<float, 3> single(const Vector3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

}  // namespace

// Graphics hardware has one index for position and normal together, while corner_normals has a
// normal for each corner of a triangle. Corners with equal position and normal become one vertex,
// in the order in which the triangles first use them.
VertexArrays vertex_arrays(const TriangleMesh& mesh, double crease_angle) {
  check(mesh);
  const SurfaceDetail detail = surface_detail(mesh, crease_angle);
  VertexArrays arrays;
  // Compared in single precision, as they are stored: two vertices that differ less are written as
  // one.
  std::map<std::array<std::array<float, 3>, 2>, std::uint32_t> known;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (detail.face_normals[t].isZero(0.0)) continue;
    std::array<std::uint32_t, 3>& triangle = arrays.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(mesh.triangles[t][k]);
      const std::array<float, 3> position = single(mesh.vertices[v]);
      const std::array<float, 3> normal = single(detail.corner_normals[t][k]);
      const auto next = static_cast<std::uint32_t>(arrays.positions.size());
      const auto [vertex, is_new] = known.try_emplace({position, normal}, next);
      triangle[k] = vertex->second;
      if (!is_new) continue;
      arrays.positions.push_back(position);
      arrays.normals.push_back(normal);
    }
  }
  return arrays;
}

}  // namespace prehend
