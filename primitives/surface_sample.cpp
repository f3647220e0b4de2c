#include "primitives/surface_sample.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "sim/base/random.h"

namespace prehend {
namespace {

// Uniform in the triangle for uniform u, v in [0, 1): the half of the unit square beyond its
// diagonal is folded back onto the triangle.
Vector3 point_in_triangle(const TriangleMesh& mesh, std::size_t t, double u, double v) {
  if (u + v > 1.0) {
    u = 1.0 - u;
    v = 1.0 - v;
  }
  const Triangle& corner = mesh.triangles[t];
  const Vector3& a = mesh.vertices[static_cast<std::size_t>(corner[0])];
  const Vector3& b = mesh.vertices[static_cast<std::size_t>(corner[1])];
  const Vector3& c = mesh.vertices[static_cast<std::size_t>(corner[2])];
  return a + u * (b - a) + v * (c - a);
}

// -1 when the mesh as a whole is inside out. The flux of p - center through a closed surface is
// three times the volume inside (divergence theorem); its sign survives holes that are not too
// large.
double outward_sign(const std::vector<SurfacePoint>& points, const Vector3& center) {
  double flux = 0.0;
  for (const SurfacePoint& s : points) flux += s.n_O.dot(s.p_O - center);
  return flux < 0.0 ? -1.0 : 1.0;
}

}  // namespace

std::vector<SurfacePoint> sample_surface(const TriangleMesh& mesh, int count, std::uint64_t seed) {
  std::vector<double> area_until(mesh.triangles.size());
  double area = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    area += doubled_area_vector(mesh, t).norm();
    area_until[t] = area;
  }
  if (!(area > 0.0)) return {};

  // One point in each of `count` equal stretches of the running area: less variance than
  // independent draws, and every part gets its fair number of points.
  Random random(seed);
  std::vector<SurfacePoint> points;
  points.reserve(static_cast<std::size_t>(count));
  std::size_t t = 0;
  for (int i = 0; i < count; ++i) {
    const double at = area * (i + random.uniform()) / count;
    while (t + 1 < area_until.size() && area_until[t] <= at) ++t;
    const double u = random.uniform();
    const double v = random.uniform();
    points.push_back({point_in_triangle(mesh, t, u, v), doubled_area_vector(mesh, t).normalized(),
                      static_cast<int>(t)});
  }
  const double sign = outward_sign(points, bounds(mesh).center());
  for (SurfacePoint& s : points) s.n_O *= sign;
  return points;
}

}  // namespace prehend
