// Meshes in the JSON of a report.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// RFC 4648, with padding.
std::string base64(const std::vector<std::uint8_t>& bytes);

// {"positions": base64 of little-endian float32, three a vertex, "indices": base64 of uint32, three
// a triangle}. Metres, in the mesh's frame.
nlohmann::ordered_json packed_mesh(const TriangleMesh& mesh);

// The same of a mesh to look at, simplified to so many triangles where it has more; how many it had
// is then "simplified_from".
nlohmann::ordered_json drawn_mesh(const TriangleMesh& mesh, std::size_t most_triangles);

// So many triangles show the surface of a body.
inline constexpr std::size_t kMostDrawnTriangles = 60000;

}  // namespace prehend
