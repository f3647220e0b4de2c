#include "sim/scene/color_region.h"

#include <cstddef>

#include "sim/base/input_error.h"
#include "sim/base/joined.h"
#include "sim/shape/weld.h"

namespace prehend {

bool is_within(const ColorRange& range, const SurfaceColor& color) {
  constexpr double kRounding = 1e-6;  // of single precision
  return color && (color->cast<double>() - range.color).norm() <= range.within + kRounding;
}

TriangleMesh color_surface(const ColorRange& range, const ColoredMesh& file) {
  require(!file.empty(),
          {.problem = "the object has no colours of vertices, faces or materials; state a shape "
                      "that it is inside",
           .value = color_text(range.color)});
  TriangleMesh surface{file.surface.vertices, {}};
  for (std::size_t t = 0; t < file.colors.size(); ++t) {
    if (is_within(range, file.colors[t])) surface.triangles.push_back(file.surface.triangles[t]);
  }
  if (surface.empty()) {
    const auto text = [](const ColorShare& one) { return color_text(one.color); };
    throw InputError({.problem = "no triangle has this colour; state one of the file's, most of it "
                                 "has " +
                                 joined(frequent_colors(file), ", ", text) +
                                 ", or a larger \"within\"",
                      .value = color_text(range.color)});
  }
  drop_unused_vertices(surface);
  return surface;
}

}  // namespace prehend
