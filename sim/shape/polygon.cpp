// Ear clipping. An ear is a convex corner whose triangle with its two neighbours contains no other
// part of the polygon; every simple polygon with more than three corners has two (Meisters 1975).
// Ears are cut off one by one until nothing is left. Of several ears the one with the best shape is
// taken, which avoids slivers where the polygon allows it.
#include "sim/shape/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace prehend {
namespace {

using Eigen::Vector2d;

// Twice the signed area of the triangle a b c.
double turn(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// The polygon that remains: corners not yet clipped, in order, and the quality of the ear at each
// of them (0: not an ear).
struct Remainder {
  const std::vector<Vector2d>& corners;
  std::vector<int> left;
  std::vector<double> quality;

  std::size_t before(std::size_t i) const { return (i + left.size() - 1) % left.size(); }
  std::size_t after(std::size_t i) const { return (i + 1) % left.size(); }
  const Vector2d& at(std::size_t i) const { return corners[static_cast<std::size_t>(left[i])]; }

  bool convex(std::size_t i) const { return turn(at(before(i)), at(i), at(after(i))) > 0.0; }

  // Height over longest side of the ear at corner i; 0 when the corner is no ear. Only reflex and
  // straight corners inside the ear are searched: if any part of the polygon is inside, such a
  // corner is. Corners at the position of one of the three vertices touch the ear without entering
  // it.
  double ear_quality(std::size_t i) const {
    const Vector2d& a = at(before(i));
    const Vector2d& b = at(i);
    const Vector2d& c = at(after(i));
    const double area = turn(a, b, c);
    if (!(area > 0.0)) return 0.0;
    for (std::size_t k = 0; k < left.size(); ++k) {
      const Vector2d& p = at(k);
      if (p == a || p == b || p == c) continue;
      const bool inside = turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
      if (inside && !convex(k)) return 0.0;
    }
    const double longest =
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return area / longest;
  }

  // Removes corner i. The qualities of its two neighbours change. No other corner can become an ear
  // or cease to be one.
  void clip(std::size_t i) {
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
    quality.erase(quality.begin() + static_cast<std::ptrdiff_t>(i));
    const std::size_t next = i % left.size();
    quality[before(next)] = ear_quality(before(next));
    quality[next] = ear_quality(next);
  }
};

}  // namespace

double doubled_area(const std::vector<Vector2d>& corners) {
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += turn(corners[0], corners[i], corners[i + 1]);
  }
  return sum;
}

std::vector<Triangle> triangulate_polygon(const std::vector<Vector2d>& corners) {
  if (corners.size() < 3 || !(doubled_area(corners) > 0.0)) return {};
  Remainder remainder{corners, std::vector<int>(corners.size()), {}};
  std::iota(remainder.left.begin(), remainder.left.end(), 0);
  for (std::size_t i = 0; i < corners.size(); ++i)
    remainder.quality.push_back(remainder.ear_quality(i));

  std::vector<Triangle> triangles;
  while (remainder.left.size() >= 3) {
    const auto best = std::max_element(remainder.quality.begin(), remainder.quality.end());
    if (!(*best > 0.0)) return {};
    const std::size_t i = static_cast<std::size_t>(best - remainder.quality.begin());
    triangles.push_back({remainder.left[remainder.before(i)], remainder.left[i],
                         remainder.left[remainder.after(i)]});
    remainder.clip(i);
  }
  return triangles;
}

std::vector<Triangle> triangulate_face(const std::vector<Vector3>& corners) {
  const int n = static_cast<int>(corners.size());
  if (n > 3) {
    // Newell's method: the sum of the normals of the fan about corner 0 does not depend on which
    // corner is chosen and is an average for a bent face.
    Vector3 normal = Vector3::Zero();
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      normal += (corners[k] - corners[0]).cross(corners[k + 1] - corners[0]);
    }
    const double length = normal.norm();
    if (length > 0.0 && std::isfinite(length)) {
      normal /= length;
      const Vector3 u = any_orthogonal(normal);
      const Vector3 v = normal.cross(u);
      std::vector<Vector2d> flat;
      for (const Vector3& p : corners) {
        flat.emplace_back((p - corners[0]).dot(u), (p - corners[0]).dot(v));
      }
      std::vector<Triangle> ears = triangulate_polygon(flat);
      if (!ears.empty()) return ears;
    }
  }
  // No triangulation in the plane: a fan keeps the border of the face, although it may fold.
  std::vector<Triangle> fan;
  for (int k = 1; k + 1 < n; ++k) fan.push_back({0, k, k + 1});
  return fan;
}

void add_triangles(TriangleMesh& mesh, std::span<const int> face) {
  std::vector<Vector3> corners;
  for (const int v : face) corners.push_back(mesh.vertices[static_cast<std::size_t>(v)]);
  const auto vertex = [&](int k) { return face[static_cast<std::size_t>(k)]; };
  for (const Triangle& t : triangulate_face(corners)) {
    mesh.triangles.push_back({vertex(t[0]), vertex(t[1]), vertex(t[2])});
  }
}

void add_strip(TriangleMesh& mesh, std::span<const int> strip) {
  for (std::size_t k = 0; k + 2 < strip.size(); ++k) {
    const std::size_t odd = k % 2;
    mesh.triangles.push_back({strip[k], strip[k + 1 + odd], strip[k + 2 - odd]});
  }
}

void add_fan(TriangleMesh& mesh, std::span<const int> fan) {
  for (std::size_t k = 1; k + 1 < fan.size(); ++k) {
    mesh.triangles.push_back({fan[0], fan[k], fan[k + 1]});
  }
}

}  // namespace prehend
