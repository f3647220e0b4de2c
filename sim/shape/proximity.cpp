// Queries on two bounding-volume hierarchies.
//
// All queries walk pairs of nodes, one of each tree (TreeWalk), and leave out pairs of boxes whose
// lower bound of the distance shows that no wanted pair of triangles is inside. They differ in what
// a visitor wants.
#include "sim/shape/proximity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/shape/box_tree.h"
#include "sim/shape/convex_parts.h"
#include "sim/shape/cover_shapes.h"
#include "sim/shape/smooth_surface.h"
#include "sim/shape/tree_walk.h"
#include "sim/shape/triangle_distance.h"
#include "sim/shape/winding_number.h"

namespace prehend {

struct ProximityMesh::Data {
  TriangleMesh mesh;
  std::vector<BoxNode> tree;
  WideTree wide;  // the same boxes, for walks over two meshes
  BoundaryTree boundaries;
  std::vector<PlacedTriangle> triangles;  // in the frame of the mesh
  std::vector<int> first_triangle_at;     // per vertex, start of its run in triangles_at
  std::vector<int> triangles_at;
  Vector3 ball_center = Vector3::Zero();
  double ball_radius = 0.0;
  std::vector<ConvexPoints> parts;
  mutable std::once_flag smooth_once;
  mutable SmoothSurface smooth;
  mutable std::once_flag cover_once;
  mutable ShapeCover cover;
};

namespace {

std::vector<PlacedTriangle> placed_triangles(const TriangleMesh& mesh) {
  std::vector<PlacedTriangle> placed;
  placed.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const std::array<Vector3, 3> corner{mesh.vertices[index(t[0])], mesh.vertices[index(t[1])],
                                        mesh.vertices[index(t[2])]};
    placed.push_back({corner, reliable_normal(corner)});
  }
  return placed;
}

// The triangles at every vertex in one array (compressed rows): counting, prefix sums, then filling
// in.
void build_incidence(ProximityMesh::Data& data) {
  const std::size_t n = data.mesh.vertices.size();
  data.first_triangle_at.assign(n + 1, 0);
  for (const Triangle& t : data.mesh.triangles) {
    for (int v : t) ++data.first_triangle_at[index(v) + 1];
  }
  for (std::size_t v = 0; v < n; ++v) data.first_triangle_at[v + 1] += data.first_triangle_at[v];
  data.triangles_at.resize(3 * data.mesh.triangles.size());
  std::vector<int> next(data.first_triangle_at.begin(), data.first_triangle_at.end() - 1);
  for (std::size_t t = 0; t < data.mesh.triangles.size(); ++t) {
    for (int v : data.mesh.triangles[t]) {
      data.triangles_at[index(next[index(v)]++)] = static_cast<int>(t);
    }
  }
}

// Distances between triangles of mesh a and triangles of mesh b at a fixed relative pose [m], in
// a's frame. The triangle of b asked for last stays placed: the next query is often about it.
class PairDistance {
 public:
  PairDistance(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB)
      : a_(a.data().triangles), b_(b.data().triangles), X_AB_(X_AB) {}

  // Triangle `tb` of mesh b in a's frame; valid until the next one is asked for.
  const PlacedTriangle& placed(int tb) {
    if (tb == placed_) return in_a_;
    placed_ = tb;
    const PlacedTriangle& b = b_[index(tb)];
    for (std::size_t k = 0; k < 3; ++k) in_a_.corner[k] = X_AB_ * b.corner[k];
    in_a_.normal = X_AB_.linear() * b.normal;
    return in_a_;
  }

  double bound(int ta, int tb) { return plane_bound(a_[index(ta)], placed(tb)); }
  double operator()(int ta, int tb) { return nearest(ta, tb).distance; }
  NearestPoints nearest(int ta, int tb) { return triangle_distance(a_[index(ta)], placed(tb)); }

 private:
  const std::vector<PlacedTriangle>& a_;
  const std::vector<PlacedTriangle>& b_;
  const Pose X_AB_;
  int placed_ = -1;
  PlacedTriangle in_a_;
};

// Finds the smallest triangle distance. A pair of boxes is pruned when it cannot improve the best
// distance by more than the permitted relative error, or lies beyond the cap. The smallest pruned
// bound is kept: together with the best distance it is a lower bound of the true distance.
struct NearestVisitor {
  PairDistance& distance;
  double cap;
  double factor;                                            // 1 / (1 + relative error)
  double best = std::numeric_limits<double>::infinity();    // smallest triangle distance found
  double pruned = std::numeric_limits<double>::infinity();  // smallest squared bound left out
  TrianglePair pair = {};

  // The distances are compared as squares, which saves a root for each pair of boxes.
  double wanted() const {
    const double distance_wanted = std::min(cap, best * factor);
    return distance_wanted * distance_wanted;
  }

  void left_out(double squared) { pruned = std::min(pruned, squared); }
  const PlacedTriangle& triangle_b(int tb) { return distance.placed(tb); }

