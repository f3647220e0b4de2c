// Colours that mesh files give to their surfaces: to vertices, faces or materials.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Red, green and blue as screens show them (sRGB), each from 0 to 1; none where a file says none.
// In single precision: files have at most 16 bits of each.
using SurfaceColor = std::optional<Eigen::Vector3f>;

// The triangles of a file, as they stand there, and the colour of each, which is the mean of its
// corners. Both are empty where colours were not asked for and where the file has none.
struct ColoredMesh {
  TriangleMesh surface = {};  // not welded, nothing left out [m]
  std::vector<SurfaceColor> colors = {};

  bool empty() const { return colors.empty(); }
};

// A part of a colour as a number from 0 to `full`: from 0 to 1. None for what is not in that range
// or no number.
std::optional<float> color_part(double value, double full);

// A part of a colour in which light is added, as in glTF: as screens show it. Both from 0 to 1
// (IEC 61966-2-1).
float shown_part(float light);

// The mean of the colours of a triangle's vertices, of which number `first` has the first colour;
// none where one of them has none.
SurfaceColor mean_color(const std::vector<SurfaceColor>& of_vertices, const Triangle& triangle,
                        std::size_t first = 0);

// "#rrggbb" of a colour, each part rounded to 1/255; and the colour that such a word means, with
// digits in upper or lower case, or nullopt for any other word.
std::string color_text(const Vector3& color);
std::optional<Vector3> color_in_text(std::string_view word);

// A colour of a surface, and how much of it has it.
struct ColorShare {
  Vector3 color;
  double share = 0.0;  // of the whole area, from 0 to 1
};

// Up to five colours, the most frequent first. Colours that are nearer to one of these than 0.1
// (Euclidean, of parts from 0 to 1) count as that: scans have as many as triangles.
std::vector<ColorShare> frequent_colors(const ColoredMesh& mesh);

}  // namespace prehend
