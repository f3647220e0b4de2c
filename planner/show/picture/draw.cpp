#include "planner/show/picture/draw.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <tuple>

#include "planner/show/picture/screen_triangle.h"
#include "planner/show/picture/surface_detail.h"
#include "planner/show/picture/tile.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/parallel/parallel.h"
#include "sim/base/pool.h"
#include "sim/shape/mesh_checks.h"

namespace prehend {
namespace {

// Pipeline: each body's triangles and lines are transformed to the camera, clipped and projected
// (append_body); the resulting screen triangles are sorted into the tiles that they may touch
// (TileLists); then each tile is rasterised by itself (tile.h), which bounds the memory for
// samples.

void check_range(const char* field, double value, double least, double most) {
  if (value >= least && value <= most) return;
  throw InputError(
      {.field = field,
       .problem = "must be from " + std::to_string(least) + " to " + std::to_string(most),
       .value = std::to_string(value)});
}

void check(const DrawOptions& options) {
  check_range("width", options.width, 1, 16384);
  check_range("height", options.height, 1, 16384);
  check_range("samples", options.samples, 1, 8);
  check_range("crease_angle", options.crease_angle, 0.0, 3.2);
  check_range("line_width", options.line_width, 0.0, 100.0);
}

void check(const DrawnBody& body, std::size_t number) {
  const std::string name = "bodies[" + std::to_string(number) + "].";
  require(body.X_WB.matrix().allFinite(), {.field = name + "X_WB", .problem = "must be finite"});
  for (std::size_t v = 0; v < body.mesh->vertices.size(); ++v) {
    if (!body.mesh->vertices[v].allFinite()) {
      throw InputError({.field = name + "mesh.vertices[" + std::to_string(v) + "]",
                        .problem = "must be finite"});
    }
  }
  require_valid_indices(*body.mesh, name + "mesh");
}

// Opacity in [0, 1]; NaN and negative values count as invisible.
float usable_opacity(const Color& color) {
  return color.opacity > 0.0 ? static_cast<float>(std::min(color.opacity, 1.0)) : 0.0F;
}

// Appends feature lines: creases (faces that meet at more than the crease angle), borders (edges of
// a single face), and silhouettes (edges between a face towards the eye and one away from it).
void append_lines(const SurfaceDetail& detail, const std::vector<CameraVertex>& vertices,
                  const TriangleMesh& mesh, const Matrix3& R_CB, double crease_angle,
                  const LineLook& look, const Projection& projection,
                  std::vector<ScreenTriangle>& out) {
  std::vector<bool> faces_eye(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto corner = static_cast<std::size_t>(mesh.triangles[t][0]);
    // The eye is the origin of the camera frame, so a corner's position is the direction in which
    // it is seen.
    faces_eye[t] = (R_CB * detail.face_normals[t]).dot(vertices[corner].p_C) < 0.0;
  }
  const double least_cosine = std::cos(crease_angle);
  for (const SurfaceEdge& edge : detail.edges) {
    const auto first = static_cast<std::size_t>(edge.first);
    // Borders are always drawn.
    if (edge.second >= 0) {
      const auto second = static_cast<std::size_t>(edge.second);
      const bool crease =
          detail.face_normals[first].dot(detail.face_normals[second]) <= least_cosine;
      if (!crease && faces_eye[first] == faces_eye[second]) continue;
    }
    append_line(vertices[static_cast<std::size_t>(edge.from)].p_C,
                vertices[static_cast<std::size_t>(edge.to)].p_C, look, projection, out);
  }
}

// Appends all triangles and lines of a body, in the frame of the picture.
void append_body(const DrawnBody& body, const DrawOptions& options, const Projection& projection,
                 std::vector<ScreenTriangle>& out) {
  constexpr float kBackOpacity = 0.5F;  // of the front's, when translucent
  constexpr float kLineBrightness = 0.12F;
  const float opacity = usable_opacity(body.color);
  if (opacity == 0.0F) return;
  const bool solid = opacity >= 1.0F;
  const SurfaceDetail detail = surface_detail(*body.mesh, options.crease_angle);
  const Pose X_CB = projection.X_CW() * body.X_WB;
  // Triangles share vertices, so these are transformed once. Normals differ by triangle and are set
  // below.
  std::vector<CameraVertex> vertices(body.mesh->vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) vertices[v].p_C = X_CB * body.mesh->vertices[v];

  // The back of a solid surface is as solid as its front: meshes need not be closed, so a back may
  // be seen.
  const SurfaceLook look{light_of(body.color), opacity, solid ? opacity : kBackOpacity * opacity};
  for (std::size_t t = 0; t < body.mesh->triangles.size(); ++t) {
    // Without area: it has no normal to be shaded with.
    if (detail.face_normals[t].isZero(0.0)) continue;
    std::array<CameraVertex, 3> triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      triangle[k].p_C = vertices[static_cast<std::size_t>(body.mesh->triangles[t][k])].p_C;
      triangle[k].normal_C = X_CB.linear() * detail.corner_normals[t][k];
    }
    append_triangle(triangle, look, projection, out);
  }
  if (options.line_width == 0.0) return;
  // Lines have the hue of their body, much darker. Lines of a translucent body are translucent too;
  // the square root makes them more opaque than its surface, so that they stay visible on faint
  // bodies.
  LineLook line{look.albedo, solid ? 1.0F : std::sqrt(opacity), options.line_width};
  for (float& part : line.color) part *= kLineBrightness;
  append_lines(detail, vertices, *body.mesh, X_CB.linear(), options.crease_angle, line, projection,
               out);
}

// The triangles whose bounding box touches each tile, solid ones first, tiles in reading order.
// Solid triangles come first because a translucent one is compared with the nearest solid surface
// (Tile::add). Of each kind the nearest are first: few are shaded that others hide, and layers come
// in order.
class TileLists {
 public:
  TileLists(const std::vector<ScreenTriangle>& triangles, int width, int height)
      : columns_((width + Tile::kSize - 1) / Tile::kSize),
        rows_((height + Tile::kSize - 1) / Tile::kSize),
        lists_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {
    std::vector<std::tuple<bool, double, const ScreenTriangle*>> order;
    order.reserve(triangles.size());
    for (const ScreenTriangle& triangle : triangles) {
      const auto& depths = triangle.inverse_depths;
      order.emplace_back(triangle.solid(), std::max({depths[0], depths[1], depths[2]}), &triangle);
    }
    std::sort(order.begin(), order.end(), std::greater<>());
    for (const auto& each : order) add(*std::get<2>(each));
  }

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  const std::vector<const ScreenTriangle*>& at(int column, int row) const {
    return lists_[static_cast<std::size_t>(row * columns_ + column)];
  }

