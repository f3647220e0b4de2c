#include "planner/show/primitives_picture.h"

#include <string>
#include <utility>

#include "planner/show/palette.h"
#include "planner/show/picture/draw.h"
#include "planner/show/picture/label.h"
#include "primitives/decompose.h"
#include "sim/base/formatted.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

TriangleMesh surface_of(const Box& box) { return make_box(box.size); }
TriangleMesh surface_of(const Sphere& sphere) { return make_sphere(sphere.radius); }
TriangleMesh surface_of(const Cylinder& tube) { return make_cylinder(tube.radius, tube.height); }
TriangleMesh surface_of(const Cone& cone) {
  TriangleMesh mesh = make_cylinder(1.0, cone.height);
  for (Vector3& p : mesh.vertices) {
    const double up = 0.5 + p.z() / cone.height;
    p.head<2>() *= cone.radius_low + up * (cone.radius_high - cone.radius_low);
  }
  return mesh;
}
// Thin parts are no part of a decomposition.
TriangleMesh surface_of(const Rim&) { return {}; }
TriangleMesh surface_of(const Bar&) { return {}; }

std::string distances_text(const SurfaceDistances& distances) {
  return formatted("median %.2f, 95 %% %.2f mm", 1e3 * distances.median,
                   1e3 * distances.percentile_95);
}

// A line in its colour for each primitive, below one for all.
void write_distances(Image& image, const Decomposition& parts) {
  constexpr int kScale = 2;
  constexpr int kFromEdge = 8;
  const int line = text_size("0", kScale).height + 4;
  int y = kFromEdge;
  label(image, kFromEdge, y, "surface: " + distances_text(parts.distances), palette::kText, kScale);
  for (std::size_t k = 0; k < parts.primitives.size(); ++k) {
    y += line;
    const std::string name(shape_name(parts.primitives[k].shape));
    label(image, kFromEdge, y,
          formatted("%s, %.0f %%: ", name.c_str(), 100.0 * parts.share[k]) +
              distances_text(parts.distances_of[k]),
          palette::kTips[k % palette::kTips.size()], kScale);
  }
}

}  // namespace

Image primitives_picture(const TriangleMesh& mesh, const Decomposition& parts,
                         const PictureSize& size, const RunContext& context) {
  constexpr Color kSurface{0.80, 0.78, 0.70, 1.0};
  std::vector<DrawnBody> bodies = {{SharedMesh::borrowed(mesh), Pose::Identity(), kSurface, ""}};
  for (std::size_t k = 0; k < parts.primitives.size(); ++k) {
    const Primitive& primitive = parts.primitives[k];
    bodies.push_back(
        {std::visit([](const auto& shape) { return surface_of(shape); }, primitive.shape),
         primitive.X_OP, palette::of_solid(k), ""});
  }
  const DrawOptions half{.width = size.width / 2, .height = size.height};
  std::vector<Image> views;
  for (const Vector3& direction : {Vector3(1.0, -1.2, 0.8), Vector3(-1.2, 1.0, 0.5)}) {
    views.push_back(draw(bodies, camera_around(bodies, direction, half), half, context));
  }
  Image image = grid(views, 2);
  write_distances(image, parts);
  return image;
}

}  // namespace prehend
