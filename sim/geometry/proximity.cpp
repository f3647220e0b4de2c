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
// bool prune(double squared)   whether pairs at this squared distance [m^2] or more are unwanted
// void visit(int a, int b)     called for pairs of triangles that were not pruned
template <typename Visitor>
class PairWalk {
 public:
  PairWalk(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB, Visitor& visitor)
      : a_(a.data().tree), b_(b.data().tree), distance_(X_AB), visitor_(visitor) {}

  void run() {
    if (!visitor_.prune(squared(0, 0))) descend(0, 0);
  }

 private:
  double squared(int node_a, int node_b) const {
    return distance_.squared(a_[index(node_a)], b_[index(node_b)]);
  }

  void descend(int node_a, int node_b) {
    const BoxNode& a = a_[index(node_a)];
    const BoxNode& b = b_[index(node_b)];
    if (a.is_leaf() && b.is_leaf()) {
      visitor_.visit(a.triangle, b.triangle);
      return;
    }
    // Descend into the larger box: its children improve the bound the most.
    const bool split_a =
        b.is_leaf() || (!a.is_leaf() && a.half.squaredNorm() > b.half.squaredNorm());
    int near_a = split_a ? a.left : node_a;
    int near_b = split_a ? node_b : b.left;
    int far_a = split_a ? a.left + 1 : node_a;
    int far_b = split_a ? node_b : b.left + 1;
    double near = squared(near_a, near_b);
    double far = squared(far_a, far_b);
    if (far < near) {
      std::swap(near, far);
      std::swap(near_a, far_a);
      std::swap(near_b, far_b);
    }
    if (!visitor_.prune(near)) descend(near_a, near_b);
    if (!visitor_.prune(far)) descend(far_a, far_b);
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
        rotation_(X_AB.linear()),
        shift_(X_AB.translation() * kMillimetres) {}

  // A lower bound of the distance in a fraction of its time: how far the plane of one triangle is
  // from the corners of the other. 0 where they are on both sides of both planes.
  double plane_bound(int ta, int tb) const {
    const Corners& u = a_[index(ta)];
    const Corners& q = b_[index(tb)];
    const Corners v{rotation_ * q[0] + shift_, rotation_ * q[1] + shift_,
                    rotation_ * q[2] + shift_};
    return std::max(height_over(u, v), height_over(v, u)) / kMillimetres;
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
  // Smallest distance of the points from the triangle's plane if they are all on one side, else 0;
  // 0 for a triangle without area, too.
  static double height_over(const Corners& triangle, const Corners& points) {
    const Vector3 n = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
    const double length = n.norm();
    if (length == 0.0) return 0.0;
    const double h0 = n.dot(points[0] - triangle[0]);
    const double h1 = n.dot(points[1] - triangle[0]);
    const double h2 = n.dot(points[2] - triangle[0]);
    const double above = std::min({h0, h1, h2});
    const double below = -std::max({h0, h1, h2});
    return std::max({0.0, above, below}) / length;
  }

  const std::vector<Corners>& a_;
  const std::vector<Corners>& b_;
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
  bool prune(double squared) {
    const double wanted = std::min(cap, best * factor);
    if (squared < wanted * wanted) return false;
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

  bool prune(double squared) const { return crossed || squared > 0.0; }
  void visit(int ta, int tb) { crossed = crossed || distance(ta, tb) == 0.0; }
};

// Collects all pairs within `limit` [m], until there are more than `most`.
struct CollectVisitor {
  const PairDistance& distance;
  double limit;
  std::size_t most;
  std::vector<TrianglePair>& pairs;

  bool prune(double squared) const { return squared > limit * limit || pairs.size() > most; }
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

bool find_pairs_within(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
                       double distance, std::vector<TrianglePair>& pairs, std::size_t most) {
  pairs.clear();
  const PairDistance pair_distance(a, b, X_AB);
  CollectVisitor visitor{pair_distance, distance, most, pairs};
  PairWalk(a, b, X_AB, visitor).run();
  return pairs.size() <= most;
}

Gap gap_of_pairs(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
                 std::span<const TrianglePair> pairs) {
  const PairDistance distance(a, b, X_AB);
  Gap gap{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), {}};
  for (const TrianglePair& pair : pairs) {
    const double d = distance(pair.a, pair.b);
    if (d < gap.upper) gap = {d, d, pair};
  }
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
