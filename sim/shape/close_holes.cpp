// Holes are judged first, all together: whether a large hole may be closed depends on the other
// large ones. Flat ones are then triangulated in their mean planes, small bent ones by triangles of
// the least area.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "sim/shape/hole_loops.h"
#include "sim/shape/least_patch.h"
#include "sim/shape/polygon.h"
#include "sim/shape/repair_steps.h"
#include "sim/shape/shells.h"
#include "sim/shape/weld.h"

namespace prehend {
namespace {

// A hole is flat when no vertex of its rim is farther from the mean plane than this part of the
// hole's own diagonal.
constexpr double kFlatness = 0.02;
// It is small with at most this part of the shell's area and of its diagonal.
constexpr double kSmallArea = 0.01;
constexpr double kSmallSize = 0.25;
// A rim of more edges is left open.
constexpr std::size_t kMostEdges = 3000;

// A hole, measured: its mean plane (Newell's normal) and what the options limit.
struct MeasuredHole {
  HoleLoop loop;
  Vector3 normal = Vector3::Zero();  // unit; zero without an area
  double area = 0.0;                 // m^2
  double deviation = 0.0;            // of the rim from the mean plane [m]
  Bounds box;
  int shell = 0;
  bool large = false;
};

MeasuredHole measured(const TriangleMesh& mesh, HoleLoop loop) {
  MeasuredHole hole;
  Vector3 sum = Vector3::Zero();
  const auto at = [&](std::size_t i) -> const Vector3& {
    return mesh.vertices[static_cast<std::size_t>(loop.vertices[i])];
  };
  const std::size_t n = loop.vertices.size();
  Vector3 doubled = Vector3::Zero();
  for (std::size_t i = 0; i < n; ++i) {
    sum += at(i);
    hole.box.lower = hole.box.lower.cwiseMin(at(i));
    hole.box.upper = hole.box.upper.cwiseMax(at(i));
    if (i > 0 && i + 1 < n) doubled += (at(i) - at(0)).cross(at(i + 1) - at(0));
  }
  hole.area = 0.5 * doubled.norm();
  if (hole.area > 0.0) hole.normal = doubled / doubled.norm();
  const Vector3 mean = sum / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    hole.deviation = std::max(hole.deviation, std::abs((at(i) - mean).dot(hole.normal)));
  }
  hole.loop = std::move(loop);
  return hole;
}

class HoleCloser {
 public:
  HoleCloser(TriangleMesh& mesh, const RepairOptions& options, const RunContext& context)
      : mesh_(mesh), options_(options), context_(context), shells_(find_shells(mesh)) {}

  ClosedHoles run() {
    std::vector<MeasuredHole> holes;
    for (HoleLoop& loop : hole_loops(mesh_)) {
      MeasuredHole hole = measured(mesh_, std::move(loop));
      hole.shell = shells_.of_triangle[static_cast<std::size_t>(hole.loop.triangle)];
      hole.large = !small(hole);
      holes.push_back(std::move(hole));
    }
    ClosedHoles result;
    if (holes.empty()) return result;
    remember_edges(holes);
    std::vector<const MeasuredHole*> large;
    for (const MeasuredHole& hole : holes) {
      if (hole.large) large.push_back(&hole);
    }
    for (const MeasuredHole& hole : holes) {
      context_.cancellation.check();
      const bool closed = fits(hole) && (!hole.large || stands_alone(hole, large)) && patch(hole);
      ++(closed ? result.closed : result.left);
      if (closed) result.area += hole.area;
    }
    return result;
  }

 private:
  const Shell& shell_of(const MeasuredHole& hole) const {
    return shells_.shells[static_cast<std::size_t>(hole.shell)];
  }

  bool small(const MeasuredHole& hole) const {
    return hole.area <= kSmallArea * shell_of(hole).area &&
           hole.box.diagonal() <= kSmallSize * shells_.largest_diagonal;
  }

  bool flat(const MeasuredHole& hole) const {
    return hole.area > 0.0 && hole.deviation <= kFlatness * hole.box.diagonal();
  }

  bool fits(const MeasuredHole& hole) const {
    return hole.area <= options_.hole_area * shell_of(hole).area &&
           hole.loop.vertices.size() <= kMostEdges && (flat(hole) || !hole.large);
  }

