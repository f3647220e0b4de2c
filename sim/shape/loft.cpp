#include "sim/shape/loft.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/base/range.h"
#include "sim/shape/polygon.h"
#include "sim/shape/weld.h"

namespace prehend {
namespace {

// The cells between two rings of `count` vertices that start at vertices `low` and `high`, the
// second above the first.
void add_band(TriangleMesh& mesh, int low, int high, int count) {
  const auto length = [&](int a, int b) {
    return (mesh.vertices[static_cast<std::size_t>(a)] - mesh.vertices[static_cast<std::size_t>(b)])
        .squaredNorm();
  };
  for (int j = 0; j < count; ++j) {
    const int k = (j + 1) % count;
    // Equal diagonals, up to rounding, are split the same way.
    if (length(low + j, high + k) <= length(low + k, high + j) * (1.0 + 1e-9)) {
      mesh.triangles.push_back({low + j, low + k, high + k});
      mesh.triangles.push_back({low + j, high + k, high + j});
    } else {
      mesh.triangles.push_back({low + j, low + k, high + j});
      mesh.triangles.push_back({low + k, high + k, high + j});
    }
  }
}

std::vector<Triangle> cap_of(const LoftSection& section, std::size_t index) {
  const std::vector<Triangle> triangles = triangulate_polygon(section.corners);
  require(!triangles.empty(), {.field = "loft section " + std::to_string(index),
                               .problem = "must be simple, counter-clockwise and of positive area",
                               .value = std::to_string(section.corners.size()) + " corners"});
  return triangles;
}

void check_sections(const std::vector<LoftSection>& sections) {
  require(sections.size() >= 2, {.field = "loft sections",
                                 .problem = "must be at least two",
                                 .value = std::to_string(sections.size())});
  for (std::size_t s = 1; s < sections.size(); ++s) {
    require(sections[s].at > sections[s - 1].at,
            {.field = "loft section " + std::to_string(s),
             .problem = "must be higher than the one before it",
             .value = formatted("%g", sections[s].at)});
    require(sections[s].corners.size() == sections.front().corners.size(),
            {.field = "loft section " + std::to_string(s),
             .problem = "must have as many corners as the first one",
             .value = std::to_string(sections[s].corners.size()) + " corners"});
  }
}

// The orthonormal axes of a capsule, its axis last.
Matrix3 capsule_axes(const Vector3& along) {
  const double length = along.norm();
  Matrix3 axes = Matrix3::Identity();
  if (length > 0.0) axes = Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), along / length);
  return axes;
}

}  // namespace

TriangleMesh make_loft(const std::vector<LoftSection>& sections) {
  check_sections(sections);
  TriangleMesh mesh;
  const int count = static_cast<int>(sections.front().corners.size());
  for (std::size_t s = 0; s < sections.size(); ++s) {
    const std::vector<Triangle> cap = cap_of(sections[s], s);
    const int first = static_cast<int>(mesh.vertices.size());
    for (const Eigen::Vector2d& p : sections[s].corners) {
      mesh.vertices.push_back({p.x(), p.y(), sections[s].at});
    }
    if (s == 0) {
      for (const Triangle& t : cap) mesh.triangles.push_back({t[2], t[1], t[0]});
    } else {
      add_band(mesh, first - count, first, count);
    }
    if (s + 1 == sections.size()) {
      for (const Triangle& t : cap) {
        mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
      }
    }
  }
  return mesh;
}

TriangleMesh make_capsule(const Vector3& from, const Vector3& to, double radius, int sides) {
  require(radius > 0.0 && radius <= kFarthest, {.field = "capsule radius",
                                                .problem = "must be above 0 and at most 1e6 m",
                                                .value = formatted("%g", radius)});
  require(
      sides >= 4 && sides <= 360,
      {.field = "capsule sides", .problem = "must be 4 to 360", .value = std::to_string(sides)});
  const int bands = std::max(1, sides / 4);
  const Matrix3 axes = capsule_axes(to - from);
  // Latitudes of the rings from the lower pole to the upper one; a segment of positive length has
  // the equator twice.
  struct Parallel {
    double latitude;
    const Vector3& centre;
  };
  std::vector<Parallel> rings;
  const double step = 0.5 * std::numbers::pi / bands;
  for (int i = 1 - bands; i <= 0; ++i) rings.push_back({i * step, from});
  for (int i = from == to ? 1 : 0; i < bands; ++i) rings.push_back({i * step, to});
  TriangleMesh mesh;
  for (const Parallel& ring : rings) {
    for (int j = 0; j < sides; ++j) {
      const double angle = 2.0 * std::numbers::pi * j / sides;
      const Vector3 p(std::cos(ring.latitude) * std::cos(angle),
                      std::cos(ring.latitude) * std::sin(angle), std::sin(ring.latitude));
      mesh.vertices.push_back(ring.centre + radius * (axes * p));
    }
  }
  const int lower = static_cast<int>(mesh.vertices.size());
  const int last = lower - sides;
  mesh.vertices.push_back(from - radius * axes.col(2));
  mesh.vertices.push_back(to + radius * axes.col(2));
  for (int ring = 0; ring < last; ring += sides) add_band(mesh, ring, ring + sides, sides);
  for (int j = 0; j < sides; ++j) {
    const int k = (j + 1) % sides;
    mesh.triangles.push_back({lower, k, j});
    mesh.triangles.push_back({lower + 1, last + j, last + k});
  }
  return mesh;
}

}  // namespace prehend
