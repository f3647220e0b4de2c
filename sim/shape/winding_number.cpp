// Hierarchical evaluation (Jacobson, Kavan and Sorkine-Hornung 2013, section 4.3). From a point
// outside a convex region, all surfaces within the region that have the same boundary cover the
// same solid angle: two of them form a closed surface that does not enclose the point. So the part
// of the mesh in a box may be replaced by the fan of triangles from any point of the box to the
// part's boundary edges, which are far fewer than its triangles. Only boxes that contain the point
// are opened.
#include "sim/shape/winding_number.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <numbers>
#include <span>
#include <utility>

#include "sim/base/index.h"

namespace prehend {
namespace {

// Solid angle of a triangle seen from the origin, positive where its back faces the origin (Van
// Oosterom and Strackee 1983).
double solid_angle(const Vector3& a, const Vector3& b, const Vector3& c) {
  const double la = a.norm();
  const double lb = b.norm();
  const double lc = c.norm();
  const double denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return 2.0 * std::atan2(a.dot(b.cross(c)), denominator);
}

// How often the triangles of a part traverse an edge from `low` to `high`, less how often the other
// way round; never 0 in a list.
struct NetEdge {
  int low = 0;
  int high = 0;
  int net = 0;

  bool before(const NetEdge& other) const {
    return low != other.low ? low < other.low : high < other.high;
  }
};

void sort_edges(std::vector<NetEdge>& edges) {
  std::sort(edges.begin(), edges.end(),
            [](const NetEdge& a, const NetEdge& b) { return a.before(b); });
}

// The sum of two sorted lists, without the edges that cancel.
std::vector<NetEdge> sum_of(const std::vector<NetEdge>& a, const std::vector<NetEdge>& b) {
  std::vector<NetEdge> sum;
  sum.reserve(a.size() + b.size());
  std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(sum),
             [](const NetEdge& s, const NetEdge& t) { return s.before(t); });
  std::size_t used = 0;
  for (const NetEdge& edge : sum) {
    if (used > 0 && !sum[used - 1].before(edge)) {
      sum[used - 1].net += edge.net;
      if (sum[used - 1].net == 0) --used;
    } else {
      sum[used++] = edge;
    }
  }
  sum.resize(used);
  return sum;
}

std::vector<NetEdge> edges_of(const Triangle& t) {
  std::vector<NetEdge> edges;
  for (std::size_t k = 0; k < 3; ++k) {
    const int from = t[k];
    const int to = t[(k + 1) % 3];
    if (from != to) edges.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1});
  }
  sort_edges(edges);
  return edges;
}

// Parts of fewer triangles than this have about as many boundary edges as triangles.
constexpr int kFewTriangles = 8;

class BoundaryBuilder {
 public:
  BoundaryBuilder(const TriangleMesh& mesh, const std::vector<BoxNode>& tree,
                  const RunContext& context)
      : mesh_(mesh), tree_(tree), context_(context) {
    built_.nodes.resize(tree.size());
  }

  BoundaryTree build() {
    if (!tree_.empty()) visit(0);
    built_.edges.shrink_to_fit();
    return std::move(built_);
  }

 private:
  struct Part {
    int triangles = 0;
    std::vector<NetEdge> boundary;  // sorted
  };

  Part visit(int i) {
    const BoxNode& node = tree_[index(i)];
    if (node.is_leaf()) return {1, edges_of(mesh_.triangles[index(node.triangle)])};
    context_.cancellation.check();
    const Part left = visit(node.left);
    const Part right = visit(node.left + 1);
    Part part{left.triangles + right.triangles, sum_of(left.boundary, right.boundary)};
    store(i, part);
    return part;
  }

  void store(int i, const Part& part) {
    int count = 0;
    for (const NetEdge& edge : part.boundary) count += std::abs(edge.net);
    if (part.triangles < kFewTriangles || 2 * count > part.triangles) return;
    built_.nodes[index(i)] = {static_cast<int>(built_.edges.size()), count};
    for (const NetEdge& edge : part.boundary) {
      const std::array<int, 2> forward{edge.low, edge.high};
      const std::array<int, 2> backward{edge.high, edge.low};
      for (int k = 0; k < std::abs(edge.net); ++k) {
        built_.edges.push_back(edge.net > 0 ? forward : backward);
      }
    }
  }

  const TriangleMesh& mesh_;
  const std::vector<BoxNode>& tree_;
  const RunContext& context_;
  BoundaryTree built_;
};

// Sums the solid angles below a node, as seen from one point.
class SolidAngle {
 public:
  SolidAngle(const TriangleMesh& mesh, const std::vector<BoxNode>& tree,
             const BoundaryTree& boundaries, const Vector3& p_M)
      : mesh_(mesh), tree_(tree), boundaries_(boundaries), p_M_(p_M) {}

  double below(int i) const {
    const BoxNode& node = tree_[index(i)];
    if (node.is_leaf()) {
      const Triangle& t = mesh_.triangles[index(node.triangle)];
      return solid_angle(seen(t[0]), seen(t[1]), seen(t[2]));
    }
    const BoundaryTree::Boundary& boundary = boundaries_.nodes[index(i)];
    const bool is_outside = ((p_M_ - node.center).cwiseAbs().array() > node.half.array()).any();
    if (is_outside && boundary.count >= 0) return fan(boundary);
    return below(node.left) + below(node.left + 1);
  }

 private:
  // Vertex `v` as seen from the point.
  Vector3 seen(int v) const { return mesh_.vertices[index(v)] - p_M_; }

  // The fan from the first vertex of the boundary.
  double fan(const BoundaryTree::Boundary& boundary) const {
    if (boundary.count == 0) return 0.0;
    const auto edges =
        std::span(boundaries_.edges).subspan(index(boundary.first), index(boundary.count));
    const Vector3 apex = seen(edges.front()[0]);
    double sum = 0.0;
    for (const auto& [from, to] : edges) sum += solid_angle(apex, seen(from), seen(to));
    return sum;
  }

  const TriangleMesh& mesh_;
  const std::vector<BoxNode>& tree_;
  const BoundaryTree& boundaries_;
  const Vector3& p_M_;
};

}  // namespace

BoundaryTree build_boundary_tree(const TriangleMesh& mesh, const std::vector<BoxNode>& tree,
                                 const RunContext& context) {
  return BoundaryBuilder(mesh, tree, context).build();
}

double winding_number(const TriangleMesh& mesh, const std::vector<BoxNode>& tree,
                      const BoundaryTree& boundaries, const Vector3& p_M) {
  if (tree.empty()) return 0.0;
  return SolidAngle(mesh, tree, boundaries, p_M).below(0) / (4.0 * std::numbers::pi);
}

}  // namespace prehend
