#include "sim/shape/convex_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "sim/base/disjoint_sets.h"
#include "sim/base/index.h"
#include "sim/shape/convex_hull.h"
#include "sim/shape/nearest_point.h"
#include "sim/shape/sphere_directions.h"

namespace prehend {
namespace {

// A surface with more connected components than this gets a single hull: testing every pair of
// parts would cost more than the tighter bounds save.
constexpr std::size_t kMostParts = 4;
// Up to this many points no hull is computed: the support function goes through all points anyway,
// and is fast enough for these.
constexpr std::size_t kFewPoints = 64;
// The support function goes through all corners. Beyond this many (a round scan can have 50,000) a
// coarser set answers so much faster that the exact queries which its margin costs do not matter.
constexpr std::size_t kManyCorners = 512;
constexpr int kCoarseCorners = 256;

std::vector<Vector3> used_vertices(const TriangleMesh& mesh) {
  std::vector<bool> used(mesh.vertices.size(), false);
  std::vector<Vector3> vertices;
  for (const Triangle& t : mesh.triangles) {
    for (int v : t) {
      if (!used[index(v)]) vertices.push_back(mesh.vertices[index(v)]);
      used[index(v)] = true;
    }
  }
  return vertices;
}

// The corners of the convex hull of `points`; all of them where there are few or the hull fails.
ConvexPoints hull_around(const std::vector<Vector3>& points) {
  if (points.size() <= kFewPoints) return ConvexPoints(points);
  const TriangleMesh hull = convex_hull(points);
  if (hull.empty()) return ConvexPoints(points);
  std::vector<Vector3> corners = used_vertices(hull);
  if (corners.size() <= kManyCorners) return ConvexPoints(std::move(corners));
  return coarse_hull(hull, kCoarseCorners);
}

// An upper bound of the distance of p from a convex solid, given by its faces: the distance from
// the face above whose plane p is highest; 0 where p is above none.
double height_above(const TriangleMesh& solid, const std::vector<Vector3>& normals,
                    const Vector3& p) {
  std::size_t highest = 0;
  double height = -std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < normals.size(); ++t) {
    const double above = normals[t].dot(p - solid.vertices[index(solid.triangles[t][0])]);
    if (above > height) {
      height = above;
      highest = t;
    }
  }
  if (height <= 0.0) return 0.0;
  const Triangle& face = solid.triangles[highest];
  return (nearest_point_on({solid.vertices[index(face[0])], solid.vertices[index(face[1])],
                            solid.vertices[index(face[2])]},
                           p) -
          p)
      .norm();
}

}  // namespace

std::vector<ConvexPoints> convex_parts(const TriangleMesh& mesh) {
  DisjointSets sets(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles) {
    sets.merge(index(t[0]), index(t[1]));
    sets.merge(index(t[0]), index(t[2]));
  }
  std::map<std::size_t, std::vector<Vector3>> components;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    components[sets.find(v)].push_back(mesh.vertices[v]);
  }
  if (components.size() > kMostParts) return {hull_around(mesh.vertices)};
  std::vector<ConvexPoints> parts;
  for (const auto& [root, points] : components) parts.push_back(hull_around(points));
  return parts;
}

// The corners that lie farthest along evenly spread directions. The directions are those of the
// hull scaled to a cube, so that the corners of a long thin hull are spread along its length.
ConvexPoints coarse_hull(const TriangleMesh& hull, int most) {
  const std::vector<Vector3> corners = used_vertices(hull);
  const Vector3 size = bounds(hull).size();
  std::set<std::size_t> chosen;
  for (int i = 0; i < most; ++i) {
    const Vector3 direction = sphere_direction(i, most).cwiseQuotient(size);
    const auto farthest = std::max_element(
        corners.begin(), corners.end(),
        [&](const Vector3& p, const Vector3& q) { return p.dot(direction) < q.dot(direction); });
    chosen.insert(static_cast<std::size_t>(farthest - corners.begin()));
  }
  std::vector<Vector3> kept;
  for (const std::size_t c : chosen) kept.push_back(corners[c]);
  const TriangleMesh inner = convex_hull(kept);
  if (inner.empty()) return ConvexPoints(corners);
  std::vector<Vector3> normals;
  for (std::size_t t = 0; t < inner.triangles.size(); ++t) {
    normals.push_back(doubled_area_vector(inner, t).normalized());
  }
  double margin = 0.0;
  for (const Vector3& p : corners) margin = std::max(margin, height_above(inner, normals, p));
  return ConvexPoints(std::move(kept), margin);
}

}  // namespace prehend
