#include "sim/shape/surface_part.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <tuple>

#include "sim/base/disjoint_sets.h"
#include "sim/base/index.h"

namespace prehend {
namespace {

using Polygon3 = std::span<const Vector3>;

Polygon3 polygon(const SurfacePart& part, std::size_t k) {
  const std::size_t first = k == 0 ? 0 : part.ends[k - 1];
  return {part.corners.data() + first, part.ends[k] - first};
}

void add_polygon(SurfacePart& part, Polygon3 corners) {
  part.corners.insert(part.corners.end(), corners.begin(), corners.end());
  part.ends.push_back(part.corners.size());
}

std::tuple<double, double, double> key_of(const Vector3& p) { return {p.x(), p.y(), p.z()}; }

// Where the plane cuts the edge between p and q, which lie on different sides: the same to the bit
// for both directions of the edge.
Vector3 crossing(Vector3 p, Vector3 q, const CutPlane& plane) {
  if (key_of(q) < key_of(p)) std::swap(p, q);
  const double from = plane.height(p);
  const double to = plane.height(q);
  return p + (q - p) * (from / (from - to));
}

// Points closer to the plane than this are on it: cuts along a wall do not take slivers of it [m].
constexpr double kOnPlane = 1e-9;

double snapped_height(const CutPlane& plane, const Vector3& p) {
  const double height = plane.height(p);
  return std::abs(height) <= kOnPlane ? 0.0 : height;
}

// Whether a polygon in the plane faces the side above it, so that the solid is below. Its first
// three corners may be in a line.
bool faces_up(Polygon3 corners, const CutPlane& plane) {
  Vector3 area = Vector3::Zero();
  for (std::size_t k = 2; k < corners.size(); ++k) {
    area += (corners[k - 1] - corners[0]).cross(corners[k] - corners[0]);
  }
  return area.dot(plane.normal) >= 0.0;
}

// Calls add(side, point) for the corners of the polygon's parts below (0) and above (1) the plane,
// in their order. A polygon in the plane belongs to the side of the solid behind it.
template <typename Add>
void divide(Polygon3 corners, const CutPlane& plane, const Add& add) {
  // Only touching the plane from one side is not to be on the other.
  std::array<bool, 2> reaches = {false, false};
  for (const Vector3& p : corners) {
    const double height = snapped_height(plane, p);
    if (height != 0.0) reaches[height < 0.0 ? 0 : 1] = true;
  }
  if (!reaches[0] && !reaches[1]) {
    const std::size_t side = faces_up(corners, plane) ? 0 : 1;
    for (const Vector3& p : corners) add(side, p);
    return;
  }
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vector3& p = corners[k];
    const Vector3& q = corners[(k + 1) % corners.size()];
    const double here = snapped_height(plane, p);
    const double next = snapped_height(plane, q);
    if (here <= 0.0 && reaches[0]) add(std::size_t{0}, p);
    if (here >= 0.0 && reaches[1]) add(std::size_t{1}, p);
    if ((here < 0.0 && next > 0.0) || (here > 0.0 && next < 0.0)) {
      const Vector3 on = crossing(p, q, plane);
      add(std::size_t{0}, on);
      add(std::size_t{1}, on);
    }
  }
}

bool overlap(const Bounds& a, const Bounds& b) {
  return (a.lower.array() <= b.upper.array()).all() && (b.lower.array() <= a.upper.array()).all();
}

void include(Bounds& box, const Bounds& other) {
  box.lower = box.lower.cwiseMin(other.lower);
  box.upper = box.upper.cwiseMax(other.upper);
}

// Of each polygon the set of those that share corners with it, by its first polygon.
std::vector<std::size_t> connected(const SurfacePart& part) {
  DisjointSets sets(part.ends.size());
  std::map<std::tuple<double, double, double>, std::size_t> first_at;
  for (std::size_t k = 0; k < part.ends.size(); ++k) {
    for (const Vector3& p : polygon(part, k)) {
      sets.merge(k, first_at.emplace(key_of(p), k).first->second);
    }
  }
  std::vector<std::size_t> of(part.ends.size());
  std::map<std::size_t, std::size_t> first_of;
  for (std::size_t k = 0; k < of.size(); ++k)
    of[k] = first_of.emplace(sets.find(k), k).first->second;
  return of;
}

}  // namespace

SurfacePart surface_part(const TriangleMesh& mesh) {
  SurfacePart part;
  for (const Triangle& t : mesh.triangles) {
    for (const int v : t) part.corners.push_back(mesh.vertices[index(v)]);
    part.ends.push_back(part.corners.size());
  }
  return part;
}

std::array<SurfacePart, 2> cut(const SurfacePart& part, const CutPlane& plane) {
  std::array<SurfacePart, 2> sides;
  std::array<std::vector<Vector3>, 2> pieces;
  for (std::size_t k = 0; k < part.ends.size(); ++k) {
    for (auto& piece : pieces) piece.clear();
    divide(polygon(part, k), plane,
           [&](std::size_t side, const Vector3& p) { pieces[side].push_back(p); });
    for (std::size_t side = 0; side < 2; ++side) {
      if (pieces[side].size() >= 3) add_polygon(sides[side], pieces[side]);
    }
  }
  return sides;
}

std::array<std::vector<Vector3>, 2> cut_points(const SurfacePart& part, const CutPlane& plane,
                                               std::size_t most) {
  std::array<std::vector<Vector3>, 2> points;
  const std::size_t step = 1 + part.ends.size() / std::max<std::size_t>(most, 1);
  for (std::size_t k = 0; k < part.ends.size(); k += step) {
    divide(polygon(part, k), plane,
           [&](std::size_t side, const Vector3& p) { points[side].push_back(p); });
  }
  return points;
}

std::vector<SurfacePart> separate_parts(const SurfacePart& part) {
  const std::vector<std::size_t> set_of = connected(part);
  std::map<std::size_t, Bounds> boxes;
  for (std::size_t k = 0; k < set_of.size(); ++k) {
    Bounds box;
    for (const Vector3& p : polygon(part, k)) include(box, {p, p});
    include(boxes[set_of[k]], box);
  }
  // Boxes that overlap are joined, until none do.
  std::map<std::size_t, std::size_t> into;
  for (const auto& [set, box] : boxes) into[set] = set;
  for (bool changed = true; changed;) {
    changed = false;
    for (auto a = boxes.begin(); a != boxes.end(); ++a) {
      for (auto b = std::next(a); b != boxes.end();) {
        if (!overlap(a->second, b->second)) {
          ++b;
          continue;
        }
        include(a->second, b->second);
        for (auto& [set, joined] : into) joined = joined == b->first ? a->first : joined;
        b = boxes.erase(b);
        changed = true;
      }
    }
  }
  std::map<std::size_t, std::size_t> place;
  for (const auto& [set, box] : boxes) place.emplace(set, place.size());
  std::vector<SurfacePart> parts(place.size());
  for (std::size_t k = 0; k < set_of.size(); ++k) {
    add_polygon(parts[place.at(into.at(set_of[k]))], polygon(part, k));
  }
  return parts;
}

}  // namespace prehend