  void visit(int ta, int tb) {
    const double bound = distance.bound(ta, tb);
    if (bound * bound > wanted()) return left_out(bound * bound);
    const double d = distance(ta, tb);
    if (d < best) {
      best = d;
      pair = {ta, tb};
    }
  }
};

// Looks for one intersecting pair, for which the triangle distance is exactly 0. Boxes that are
// apart cannot contain one. Once it is found, everything else is pruned.
struct CrossVisitor {
  PairDistance& distance;
  bool crossed = false;

  double wanted() const { return crossed ? -1.0 : 0.0; }
  void left_out(double) const {}
  const PlacedTriangle& triangle_b(int tb) { return distance.placed(tb); }
  void visit(int ta, int tb) {
    crossed = crossed || (distance.bound(ta, tb) == 0.0 && distance(ta, tb) == 0.0);
  }
};

// Lists the pairs that are near each other by cheap bounds of their distance, and measures those
// that may be the nearest: the smaller their distance, the fewer pairs are near. Pairs that were
// listed before that was known are left out at the end.
struct NearPairsVisitor {
  PairDistance& distance;
  const NearPairsOptions& options;
  std::vector<NearPair>& pairs;
  double best = std::numeric_limits<double>::infinity();
  double limit = std::numeric_limits<double>::infinity();
  bool too_many = false;

  double wanted() const { return too_many ? -1.0 : limit * limit; }
  void left_out(double) const {}
  const PlacedTriangle& triangle_b(int tb) { return distance.placed(tb); }

  void visit(int ta, int tb) {
    double bound = distance.bound(ta, tb);
    if (bound > limit) return;
    if (bound < best) bound = measure(ta, tb);
    if (bound > limit) return;
    pairs.push_back({{ta, tb}, bound});
    if (pairs.size() <= options.most) return;
    drop_far();
    too_many = pairs.size() > options.most;
  }

  double measure(int ta, int tb) {
    const double d = distance(ta, tb);
    if (d < best) {
      best = d;
      limit = std::max(options.reach * best, best + options.least_reach);
    }
    return d;
  }

  void drop_far() {
    std::erase_if(pairs, [&](const NearPair& near) { return near.at_least > limit; });
  }
};

// Collects all pairs within `limit` [m].
struct CollectVisitor {
  PairDistance& distance;
  double limit;
  std::vector<ClosePair>& pairs;

  double wanted() const { return limit * limit; }
  void left_out(double) const {}
  const PlacedTriangle& triangle_b(int tb) { return distance.placed(tb); }
  void visit(int ta, int tb) {
    if (distance.bound(ta, tb) > limit) return;
    const NearestPoints nearest = distance.nearest(ta, tb);
    if (nearest.distance > limit) return;
    pairs.push_back({{ta, tb}, nearest.distance, nearest.on_u, nearest.on_v});
  }
};

// Collects all pairs whose bound is within `limit` [m].
struct MaybeVisitor {
  PairDistance& distance;
  double limit;
  std::vector<TrianglePair>& pairs;

  double wanted() const { return limit * limit; }
  void left_out(double) const {}
  const PlacedTriangle& triangle_b(int tb) { return distance.placed(tb); }
  void visit(int ta, int tb) {
    if (distance.bound(ta, tb) <= limit) pairs.push_back({ta, tb});
  }
};

}  // namespace

ProximityMesh::ProximityMesh(TriangleMesh mesh, const RunContext& context) {
  if (mesh.empty()) throw InputError({.field = "mesh", .problem = "has no triangles"});
  auto data = std::make_shared<Data>();
  data->mesh = std::move(mesh);
  data->tree = build_box_tree(data->mesh, context);
  data->wide = build_wide_tree(data->tree);
  data->boundaries = build_boundary_tree(data->mesh, data->tree, context);
  context.cancellation.check();
  data->triangles = placed_triangles(data->mesh);
  build_incidence(*data);
  context.cancellation.check();
  data->ball_center = bounds(data->mesh).center();
  data->ball_radius = max_distance(data->mesh, data->ball_center);
  data->parts = convex_parts(data->mesh);
  data_ = std::move(data);
}

const TriangleMesh& ProximityMesh::mesh() const { return data_->mesh; }
const std::vector<PlacedTriangle>& ProximityMesh::triangles() const { return data_->triangles; }
const Vector3& ProximityMesh::ball_center() const { return data_->ball_center; }
double ProximityMesh::ball_radius() const { return data_->ball_radius; }
const std::vector<ConvexPoints>& ProximityMesh::parts() const { return data_->parts; }

std::size_t ProximityMesh::memory() const {
  const auto bytes_of = [](const auto& values) { return values.size() * sizeof(values[0]); };
  std::size_t bytes = sizeof(Data) + bytes_of(data_->mesh.vertices) +
                      bytes_of(data_->mesh.triangles) + bytes_of(data_->tree) +
                      bytes_of(data_->wide.nodes) + bytes_of(data_->boundaries.nodes) +
                      bytes_of(data_->boundaries.edges) + bytes_of(data_->triangles) +
                      bytes_of(data_->first_triangle_at) + bytes_of(data_->triangles_at);
  for (const ConvexPoints& part : data_->parts) {
    bytes += sizeof(part) + part.points().size() * (sizeof(Vector3) + 3 * sizeof(float));
  }
  return bytes + data_->mesh.triangles.size() * sizeof(SmoothSurface::normals[0]);
}

