#include "sim/shape/convex_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "sim/base/input_error.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/mass_properties.h"

namespace prehend {
namespace {

ConvexRegion region_of(const Box& box) {
  ConvexRegion region;
  for (int k = 0; k < 3; ++k) {
    region.push_back({Vector3::Unit(k), 0.5 * box.size[k]});
    region.push_back({-Vector3::Unit(k), 0.5 * box.size[k]});
  }
  return region;
}

ConvexRegion region_of(const Cylinder& cylinder) {
  constexpr int kSides = 32;
  ConvexRegion region = {{Vector3::UnitZ(), 0.5 * cylinder.height},
                         {-Vector3::UnitZ(), 0.5 * cylinder.height}};
  // A regular polygon around a circle of radius a has the area n a^2 tan(pi / n).
  constexpr double kStep = std::numbers::pi / kSides;
  const double inner = cylinder.radius * std::sqrt(kStep / std::tan(kStep));
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2.0 * i * kStep;
    region.push_back({{std::cos(angle), std::sin(angle), 0.0}, inner});
  }
  return region;
}

ConvexRegion region_of(const Sphere& sphere) {
  TriangleMesh ball = make_sphere(1.0, 1);
  const double volume = 4.0 / 3.0 * std::numbers::pi;
  const double growth = std::cbrt(volume / mass_properties(ball).volume);
  ConvexRegion region;
  for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
    const Vector3 normal = doubled_area_vector(ball, t).normalized();
    const Vector3& corner = ball.vertices[static_cast<std::size_t>(ball.triangles[t][0])];
    region.push_back({normal, growth * sphere.radius * normal.dot(corner)});
  }
  return region;
}

// The faces of a convex polyhedron, each a polygon. The order of their corners goes around.
using Faces = std::vector<std::vector<Vector3>>;

Faces faces_of(const Bounds& box) {
  Faces faces;
  for (int k = 0; k < 3; ++k) {
    for (const Vector3* side : {&box.lower, &box.upper}) {
      const int u = (k + 1) % 3;
      const int v = (k + 2) % 3;
      std::vector<Vector3> face(4, *side);
      face[0][u] = face[3][u] = box.lower[u];
      face[1][u] = face[2][u] = box.upper[u];
      face[0][v] = face[1][v] = box.lower[v];
      face[2][v] = face[3][v] = box.upper[v];
      faces.push_back(std::move(face));
    }
  }
  return faces;
}

// The part of the polygon in the half-space; where its sides cross the plane is added to `cuts`.
std::vector<Vector3> cut_face(const std::vector<Vector3>& face, const HalfSpace& half,
                              std::vector<Vector3>& cuts) {
  std::vector<Vector3> kept;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Vector3& a = face[i];
    const Vector3& b = face[(i + 1) % face.size()];
    const double at_a = half.normal.dot(a) - half.offset;
    const double at_b = half.normal.dot(b) - half.offset;
    if (at_a <= 0.0) kept.push_back(a);
    if ((at_a <= 0.0) == (at_b <= 0.0)) continue;
    kept.push_back(a + at_a / (at_a - at_b) * (b - a));
    cuts.push_back(kept.back());
  }
  return kept;
}

Vector3 mean_of(const std::vector<Vector3>& points) {
  Vector3 sum = Vector3::Zero();
  for (const Vector3& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

// The face that the plane cuts: its corners in the order of their directions from their mean.
std::vector<Vector3> cap_of(std::vector<Vector3> cuts, const Vector3& normal) {
  const Vector3 middle = mean_of(cuts);
  const Vector3 u = any_orthogonal(normal);
  const Vector3 v = normal.cross(u);
  const auto angle = [&](const Vector3& p) {
    return std::atan2(v.dot(p - middle), u.dot(p - middle));
  };
  std::stable_sort(cuts.begin(), cuts.end(),
                   [&](const Vector3& a, const Vector3& b) { return angle(a) < angle(b); });
  return cuts;
}

Faces cut_faces(const Faces& faces, const HalfSpace& half) {
  Faces kept;
  std::vector<Vector3> cuts;
  for (const std::vector<Vector3>& face : faces) {
    std::vector<Vector3> rest = cut_face(face, half, cuts);
    if (rest.size() >= 3) kept.push_back(std::move(rest));
  }
  if (!kept.empty() && cuts.size() >= 3) kept.push_back(cap_of(std::move(cuts), half.normal));
  return kept;
}

}  // namespace

ConvexRegion region_of(const Primitive& primitive) {
  ConvexRegion region;
  if (const Box* box = std::get_if<Box>(&primitive.shape)) {
    region = region_of(*box);
  } else if (const Cylinder* cylinder = std::get_if<Cylinder>(&primitive.shape)) {
    region = region_of(*cylinder);
  } else if (const Sphere* sphere = std::get_if<Sphere>(&primitive.shape)) {
    region = region_of(*sphere);
  } else {
    throw InputError({.field = "shape",
                      .problem = "must be box, cylinder or sphere",
                      .value = std::string(shape_name(primitive.shape))});
  }
  for (HalfSpace& half : region) {
    half.normal = primitive.X_OP.linear() * half.normal;
    half.offset += half.normal.dot(primitive.X_OP.translation());
  }
  return region;
}

std::optional<Vector3> inner_point(const ConvexRegion& region, const Bounds& box) {
  constexpr double kThinnest = 1e-12;
  Faces faces = faces_of(box);
  for (const HalfSpace& half : region) faces = cut_faces(faces, half);
  std::vector<Vector3> corners;
  for (const std::vector<Vector3>& face : faces) {
    corners.insert(corners.end(), face.begin(), face.end());
  }
  if (corners.empty()) return std::nullopt;
  const Vector3 middle = mean_of(corners);
  for (const HalfSpace& half : region) {
    if (half.offset - half.normal.dot(middle) < kThinnest * box.diagonal()) return std::nullopt;
  }
  return middle;
}

}  // namespace prehend
