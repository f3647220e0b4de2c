// Parts of a surface by the colours that its mesh file gives it.
#pragma once

#include "sim/shape/files/mesh_color.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Colours about one. Distances are Euclidean, of red, green and blue, each from 0 to 1 (sRGB).
struct ColorRange {
  static constexpr double kWithin = 0.2;
  static constexpr double kFarthest = 2.0;  // beyond the distance of any two colours

  Vector3 color = Vector3::Zero();  // each part from 0 to 1
  double within = kWithin;          // the largest distance, 0 to kFarthest
};

// What both the command line and scene files say of a word that is no colour.
inline constexpr const char* kColorWords =
    R"(must be a colour, such as "#cc3311": # and two hexadecimal digits each of red, green, blue)";

// Whether a surface has a colour, and one in the range.
bool is_within(const ColorRange& range, const SurfaceColor& color);

// The triangles of such a colour. Throws InputError where there is none, with the file's most
// frequent colours, and where it has no colours.
TriangleMesh color_surface(const ColorRange& range, const ColoredMesh& file);

}  // namespace prehend