  static bool encloses(const Bounds& outer, const Bounds& inner) {
    if (inner.diagonal() < 0.5 * outer.diagonal()) return false;
    // A rim of a thin wall may reach as far as the outer one along the wall's own plane.
    const Vector3 slack = Vector3::Constant(0.05 * outer.diagonal());
    return ((outer.lower - slack).array() <= inner.lower.array()).all() &&
           ((outer.upper + slack).array() >= inner.upper.array()).all();
  }

  // Neither a second large hole in the same shell nor one around or inside it.
  static bool stands_alone(const MeasuredHole& hole,
                           const std::vector<const MeasuredHole*>& large) {
    return std::all_of(large.begin(), large.end(), [&](const MeasuredHole* other) {
      if (other == &hole) return true;
      return other->shell != hole.shell && !encloses(other->box, hole.box) &&
             !encloses(hole.box, other->box);
    });
  }

  // The edges between vertices of rims: only these could be used again by a patch.
  void remember_edges(const std::vector<MeasuredHole>& holes) {
    std::vector<bool> on_rim(mesh_.vertices.size(), false);
    for (const MeasuredHole& hole : holes) {
      for (const int v : hole.loop.vertices) on_rim[static_cast<std::size_t>(v)] = true;
    }
    for (const Triangle& t : mesh_.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax({t[k], t[(k + 1) % 3]});
        if (on_rim[static_cast<std::size_t>(low)] && on_rim[static_cast<std::size_t>(high)]) {
          edges_.emplace_back(low, high);
        }
      }
    }
    std::sort(edges_.begin(), edges_.end());
  }

  bool is_used(const std::pair<int, int>& edge) const {
    return std::binary_search(edges_.begin(), edges_.end(), edge) || patched_.contains(edge);
  }

  // Corners of a patch, as indices into the rim; none where it has no triangulation in its plane.
  std::vector<Triangle> flat_patch(const MeasuredHole& hole) const {
    const Vector3 u = any_orthogonal(hole.normal);
    const Vector3 v = hole.normal.cross(u);
    const Vector3& origin = mesh_.vertices[static_cast<std::size_t>(hole.loop.vertices[0])];
    std::vector<Eigen::Vector2d> projected;
    for (const int vertex : hole.loop.vertices) {
      const Vector3 p = mesh_.vertices[static_cast<std::size_t>(vertex)] - origin;
      projected.emplace_back(p.dot(u), p.dot(v));
    }
    return triangulate_polygon(projected);
  }

  bool patch(const MeasuredHole& hole) {
    const std::vector<int>& rim = hole.loop.vertices;
    if (flat(hole) && add(rim, flat_patch(hole))) return true;
    return !hole.large && add(rim, least_patch(mesh_, rim, [&](int a, int b) {
                                return !is_used(std::minmax({a, b}));
                              }));
  }

  // Adds the triangles of a patch unless there are none, one has no area, or an edge inside the
  // patch is used already.
  bool add(const std::vector<int>& rim, const std::vector<Triangle>& corners) {
    if (corners.empty()) return false;
    const std::size_t before = mesh_.triangles.size();
    std::vector<std::pair<int, int>> inside;
    bool sound = true;
    const int n = static_cast<int>(rim.size());
    for (const Triangle& t : corners) {
      const auto named = [&](std::size_t k) { return rim[static_cast<std::size_t>(t[k])]; };
      mesh_.triangles.push_back({named(0), named(1), named(2)});
      sound = sound && !is_degenerate(mesh_, mesh_.triangles.size() - 1);
      for (std::size_t k = 0; k < 3; ++k) {
        if ((t[k] + 1) % n == t[(k + 1) % 3]) continue;
        inside.emplace_back(std::minmax({named(k), named((k + 1) % 3)}));
      }
    }
    sound = sound && std::none_of(inside.begin(), inside.end(),
                                  [&](const std::pair<int, int>& edge) { return is_used(edge); });
    if (!sound) mesh_.triangles.resize(before);
    if (sound) patched_.insert(inside.begin(), inside.end());
    return sound;
  }

  TriangleMesh& mesh_;
  const RepairOptions& options_;
  const RunContext& context_;
  Shells shells_;
  std::vector<std::pair<int, int>> edges_;  // between vertices of rims, sorted
  std::set<std::pair<int, int>> patched_;   // inside patches
};

}  // namespace

ClosedHoles close_holes(TriangleMesh& mesh, const RepairOptions& options,
                        const RunContext& context) {
  return HoleCloser(mesh, options, context).run();
}

}  // namespace prehend
