// Meshes in the JSON of a report.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/geometry/triangle_mesh.h"

namespace prehend {

// RFC 4648, with padding.
std::string base64(const std::vector<std::uint8_t>& bytes);

// {"positions": base64 of little-endian float32, three a vertex, "indices": base64 of uint32, three
// a triangle}. Metres, in the mesh's frame.
nlohmann::ordered_json packed_mesh(const TriangleMesh& mesh);

}  // namespace prehend
