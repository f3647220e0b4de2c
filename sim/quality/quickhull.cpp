#include "sim/quality/quickhull.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "sim/base/index.h"
#include "sim/quality/expanding_polytope.h"
#include "sim/quality/proved_volume.h"

// A polytope grows from the start simplex, point by point. Each column beyond it is kept with one
// of the facets that see it, in that facet's outside set. The one that is farthest above its facet
// is added next, and the outside sets of the facets that it replaces are shared out among the new
// facets. A column that none of these sees is inside.
namespace prehend {
namespace {

// Heights relative to the largest coordinate that are taken for rounding, tried one after the other
// until the hull is proved. Wrenches may be in one plane up to any error. Where that is about as
// large as what is taken for rounding, facets that should have the same plane do not, and fold.
constexpr std::array<double, 3> kRoundings = {1e-13, 3e-12, 1e-11};

// A list of columns, linked by HullGrowth::next_.
struct OutsideSet {
  int first = -1;
  int farthest = -1;
  double height = 0.0;  // of the farthest above the facet
};

class HullGrowth {
 public:
  HullGrowth(const Wrenches& wrenches, const StartSimplex& start, double rounding);

  void run();

  // Writes the facets' normals, offsets and corners.
  void write(PointHull& hull) const;

 private:
  void share_out(int first, std::span<const int> facets);
  void add_farthest(int facet);

  const Wrenches& wrenches_;
  ExpandingPolytope polytope_;
  std::vector<int> columns_;         // of the polytope's points
  std::vector<int> next_;            // column in the list that a column is in; -1: it is the last
  std::vector<OutsideSet> outside_;  // of each facet
  // Facets with columns outside, those with the highest on top. An entry whose facet was replaced
  // since is recognised by its height.
  std::vector<std::pair<double, int>> heap_;
};

int column_of(const Wrenches& wrenches, const Wrench& point) {
  int column = 0;
  while (wrenches.col(column) != point) {
    ++column;
    assert(column < wrenches.cols());
  }
  return column;
}

HullGrowth::HullGrowth(const Wrenches& wrenches, const StartSimplex& start, double rounding)
    : wrenches_(wrenches) {
  polytope_.start(start.points, start.scale, rounding, ExpandingPolytope::Planes::shared);
  polytope_.set_bound(-std::numeric_limits<double>::infinity());  // nearest() is not needed
  for (const Wrench& corner : start.points) columns_.push_back(column_of(wrenches, corner));
  const int count = static_cast<int>(wrenches.cols());
  for (int column = 0; column < count; ++column) {
    next_.push_back(column + 1 < count ? column + 1 : -1);
  }
  const std::array<int, 7> facets = {0, 1, 2, 3, 4, 5, 6};
  outside_.resize(facets.size());
  share_out(0, facets);
}

// Gives each column of the list to the first of the facets that sees it.
void HullGrowth::share_out(int first, std::span<const int> facets) {
  for (int column = first; column >= 0;) {
    const int next = next_[index(column)];
    const Wrench point = wrenches_.col(column);
    for (const int facet : facets) {
      const double height = polytope_.height(facet, point);
      if (height <= polytope_.rounding()) continue;
      OutsideSet& outside = outside_[index(facet)];
      next_[index(column)] = std::exchange(outside.first, column);
      if (height > outside.height) {
        outside.height = height;
        outside.farthest = column;
        heap_.emplace_back(height, facet);
        std::push_heap(heap_.begin(), heap_.end());
      }
      break;
    }
    column = next;
  }
}

void HullGrowth::run() {
  while (!heap_.empty()) {
    const auto [height, facet] = heap_.front();
    std::pop_heap(heap_.begin(), heap_.end());
    heap_.pop_back();
    if (height == outside_[index(facet)].height) add_farthest(facet);
  }
}

void HullGrowth::add_farthest(int facet) {
  const int column = outside_[index(facet)].farthest;
  if (!polytope_.expand(facet, wrenches_.col(column))) {
    // Rounding prevents it. The facet's columns are given up, and the proof tells what that costs.
    outside_[index(facet)] = {};
    return;
  }
  columns_.push_back(column);
  outside_.resize(index(polytope_.facet_end()));
  for (const int replaced : polytope_.replaced()) {
    share_out(std::exchange(outside_[index(replaced)], {}).first, polytope_.made());
  }
}

void HullGrowth::write(PointHull& hull) const {
  std::vector<int> facets;
  for (int facet = 0; facet < polytope_.facet_end(); ++facet) {
    if (polytope_.exists(facet)) facets.push_back(facet);
  }
  const auto count = static_cast<Eigen::Index>(facets.size());
  hull.normals.resize(6, count);
  hull.offsets.resize(count);
  hull.corners.resize(6, count);
  for (Eigen::Index f = 0; f < count; ++f) {
    const int facet = facets[index(f)];
    hull.normals.col(f) = polytope_.plane(facet).normal;
    hull.offsets[f] = polytope_.plane(facet).offset;
    for (Eigen::Index i = 0; i < 6; ++i) {
      hull.corners(i, f) = columns_[index(polytope_.corners(facet)[index(i)])];
    }
  }
}

}  // namespace

PointHull quickhull(const Wrenches& wrenches, const StartSimplex& start) {
  PointHull hull;
  for (const double rounding : kRoundings) {
    HullGrowth growth(wrenches, start, rounding);
    growth.run();
    growth.write(hull);
    const std::optional<double> volume = proved_volume(wrenches, hull);
    if (!volume) continue;
    hull.status = PointHullStatus::solid;
    hull.volume = *volume;
    hull.reach = wrenches.colwise().norm().maxCoeff();
    return hull;
  }
  PointHull failed;
  failed.status = PointHullStatus::failed;
  failed.message = "quickhull: not proved";
  return failed;
}

}  // namespace prehend
