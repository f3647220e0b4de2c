#include "planner/show/picture/screen_triangle.h"

#include <cmath>

namespace prehend {
namespace {

// Where the edge from `inside` to `outside` passes the near plane. The interpolation always starts
// at the inner vertex, so that two triangles with a common edge are cut at exactly the same point
// and no gap opens between them.
CameraVertex cut(const CameraVertex& inside, const CameraVertex& outside, double near_depth) {
  const double part = (near_depth - inside.p_C.z()) / (outside.p_C.z() - inside.p_C.z());
  CameraVertex vertex;
  vertex.p_C = inside.p_C + part * (outside.p_C - inside.p_C);
  vertex.p_C.z() = near_depth;
  vertex.normal_C = inside.normal_C + part * (outside.normal_C - inside.normal_C);
  return vertex;
}

// The part of a triangle beyond the near plane: a convex polygon with `count` corners.
struct Polygon {
  std::array<CameraVertex, 4> corners;
  std::size_t count = 0;

  void add(const CameraVertex& vertex) { corners[count++] = vertex; }
};

// Clipping comes before projection, because 1 / depth has no meaning for what is behind the eye.
// Only the near plane needs it: the rasterisers skip what lies outside the picture.
Polygon beyond_near_plane(const std::array<CameraVertex, 3>& triangle, double near_depth) {
  Polygon polygon;
  for (std::size_t k = 0; k < 3; ++k) {
    const CameraVertex& here = triangle[k];
    const CameraVertex& next = triangle[(k + 1) % 3];
    const bool here_inside = here.p_C.z() >= near_depth;
    const bool next_inside = next.p_C.z() >= near_depth;
    if (here_inside) polygon.add(here);
    if (here_inside && !next_inside) polygon.add(cut(here, next, near_depth));
    if (!here_inside && next_inside) polygon.add(cut(next, here, near_depth));
  }
  return polygon;
}

double doubled_area(const std::array<Eigen::Vector2d, 3>& corners) {
  const Eigen::Vector2d a = corners[1] - corners[0];
  const Eigen::Vector2d b = corners[2] - corners[0];
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

void append_triangle(const std::array<CameraVertex, 3>& triangle, const SurfaceLook& look,
                     const Projection& projection, std::vector<ScreenTriangle>& out) {
  const Polygon polygon = beyond_near_plane(triangle, projection.near_depth());
  // The polygon as a fan of triangles. Which side of the surface is seen follows from the sense of
  // rotation on the screen. Front faces have their corners exchanged, back faces their normals
  // reversed, so that all screen triangles have the same sense and normals towards the viewer.
  for (std::size_t k = 2; k < polygon.count; ++k) {
    std::array<CameraVertex, 3> part = {polygon.corners[0], polygon.corners[k - 1],
                                        polygon.corners[k]};
    ScreenTriangle flat;
    for (std::size_t i = 0; i < 3; ++i) flat.corners[i] = projection.pixel(part[i].p_C);
    const double area = doubled_area(flat.corners);
    if (!std::isfinite(area) || area == 0.0) continue;
    const bool front = area < 0.0;  // counter-clockwise to the eye, though y points down
    if (front) {
      std::swap(flat.corners[1], flat.corners[2]);
      std::swap(part[1], part[2]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      flat.inverse_depths[i] = 1.0 / part[i].p_C.z();
      flat.normals[i] = front ? part[i].normal_C : Vector3(-part[i].normal_C);
    }
    flat.albedo = look.albedo;
    flat.opacity = front ? look.front_opacity : look.back_opacity;
    out.push_back(flat);
  }
}

void append_line(const Vector3& from_C, const Vector3& to_C, const LineLook& look,
                 const Projection& projection, std::vector<ScreenTriangle>& out) {
  // A line lies in the surfaces that it belongs to. It is drawn 0.05 % nearer, so that the depth
  // test does not hide it there.
  constexpr double kNearer = 1.0 + 5e-4;
  const double near_depth = projection.near_depth();
  CameraVertex from{from_C, Vector3::Zero()};
  CameraVertex to{to_C, Vector3::Zero()};
  if (from.p_C.z() < near_depth && to.p_C.z() < near_depth) return;
  if (from.p_C.z() < near_depth) from = cut(to, from, near_depth);
  if (to.p_C.z() < near_depth) to = cut(from, to, near_depth);

  const Eigen::Vector2d a = projection.pixel(from.p_C);
  const Eigen::Vector2d b = projection.pixel(to.p_C);
  const double length = (b - a).norm();
  if (!std::isfinite(length) || !(length > 0.0)) return;
  const Eigen::Vector2d along = (b - a) / length;
  const Eigen::Vector2d aside = 0.5 * look.width * Eigen::Vector2d(-along.y(), along.x());
  const double at_a = kNearer / from.p_C.z();
  const double at_b = kNearer / to.p_C.z();
  // The strip is two triangles in the picture plane, so its width in pixels is the same at both
  // ends. It is not lit, so its normals are not used.
  ScreenTriangle half;
  half.albedo = look.color;
  half.opacity = look.opacity;
  half.lit = false;
  half.normals.fill(-Vector3::UnitZ());
  half.corners = {a - aside, b - aside, b + aside};
  half.inverse_depths = {at_a, at_b, at_b};
  out.push_back(half);
  half.corners = {a - aside, b + aside, a + aside};
  half.inverse_depths = {at_a, at_b, at_a};
  out.push_back(half);
}

}  // namespace prehend
