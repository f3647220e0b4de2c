#include "planner/show/picture/marks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace prehend {
namespace {

// A point of a profile: `along` the axis, at distance `radius` from it.
struct ProfilePoint {
  double along = 0.0;
  double radius = 0.0;
};

// The solid that `profile` sweeps about the axis through `origin`, with a polygon of so many sides
// for a circle. The profile starts and ends on
// the axis (radius 0) and nowhere else touches it; it is walked so that the solid is on its left,
// seen with the axis to the right and the radius up, hence from the far end back to the origin.
TriangleMesh revolved(const std::vector<ProfilePoint>& profile, const Vector3& origin,
                      const Vector3& axis, int sides) {
  const Vector3 u = any_orthogonal(axis);
  const Vector3 v = axis.cross(u);
  TriangleMesh mesh;
  mesh.vertices.push_back(origin + profile.front().along * axis);
  for (std::size_t ring = 1; ring + 1 < profile.size(); ++ring) {
    for (int i = 0; i < sides; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / sides;
      const Vector3 around = std::cos(angle) * u + std::sin(angle) * v;
      mesh.vertices.push_back(origin + profile[ring].along * axis + profile[ring].radius * around);
    }
  }
  mesh.vertices.push_back(origin + profile.back().along * axis);

  // Triangles are counter-clockwise from outside: a fan around the first pole, two triangles for
  // each side between neighbouring rings, and a fan around the last pole.
  const int rings = static_cast<int>(profile.size()) - 2;
  const int last = static_cast<int>(mesh.vertices.size()) - 1;
  for (int i = 0; i < sides; ++i) {
    const int j = (i + 1) % sides;
    mesh.triangles.push_back({0, 1 + i, 1 + j});
    for (int ring = 0; ring + 1 < rings; ++ring) {
      const int here = 1 + ring * sides;
      const int next = here + sides;
      mesh.triangles.push_back({here + i, next + i, next + j});
      mesh.triangles.push_back({here + i, next + j, here + j});
    }
    mesh.triangles.push_back({last, last - sides + j, last - sides + i});
  }
  return mesh;
}

}  // namespace

// The profile of an arrow: tip, rim of the head, end of the shaft in the head, other end of the
// shaft, centre of that end.
TriangleMesh arrow_mesh(const Vector3& from, const Vector3& to, double radius) {
  constexpr double kHeadRadius = 2.4;  // in shaft radii
  constexpr double kHeadLength = 6.0;
  const double length = (to - from).norm();
  if (!(length > 0.0) || !(radius > 0.0)) return {};
  const double neck = length - std::min(kHeadLength * radius, 0.5 * length);
  return revolved(
      {{length, 0.0}, {neck, kHeadRadius * radius}, {neck, radius}, {0.0, radius}, {0.0, 0.0}},
      from, (to - from) / length, kRoundSides);
}

// The profile of a cone: the centre of its base, the rim, the apex.
TriangleMesh cone_mesh(const Vector3& apex, const Vector3& axis, double slope, double length,
                       int sides) {
  const double norm = axis.norm();
  if (!(norm > 0.0) || !(slope > 0.0) || !(length > 0.0)) return {};
  return revolved({{length, 0.0}, {length, slope * length}, {0.0, 0.0}}, apex, axis / norm, sides);
}

}  // namespace prehend