 private:
  // Clamped while it is a double: a corner just beyond the near plane may project to a pixel that
  // is outside the range of int.
  static int tile_of(double pixel, int count) {
    return static_cast<int>(std::clamp(std::floor(pixel / Tile::kSize), -1.0, double(count)));
  }

  void add(const ScreenTriangle& triangle) {
    const auto& p = triangle.corners;
    const Eigen::Vector2d low = p[0].cwiseMin(p[1]).cwiseMin(p[2]);
    const Eigen::Vector2d high = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
    const int last_row = std::min(tile_of(high.y(), rows_), rows_ - 1);
    const int last_column = std::min(tile_of(high.x(), columns_), columns_ - 1);
    for (int row = std::max(tile_of(low.y(), rows_), 0); row <= last_row; ++row) {
      for (int column = std::max(tile_of(low.x(), columns_), 0); column <= last_column; ++column) {
        lists_[static_cast<std::size_t>(row * columns_ + column)].push_back(&triangle);
      }
    }
  }

  int columns_;
  int rows_;
  std::vector<std::vector<const ScreenTriangle*>> lists_;
};

// The background.
Image plain(const DrawOptions& options) {
  Image image{options.width, options.height, {}};
  image.rgb.resize(3 * static_cast<std::size_t>(options.width) *
                   static_cast<std::size_t>(options.height));
  const Light light = light_of(options.background);
  for (std::size_t at = 0; at < image.rgb.size(); ++at) image.rgb[at] = display_byte(light[at % 3]);
  return image;
}

}  // namespace

Image draw(const std::vector<DrawnBody>& bodies, const Camera& camera, const DrawOptions& options,
           const RunContext& context) {
  check(options);
  for (std::size_t i = 0; i < bodies.size(); ++i) check(bodies[i], i);
  const Projection projection(camera, options.width, options.height);
  const Lights lights(options.lighting, projection.X_CW().linear() * camera.up);
  std::vector<ScreenTriangle> triangles;
  for (const DrawnBody& body : bodies) {
    context.cancellation.check();
    append_body(body, options, projection, triangles);
  }

  const TileLists lists(triangles, options.width, options.height);
  Image image = plain(options);
  // One tile serves a thread in turn, row after row.
  Pool<std::optional<Tile>> tiles;
  for_each_in_parallel(index(lists.rows()), context.threads, [&](std::size_t i) {
    const Pool<std::optional<Tile>>::Loan tile(tiles);
    if (!tile->has_value()) {
      tile->emplace(projection, lights, options.samples, light_of(options.background));
    }
    const int row = static_cast<int>(i);
    for (int column = 0; column < lists.columns(); ++column) {
      if (lists.at(column, row).empty()) continue;
      context.cancellation.check();
      tile->value().move_to(column * Tile::kSize, row * Tile::kSize);
      for (const ScreenTriangle* triangle : lists.at(column, row)) tile->value().add(*triangle);
      tile->value().write_to(image);
    }
  });
  return image;
}

Camera camera_around(const std::vector<DrawnBody>& bodies, const Vector3& direction,
                     const DrawOptions& options) {
  std::vector<Vector3> points;
  for (const DrawnBody& body : bodies) {
    if (usable_opacity(body.color) == 0.0F) continue;
    for (const Vector3& p_B : body.mesh->vertices) points.push_back(body.X_WB * p_B);
  }
  return camera_around(points, direction, options.width, options.height);
}

Camera camera_around(const Bounds& box, const Vector3& direction, const DrawOptions& options) {
  return camera_around(box, direction, options.width, options.height);
}

}  // namespace prehend
