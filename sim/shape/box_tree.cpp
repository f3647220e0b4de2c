// Top-down construction of the bounding volume hierarchy by median splits, which makes it balanced:
// depth log2 of the number of triangles, 2 n - 1 nodes. The triangles are divided by their
// centroids, along the axis in which the centroids are spread most, while the boxes enclose the
// whole triangles.
#include "sim/shape/box_tree.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "sim/base/index.h"

namespace prehend {
namespace {

class Builder {
 public:
  Builder(const TriangleMesh& mesh, const RunContext& context)
      : mesh_(mesh), context_(context), order_(mesh.triangles.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    centers_.reserve(order_.size());
    for (const Triangle& t : mesh.triangles) {
      centers_.push_back((vertex(t[0]) + vertex(t[1]) + vertex(t[2])) / 3.0);
    }
  }

  std::vector<BoxNode> build() {
    nodes_.reserve(2 * order_.size());
    if (order_.empty()) return {};
    nodes_.emplace_back();
    fill(0, order_);
    return std::move(nodes_);
  }

 private:
  const Vector3& vertex(int v) const { return mesh_.vertices[index(v)]; }

  // Fills node `node` with the given triangles (a part of order_, which is permuted) and makes its
  // subtree.
  void fill(std::size_t node, std::span<int> triangles) {
    context_.cancellation.check();
    Bounds box;
    Bounds of_centers;
    for (int t : triangles) {
      for (int v : mesh_.triangles[index(t)]) {
        box.lower = box.lower.cwiseMin(vertex(v));
        box.upper = box.upper.cwiseMax(vertex(v));
      }
      of_centers.lower = of_centers.lower.cwiseMin(centers_[index(t)]);
      of_centers.upper = of_centers.upper.cwiseMax(centers_[index(t)]);
    }
    nodes_[node].center = box.center();
    nodes_[node].half = 0.5 * box.size();
    if (triangles.size() == 1) {
      nodes_[node].triangle = triangles.front();
      return;
    }
    Vector3::Index axis = 0;
    of_centers.size().maxCoeff(&axis);
    const auto middle = triangles.begin() + static_cast<std::ptrdiff_t>(triangles.size() / 2);
    std::nth_element(triangles.begin(), middle, triangles.end(), [&](int s, int t) {
      const double a = centers_[index(s)][axis];
      const double b = centers_[index(t)][axis];
      // Equal centroids are ordered by index, so that the tree is the same with every standard
      // library.
      return a != b ? a < b : s < t;
    });
    // Siblings are next to each other, so that a node stores the index of the first only.
    const std::size_t left = nodes_.size();
    nodes_[node].left = static_cast<int>(left);
    nodes_.emplace_back();
    nodes_.emplace_back();
    fill(left, triangles.first(triangles.size() / 2));
    fill(left + 1, triangles.subspan(triangles.size() / 2));
  }

  const TriangleMesh& mesh_;
  const RunContext& context_;
  std::vector<int> order_;
  std::vector<Vector3> centers_;
  std::vector<BoxNode> nodes_;
};

}  // namespace

std::vector<BoxNode> build_box_tree(const TriangleMesh& mesh, const RunContext& context) {
  return Builder(mesh, context).build();
}

}  // namespace prehend