const SmoothSurface& ProximityMesh::smooth() const {
  std::call_once(data_->smooth_once, [&] { data_->smooth = smooth_surface(*this); });
  return data_->smooth;
}

const ShapeCover& cover_of(const ProximityMesh& mesh) {
  const ProximityMesh::Data& data = mesh.data();
  std::call_once(data.cover_once, [&] { data.cover = make_cover(mesh, data.tree); });
  return data.cover;
}

std::span<const int> ProximityMesh::triangles_at(int v) const {
  const int first = data_->first_triangle_at[index(v)];
  const int last = data_->first_triangle_at[index(v) + 1];
  return std::span<const int>(data_->triangles_at).subspan(index(first), index(last - first));
}

Gap find_gap(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
             const GapOptions& options) {
  PairDistance distance(a, b, X_AB);
  NearestVisitor visitor{distance, options.cap, 1.0 / (1.0 + options.relative_error)};
  // Measuring the hinted pair first gives a small best distance at once, which prunes most of the
  // tree.
  if (options.hint.a >= 0 && options.hint.b >= 0) visitor.visit(options.hint.a, options.hint.b);
  TreeWalk(a.data().wide, b.data().wide, X_AB, visitor).run();
  // The nearest pair was either measured, or is in a pair of boxes that was left out.
  return {std::min(visitor.best, std::sqrt(visitor.pruned)), visitor.best, visitor.pair};
}

bool surfaces_cross(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB) {
  PairDistance distance(a, b, X_AB);
  CrossVisitor visitor{distance};
  TreeWalk(a.data().wide, b.data().wide, X_AB, visitor).run();
  return visitor.crossed;
}

void find_pairs_within(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
                       double distance, std::vector<ClosePair>& pairs) {
  pairs.clear();
  PairDistance pair_distance(a, b, X_AB);
  CollectVisitor visitor{pair_distance, distance, pairs};
  TreeWalk(a.data().wide, b.data().wide, X_AB, visitor).run();
}

void find_pairs_maybe_within(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
                             double distance, std::vector<TrianglePair>& pairs) {
  pairs.clear();
  PairDistance pair_distance(a, b, X_AB);
  MaybeVisitor visitor{pair_distance, distance, pairs};
  TreeWalk(a.data().wide, b.data().wide, X_AB, visitor).run();
}

void find_triangles_in(const ProximityMesh& mesh, const Bounds& box, std::vector<int>& triangles) {
  triangles.clear();
  collect_in_box(mesh.data().wide, box, triangles);
}

bool find_near_pairs(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
                     const NearPairsOptions& options, NearPairs& near) {
  near.pairs.clear();
  PairDistance distance(a, b, X_AB);
  NearPairsVisitor visitor{distance, options, near.pairs};
  if (options.hint.a >= 0 && options.hint.b >= 0) visitor.measure(options.hint.a, options.hint.b);
  TreeWalk(a.data().wide, b.data().wide, X_AB, visitor).run();
  if (visitor.too_many) return false;
  visitor.drop_far();
  near.beyond = visitor.limit;
  return true;
}

Gap gap_of_pairs(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB, double moved,
                 NearPairs& near) {
  PairDistance distance(a, b, X_AB);
  near.beyond -= moved;
  Gap gap{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), {}};
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < near.pairs.size(); ++i) {
    NearPair& listed = near.pairs[i];
    listed.at_least -= moved;
    if (listed.at_least >= gap.upper) continue;
    listed.at_least = std::max(listed.at_least, distance.bound(listed.pair.a, listed.pair.b));
    if (listed.at_least >= gap.upper) continue;
    const double d = distance(listed.pair.a, listed.pair.b);
    listed.at_least = d;
    if (d >= gap.upper) continue;
    gap = {d, d, listed.pair};
    nearest = i;
  }
  if (nearest != 0) std::swap(near.pairs[0], near.pairs[nearest]);
  return gap;
}

// Both nearest points come in a's frame; the second one is turned into b's.
TriangleGap triangle_gap(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
                         TrianglePair pair) {
  const NearestPoints nearest = PairDistance(a, b, X_AB).nearest(pair.a, pair.b);
  return {nearest.distance, nearest.on_u, X_AB.inverse() * nearest.on_v};
}

RayHit first_hit(const ProximityMesh& mesh, const Vector3& from, const Vector3& direction,
                 double cap) {
  return first_hit(mesh.data().wide, mesh.data().triangles, from, direction, cap);
}

bool is_inside(const ProximityMesh& mesh, const Vector3& p_M) {
  const ProximityMesh::Data& data = mesh.data();
  // Answers most queries, also for meshes whose boundaries are too long to be stored.
  const BoxNode& box = data.tree.front();
  if (((p_M - box.center).cwiseAbs().array() > box.half.array()).any()) return false;
  return winding_number(data.mesh, data.tree, data.boundaries, p_M) >= 0.5;
}

}  // namespace prehend
