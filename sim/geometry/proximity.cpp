// Queries on two bounding-volume hierarchies.
//
// All queries walk pairs of nodes, one of each tree (PairWalk), and leave out pairs of boxes whose
// lower bound of the distance shows that no wanted pair of triangles is inside. They differ in what
// a visitor wants. Distances of triangle pairs come from FCL's implementation of the PQP triangle
// distance (Larsen, Gottschalk, Lin and Manocha 1999).
#include "sim/geometry/proximity.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fcl/narrowphase/detail/primitive_shape_algorithm/triangle_distance.h>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/geometry/box_tree.h"
#include "sim/geometry/convex_parts.h"
#include "sim/geometry/winding_number.h"

namespace prehend {
namespace {

// FCL's triangle distance compares with absolute thresholds that are too coarse for small triangles
// in metres. All its arguments are therefore in millimetres, and its results are turned back into
// metres at once (PairDistance).
constexpr double kMillimetres = 1000.0;

using Corners = std::array<Vector3, 3>;  // of a triangle

}  // namespace

struct ProximityMesh::Data {
  TriangleMesh mesh;
  std::vector<BoxNode> tree;
  BoundaryTree boundaries;
  std::vector<Corners> corners_mm;     // per triangle
  std::vector<Vector3> normals;        // per triangle, unit; zero for one without area
  std::vector<int> first_triangle_at;  // per vertex, start of its run in triangles_at
  std::vector<int> triangles_at;
  Vector3 ball_center = Vector3::Zero();
  double ball_radius = 0.0;
  std::vector<ConvexPoints> parts;
};

namespace {

std::vector<Corners> corners_in_mm(const TriangleMesh& mesh) {
  std::vector<Corners> corners;
  corners.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    corners.push_back({mesh.vertices[index(t[0])] * kMillimetres,
                       mesh.vertices[index(t[1])] * kMillimetres,
                       mesh.vertices[index(t[2])] * kMillimetres});
  }
  return corners;
}

std::vector<Vector3> unit_normals(const std::vector<Corners>& triangles) {
  std::vector<Vector3> normals;
  normals.reserve(triangles.size());
  for (const Corners& c : triangles) {
    const Vector3 area = (c[1] - c[0]).cross(c[2] - c[0]);
    const double length = area.norm();
    normals.push_back(length > 0.0 ? Vector3(area / length) : Vector3::Zero());
  }
  return normals;
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

// Traverses both trees at once, nearer pair first, so that small distances are found early and
// prune the rest. `Visitor` has:
// double wanted() const        squared distance [m^2] at which pairs begin to be unwanted
// bool prune(double squared)   whether pairs at this squared distance or more are unwanted; called
//                              for each pair of boxes that is left out
// void visit(int a, int b)     called for pairs of triangles that were not pruned
template <typename Visitor>
class PairWalk {
 public:
  PairWalk(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB, Visitor& visitor)
      : a_(a.data().tree), b_(b.data().tree), distance_(X_AB), visitor_(visitor) {}

  void run() {
    const Placed root = distance_.placed(b_.front());
    if (!visitor_.prune(squared(0, 0, root))) descend(0, 0, root);
  }

 private:
  using Placed = BoxDistance::Placed;

  double squared(int node_a, int node_b, const Placed& in_a) const {
    return distance_.squared(a_[index(node_a)], b_[index(node_b)], in_a, visitor_.wanted());
  }

  void descend(int node_a, int node_b, const Placed& in_a) {
    const BoxNode& a = a_[index(node_a)];
    const BoxNode& b = b_[index(node_b)];
    if (a.is_leaf() && b.is_leaf()) {
      visitor_.visit(a.triangle, b.triangle);
      return;
    }
    // Descend into the larger box: its children improve the bound the most.
    if (b.is_leaf() || (!a.is_leaf() && a.half.squaredNorm() > b.half.squaredNorm())) {
      const double first = squared(a.left, node_b, in_a);
      const double second = squared(a.left + 1, node_b, in_a);
      const int nearer = second < first ? 1 : 0;
      if (!visitor_.prune(std::min(first, second))) descend(a.left + nearer, node_b, in_a);
      if (!visitor_.prune(std::max(first, second))) descend(a.left + 1 - nearer, node_b, in_a);
    } else {
      const std::array<Placed, 2> children{distance_.placed(b_[index(b.left)]),
                                           distance_.placed(b_[index(b.left + 1)])};
      const double first = squared(node_a, b.left, children[0]);
      const double second = squared(node_a, b.left + 1, children[1]);
      const int nearer = second < first ? 1 : 0;
      const int farther = 1 - nearer;
      if (!visitor_.prune(std::min(first, second))) {
        descend(node_a, b.left + nearer, children[index(nearer)]);
      }
      if (!visitor_.prune(std::max(first, second))) {
        descend(node_a, b.left + farther, children[index(farther)]);
      }
    }
  }

  const std::vector<BoxNode>& a_;
  const std::vector<BoxNode>& b_;
  const BoxDistance distance_;
  Visitor& visitor_;
};

// Distance between a triangle of mesh a and a triangle of mesh b at a fixed relative pose [m].
class PairDistance {
 public:
  PairDistance(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB)
      : a_(a.data().corners_mm),
        b_(b.data().corners_mm),
        normals_a_(a.data().normals),
        normals_b_(b.data().normals),
        rotation_(X_AB.linear()),
        shift_(X_AB.translation() * kMillimetres) {}

  // A lower bound of the distance in a fraction of its time: how far the plane of one triangle is
  // from the corners of the other. 0 where they are on both sides of both planes.
  double plane_bound(int ta, int tb) const {
    const Corners& u = a_[index(ta)];
    const Corners& q = b_[index(tb)];
    const Corners v{rotation_ * q[0] + shift_, rotation_ * q[1] + shift_,
                    rotation_ * q[2] + shift_};
    const double over_u = height(normals_a_[index(ta)], u[0], v);
    const double over_v = height(rotation_ * normals_b_[index(tb)], v[0], u);
    return std::max(over_u, over_v) / kMillimetres;
  }

  // The distance alone, 0 for triangles that intersect.
  double operator()(int ta, int tb) const {
    Vector3 p_A;
    Vector3 p_B;
    return (*this)(ta, tb, p_A, p_B);
  }

  // The nearest points on the two triangles are both in a's frame [m].
  double operator()(int ta, int tb, Vector3& p_A, Vector3& q_A) const {
    const Corners& u = a_[index(ta)];
    const Corners& v = b_[index(tb)];
    const double d = fcl::detail::TriangleDistance<double>::triDistance(
        u[0], u[1], u[2], v[0], v[1], v[2], rotation_, shift_, p_A, q_A);
    p_A /= kMillimetres;
    q_A /= kMillimetres;
    return d / kMillimetres;
  }

 private:
  // Smallest distance of the points from the plane through p with this normal if they are all on
  // one side, else 0; 0 for the normal of a triangle without area, too.
  static double height(const Vector3& normal, const Vector3& p, const Corners& points) {
    const double h0 = normal.dot(points[0] - p);
    const double h1 = normal.dot(points[1] - p);
    const double h2 = normal.dot(points[2] - p);
    const double above = std::min({h0, h1, h2});
    const double below = -std::max({h0, h1, h2});
    return std::max({0.0, above, below});
  }

  const std::vector<Corners>& a_;
  const std::vector<Corners>& b_;
  const std::vector<Vector3>& normals_a_;
  const std::vector<Vector3>& normals_b_;
  Matrix3 rotation_;
  Vector3 shift_;
};

// Finds the smallest triangle distance. A pair of boxes is pruned when it cannot improve the best
// distance by more than the permitted relative error, or lies beyond the cap. The smallest pruned
// bound is kept: together with the best distance it is a lower bound of the true distance.
struct NearestVisitor {
  const PairDistance& distance;
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

  bool prune(double squared) {
    if (squared < wanted()) return false;
    pruned = std::min(pruned, squared);
    return true;
  }

  void visit(int ta, int tb) {
    const double bound = distance.plane_bound(ta, tb);
    if (prune(bound * bound)) return;
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
  const PairDistance& distance;
  bool crossed = false;

  double wanted() const { return 0.0; }
  bool prune(double squared) const { return crossed || squared > 0.0; }
  void visit(int ta, int tb) { crossed = crossed || distance(ta, tb) == 0.0; }
};

// Lists the pairs that are near each other by cheap bounds of their distance, and measures those
// that may be the nearest: the smaller their distance, the fewer pairs are near. Pairs that were
// listed before that was known are left out at the end.
struct NearPairsVisitor {
  const PairDistance& distance;
  const NearPairsOptions& options;
  std::vector<NearPair>& pairs;
  double best = std::numeric_limits<double>::infinity();
  double limit = std::numeric_limits<double>::infinity();
  bool too_many = false;

  double wanted() const { return limit * limit; }
  bool prune(double squared) const { return squared > limit * limit || too_many; }

  void visit(int ta, int tb) {
    double bound = distance.plane_bound(ta, tb);
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
  const PairDistance& distance;
  double limit;
  std::vector<TrianglePair>& pairs;

  double wanted() const { return limit * limit; }
  bool prune(double squared) const { return squared > limit * limit; }
  void visit(int ta, int tb) {
    if (distance.plane_bound(ta, tb) <= limit && distance(ta, tb) <= limit) {
      pairs.push_back({ta, tb});
    }
  }
};

}  // namespace

ProximityMesh::ProximityMesh(TriangleMesh mesh, const RunContext& context) {
  if (mesh.empty()) throw InputError({.field = "mesh", .problem = "has no triangles"});
  auto data = std::make_shared<Data>();
  data->mesh = std::move(mesh);
  data->tree = build_box_tree(data->mesh, context);
  data->boundaries = build_boundary_tree(data->mesh, data->tree, context);
  context.cancellation.check();
  data->corners_mm = corners_in_mm(data->mesh);
  data->normals = unit_normals(data->corners_mm);
  build_incidence(*data);
  context.cancellation.check();
  data->ball_center = bounds(data->mesh).center();
  data->ball_radius = max_distance(data->mesh, data->ball_center);
  data->parts = convex_parts(data->mesh);
  data_ = std::move(data);
}

const TriangleMesh& ProximityMesh::mesh() const { return data_->mesh; }
const Vector3& ProximityMesh::ball_center() const { return data_->ball_center; }
double ProximityMesh::ball_radius() const { return data_->ball_radius; }
const std::vector<ConvexPoints>& ProximityMesh::parts() const { return data_->parts; }

std::span<const int> ProximityMesh::triangles_at(int v) const {
  const int first = data_->first_triangle_at[index(v)];
  const int last = data_->first_triangle_at[index(v) + 1];
  return std::span<const int>(data_->triangles_at).subspan(index(first), index(last - first));
}

Gap find_gap(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
             const GapOptions& options) {
  const PairDistance distance(a, b, X_AB);
  NearestVisitor visitor{distance, options.cap, 1.0 / (1.0 + options.relative_error)};
  // Measuring the hinted pair first gives a small best distance at once, which prunes most of the
  // tree.
  if (options.hint.a >= 0 && options.hint.b >= 0) visitor.visit(options.hint.a, options.hint.b);
  PairWalk(a, b, X_AB, visitor).run();
  // The nearest pair was either measured, or is in a pair of boxes that was left out.
  return {std::min(visitor.best, std::sqrt(visitor.pruned)), visitor.best, visitor.pair};
}

bool surfaces_cross(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB) {
  const PairDistance distance(a, b, X_AB);
  CrossVisitor visitor{distance};
  PairWalk(a, b, X_AB, visitor).run();
  return visitor.crossed;
}

void find_pairs_within(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
                       double distance, std::vector<TrianglePair>& pairs) {
  pairs.clear();
  const PairDistance pair_distance(a, b, X_AB);
  CollectVisitor visitor{pair_distance, distance, pairs};
  PairWalk(a, b, X_AB, visitor).run();
}

bool find_near_pairs(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
                     const NearPairsOptions& options, NearPairs& near) {
  near.pairs.clear();
  const PairDistance distance(a, b, X_AB);
  NearPairsVisitor visitor{distance, options, near.pairs};
  if (options.hint.a >= 0 && options.hint.b >= 0) visitor.measure(options.hint.a, options.hint.b);
  PairWalk(a, b, X_AB, visitor).run();
  if (visitor.too_many) return false;
  visitor.drop_far();
  near.beyond = visitor.limit;
  return true;
}

Gap gap_of_pairs(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB, double moved,
                 NearPairs& near) {
  const PairDistance distance(a, b, X_AB);
  near.beyond -= moved;
  Gap gap{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), {}};
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < near.pairs.size(); ++i) {
    NearPair& listed = near.pairs[i];
    listed.at_least -= moved;
    if (listed.at_least >= gap.upper) continue;
    listed.at_least = std::max(listed.at_least, distance.plane_bound(listed.pair.a, listed.pair.b));
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
  TriangleGap gap;
  Vector3 q_A;
  gap.distance = PairDistance(a, b, X_AB)(pair.a, pair.b, gap.p_A, q_A);
  gap.p_B = X_AB.inverse() * q_A;
  return gap;
}

bool is_inside(const ProximityMesh& mesh, const Vector3& p_M) {
  const ProximityMesh::Data& data = mesh.data();
  // Answers most queries, also for meshes whose boundaries are too long to be stored.
  const BoxNode& box = data.tree.front();
  if (((p_M - box.center).cwiseAbs().array() > box.half.array()).any()) return false;
  return winding_number(data.mesh, data.tree, data.boundaries, p_M) >= 0.5;
}

}  // namespace prehend
