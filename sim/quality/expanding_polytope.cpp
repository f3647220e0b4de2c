#include "sim/quality/expanding_polytope.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace prehend {
namespace {

// A new plane is refitted to its corners where it misses one of them by more than this multiple of
// the rounding of heights,
constexpr double kRefit = 0.25;
// or where the two planes combined in it almost cancel each other.
constexpr double kCancellation = 1e-4;
// Below this nothing is left of them, and one of the two serves as a guess.
constexpr double kOpposite = 1e-14;

// Where `corner` is among a facet's corners (it is one of them). Without branches: which of the six
// it is cannot be predicted, and this is the innermost step of linking.
int position(const std::array<int, 6>& corners, int corner) {
  int at = 0;
  for (int i = 1; i < 6; ++i)
    at += i * static_cast<int>(corners[static_cast<std::size_t>(i)] == corner);
  return at;
}

}  // namespace

ExpandingPolytope::ExpandingPolytope(const std::array<Wrench, 7>& corners, double scale)
    : rounding_(kRounding * scale), points_(corners.begin(), corners.end()) {
  facets_.reserve(512);
  points_.reserve(64);
  for (int without = 0; without < 7; ++without) {
    Facet& facet = facets_[index(make_facet())];
    int slot = 0;
    Wrench centre = Wrench::Zero();
    for (int corner = 0; corner < 7; ++corner) {
      if (corner == without) continue;
      // Facet `corner` lacks that corner, so it lies across the ridge opposite it.
      facet.beyond[index(slot)] = side_of(corner, without < corner ? without : without - 1);
      facet.corners[index(slot++)] = corner;
      centre += corners[index(corner)] / 6.0;
    }
    facet.plane = fit_plane(centre - corners[index(without)], corners_of(facet)).plane;
  }
  for (int facet = 0; facet < 7; ++facet) offer(facet);
}

FacetCorners ExpandingPolytope::corners_of(const Facet& facet) const {
  FacetCorners corners;
  for (std::size_t i = 0; i < 6; ++i) corners[i] = &points_[index(facet.corners[i])];
  return corners;
}

int ExpandingPolytope::make_facet() {
  ++facets_made_;
  if (free_.empty()) {
    facets_.emplace_back();
    return static_cast<int>(facets_.size()) - 1;
  }
  const int facet = free_.back();
  free_.pop_back();
  facets_[index(facet)].visit = 0;
  facets_[index(facet)].visible = false;
  return facet;
}

void ExpandingPolytope::offer(int facet) {
  const double offset = facets_[index(facet)].plane.offset;
  if (offset >= bound_) return;
  heap_.emplace_back(offset, facet);
  std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
}

ExpandingPolytope::Nearest ExpandingPolytope::nearest() {
  while (!heap_.empty()) {
    const auto [offset, facet] = heap_.front();
    // A reused slot with the same offset is a facet all the same.
    if (offset == facets_[index(facet)].plane.offset) return {facet, facets_[index(facet)].plane};
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    heap_.pop_back();
  }
  return {};
}

bool ExpandingPolytope::is_corner(const Wrench& point) const {
  return std::find(points_.begin(), points_.end(), point) != points_.end();
}

bool ExpandingPolytope::sees(int facet, const Wrench& point) {
  Facet& f = facets_[index(facet)];
  f.visit = visit_;
  f.height = f.plane.normal.dot(point) - f.plane.offset;
  f.visible = f.height > rounding_;
  return f.visible;
}

// Finds the facets that `point` sees, from `facet` on, and the sides of them across which lies one
// that it does not see.
void ExpandingPolytope::collect_visible(int facet, const Wrench& point) {
  ++visit_;
  visible_.clear();
  border_.clear();
  if (sees(facet, point)) visible_.push_back(facet);
  for (std::size_t k = 0; k < visible_.size(); ++k) {
    const int at = visible_[k];
    for (int corner = 0; corner < 6; ++corner) {
      const int across = facet_of(facets_[index(at)].beyond[index(corner)]);
      const Facet& neighbour = facets_[index(across)];
      if (neighbour.visit != visit_ && sees(across, point)) {
        visible_.push_back(across);
      } else if (!neighbour.visible) {
        border_.push_back(side_of(at, corner));
      }
    }
  }
}

// The plane of a child contains the ridge and the point: a combination of the planes of the two
// facets that share the ridge. The weights are not negative, so that its offset is at least the
// smaller of theirs.
int ExpandingPolytope::make_child(Side border, int point) {
  const int made = make_facet();
  const int side = corner_of(border);
  Facet& child = facets_[index(made)];
  Facet& seen = facets_[index(facet_of(border))];
  const Side across = seen.beyond[index(side)];
  Facet& hidden = facets_[index(facet_of(across))];
  child.corners = seen.corners;
  child.corners[index(side)] = point;
  child.beyond.fill(kUnlinked);
  child.beyond[index(side)] = across;
  hidden.beyond[index(corner_of(across))] = side_of(made, side);
  seen.beyond[index(side)] = -1 - made;

  const double hidden_weight = seen.height;
  const double seen_weight = std::max(-hidden.height, 0.0);
  Wrench normal = (hidden_weight * hidden.plane.normal + seen_weight * seen.plane.normal) /
                  (hidden_weight + seen_weight);
  const double length = normal.norm();
  if (length < kOpposite) normal = seen.plane.normal;
  const FacetCorners corners = corners_of(child);
  FittedPlane fitted = fit_offset(normal, corners);
  if (fitted.spread > kRefit * rounding_ || length < kCancellation) {
    fitted = fit_plane(fitted.plane.normal, corners);
  }
  child.plane = fitted.plane;
  return made;
}

// Joins the child over a ridge of the border to its neighbours: around each edge of the ridge, the
// facets that see the point form a fan, at whose other end is the next ridge of the border.
void ExpandingPolytope::link_child(Side border) {
  const int side = corner_of(border);
  const int parent = facet_of(border);
  const int child = -1 - facets_[index(parent)].beyond[index(side)];
  for (int k = 0; k < 6; ++k) {
    if (facets_[index(child)].beyond[index(k)] != kUnlinked) continue;
    const Facet* at = &facets_[index(parent)];
    int swinging = side;  // the corner that completes the edge to the ridge of the fan crossed last
    int leave = k;
    while (at->beyond[index(leave)] >= 0) {
      const Side next = at->beyond[index(leave)];
      const int pivot = at->corners[index(swinging)];
      at = &facets_[index(facet_of(next))];
      leave = position(at->corners, pivot);
      swinging = corner_of(next);
    }
    const int other = -1 - at->beyond[index(leave)];
    facets_[index(child)].beyond[index(k)] = side_of(other, swinging);
    facets_[index(other)].beyond[index(swinging)] = side_of(child, k);
  }
}

bool ExpandingPolytope::expand(int facet, const Wrench& point) {
  if (is_corner(point)) return false;
  collect_visible(facet, point);
  if (border_.empty()) {
    for (const int seen : visible_) facets_[index(seen)].visible = false;
    return false;
  }
  const int corner = static_cast<int>(points_.size());
  points_.push_back(point);
  for (const Side border : border_) offer(make_child(border, corner));
  for (const Side border : border_) link_child(border);
  for (const int seen : visible_) {
    facets_[index(seen)].plane.offset = std::numeric_limits<double>::quiet_NaN();
    free_.push_back(seen);
  }
  return true;
}

}  // namespace prehend
