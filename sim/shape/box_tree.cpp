// Top-down construction of the bounding volume hierarchy: 2 n - 1 nodes. The triangles are divided
// by their centroids, while the boxes enclose the whole triangles. How likely a query enters a box
// is about in proportion to its surface, so that the boxes should be small and few triangles in
// large ones.
#include "sim/shape/box_tree.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <span>

#include "sim/base/index.h"

namespace prehend {
namespace {

// Splits are looked for at the borders of so many equal parts of the range of the centroids.
constexpr int kBins = 16;
// Below this the splits are at the median, so that no arrangement of triangles makes a deep tree.
constexpr int kDeep = 48;

// Half of its surface; 0 for an empty one.
double half_surface(const Bounds& box) {
  const Vector3 size = box.size();
  return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
}

void grow(Bounds& box, const Bounds& other) {
  box.lower = box.lower.cwiseMin(other.lower);
  box.upper = box.upper.cwiseMax(other.upper);
}

// The triangles whose centroids are in one part of the range.
struct Bin {
  Bounds box;
  std::size_t count = 0;
};

// The bins before `bin` go to one side.
struct Split {
  int bin = 0;
  double cost = std::numeric_limits<double>::infinity();
};

Split best_split_of(const std::array<Bin, kBins>& bins) {
  // Of the bins from k on.
  std::array<double, kBins> cost_above{};
  Bounds box;
  std::size_t count = 0;
  for (int k = kBins - 1; k > 0; --k) {
    const Bin& bin = bins[index(k)];
    if (bin.count > 0) grow(box, bin.box);
    count += bin.count;
    cost_above[index(k)] = count > 0 ? static_cast<double>(count) * half_surface(box)
                                     : std::numeric_limits<double>::infinity();
  }
  Split best;
  box = Bounds();
  count = 0;
  for (int k = 1; k < kBins; ++k) {
    const Bin& bin = bins[index(k - 1)];
    if (bin.count > 0) grow(box, bin.box);
    count += bin.count;
    if (count == 0) continue;
    const double cost = static_cast<double>(count) * half_surface(box) + cost_above[index(k)];
    if (cost < best.cost) best = {k, cost};
  }
  return best;
}

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
    fill(0, order_, 0);
    return std::move(nodes_);
  }

 private:
  const Vector3& vertex(int v) const { return mesh_.vertices[index(v)]; }

  Bounds box_of(int triangle) const {
    Bounds box;
    for (int v : mesh_.triangles[index(triangle)]) {
      box.lower = box.lower.cwiseMin(vertex(v));
      box.upper = box.upper.cwiseMax(vertex(v));
    }
    return box;
  }

  // Fills node `node` with the given triangles (a part of order_, which is permuted) and makes its
  // subtree.
  void fill(std::size_t node, std::span<int> triangles, int depth) {
    context_.cancellation.check();
    Bounds box;
    Bounds of_centers;
    for (int t : triangles) {
      grow(box, box_of(t));
      of_centers.lower = of_centers.lower.cwiseMin(centers_[index(t)]);
      of_centers.upper = of_centers.upper.cwiseMax(centers_[index(t)]);
    }
    nodes_[node].center = box.center();
    nodes_[node].half = 0.5 * box.size();
    if (triangles.size() == 1) {
      nodes_[node].triangle = triangles.front();
      return;
    }
    std::size_t first = 0;
    if (depth < kDeep) first = split_by_surface(triangles, of_centers);
    if (first == 0) first = split_at_median(triangles, of_centers);
    // Siblings are next to each other, so that a node stores the index of the first only.
    const std::size_t left = nodes_.size();
    nodes_[node].left = static_cast<int>(left);
    nodes_.emplace_back();
    nodes_.emplace_back();
    fill(left, triangles.first(first), depth + 1);
    fill(left + 1, triangles.subspan(first), depth + 1);
  }

  // Moves the triangles of one side to the front and returns their number; 0 where all centroids
  // are at one place.
  std::size_t split_by_surface(std::span<int> triangles, const Bounds& of_centers) const {
    Split best;
    Vector3::Index along = 0;
    const auto bin_of = [&](int t, Vector3::Index axis) {
      const double part =
          (centers_[index(t)][axis] - of_centers.lower[axis]) / of_centers.size()[axis];
      return std::min(kBins - 1, static_cast<int>(kBins * part));
    };
    for (Vector3::Index axis = 0; axis < 3; ++axis) {
      if (!(of_centers.size()[axis] > 0.0)) continue;
      std::array<Bin, kBins> bins{};
      for (int t : triangles) {
        Bin& bin = bins[index(bin_of(t, axis))];
        grow(bin.box, box_of(t));
        ++bin.count;
      }
      const Split split = best_split_of(bins);
      if (split.cost < best.cost) {
        best = split;
        along = axis;
      }
    }
    if (best.bin == 0) return 0;
    const auto middle = std::partition(triangles.begin(), triangles.end(),
                                       [&](int t) { return bin_of(t, along) < best.bin; });
    return static_cast<std::size_t>(middle - triangles.begin());
  }

  // Of the centroids, along the longest side of their bounds.
  std::size_t split_at_median(std::span<int> triangles, const Bounds& of_centers) const {
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
    return triangles.size() / 2;
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
