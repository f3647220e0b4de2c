#include "primitives/inscribed.h"

#include <algorithm>
#include <cmath>

#include "primitives/fit.h"

// Sampled points lie on the facets of the mesh, which are chords of the surface that it
// approximates: a radius fitted to them is too small. The vertices are on the surface itself. The
// radius is therefore measured again at the vertices of the triangles that the points come from.
namespace prehend {
namespace {

// Distances of the vertices behind the points from the sphere's centre.
std::vector<double> vertex_radii(const Sphere&, const Pose& X_OP,
                                 std::span<const SurfacePoint> points, const TriangleMesh& mesh) {
  std::vector<double> radii;
  for (const SurfacePoint& s : points) {
    for (const int v : mesh.triangles[static_cast<std::size_t>(s.triangle)]) {
      radii.push_back((mesh.vertices[static_cast<std::size_t>(v)] - X_OP.translation()).norm());
    }
  }
  return radii;
}

// The same from a cylinder's axis, for the points of its side. Points nearer to a cap are left out:
// the vertices of a cap may be at any distance from the axis.
std::vector<double> vertex_radii(const Cylinder& cylinder, const Pose& X_OP,
                                 std::span<const SurfacePoint> points, const TriangleMesh& mesh) {
  const Pose X_PO = X_OP.inverse();
  const auto rho = [](const Vector3& p) { return std::hypot(p.x(), p.y()); };
  std::vector<double> radii;
  for (const SurfacePoint& s : points) {
    const Vector3 p = X_PO * s.p_O;
    const double to_side = std::abs(rho(p) - cylinder.radius);
    const double to_cap = std::abs(0.5 * cylinder.height - std::abs(p.z()));
    if (to_side > to_cap) continue;
    for (const int v : mesh.triangles[static_cast<std::size_t>(s.triangle)]) {
      radii.push_back(rho(X_PO * mesh.vertices[static_cast<std::size_t>(v)]));
    }
  }
  return radii;
}

// The mean of the vertices' radii, weighted by the biweight around `radius` so that vertices of
// other parts of the mesh do not count; `radius` itself when too few vertices are near it.
double refined_radius(double radius, const std::vector<double>& radii) {
  constexpr double kNear = 0.05;  // more than the sagitta of a 12-sided polygon
  double weight = 0.0;
  double sum = 0.0;
  for (const double r : radii) {
    const double w = biweight(r - radius, kNear * radius);
    weight += w;
    sum += w * r;
  }
  // Most of the vertices, or the region is not of this shape closely enough to tell.
  constexpr double kEnough = 0.5;
  return weight > kEnough * static_cast<double>(radii.size()) ? sum / weight : radius;
}

}  // namespace

Primitive on_vertices(const Primitive& primitive, std::span<const SurfacePoint> points,
                      const TriangleMesh& mesh) {
  Primitive result = primitive;
  if (auto* sphere = std::get_if<Sphere>(&result.shape)) {
    sphere->radius =
        refined_radius(sphere->radius, vertex_radii(*sphere, result.X_OP, points, mesh));
  }
  if (auto* cylinder = std::get_if<Cylinder>(&result.shape)) {
    cylinder->radius =
        refined_radius(cylinder->radius, vertex_radii(*cylinder, result.X_OP, points, mesh));
  }
  return result;
}

}  // namespace prehend
