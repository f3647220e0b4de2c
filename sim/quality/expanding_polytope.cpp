#include "sim/quality/expanding_polytope.h"

#include <algorithm>
#include <cmath>
#include <functional>

// The facets lie in one array and refer to each other by index; each knows its neighbour across
// every ridge. Adding a point goes in three steps: a flood fill from the facet that is expanded
// finds the connected region of facets that see the point, and the ridges on its border; each of
// these ridges and the point make a new facet ("child"); the children are linked to each other by
// walking through the facets that are about to go. Searching the border instead of testing every
// facet makes the surface closed whatever rounding does to the single tests. Slots of replaced
// facets are used again.
namespace prehend {
namespace {

// A new plane is fitted to its corners where the two planes combined in it almost cancel each
// other,
constexpr double kCancellation = 1e-4;
constexpr double kCancellationShared = 1e-2;
// or, below its corners, where it misses one by more than this multiple of the rounding of heights.
constexpr double kRefit = 0.25;
// Below this nothing is left of them, and one of the two serves as a guess.
constexpr double kOpposite = 1e-14;

// The position of `corner` among a facet's corners (it must be one of them). A sum without branches
// is faster than a search: which of them it is cannot be predicted, and this is the innermost
// step of linking.
template <std::size_t count>
int position(const std::array<int, count>& corners, int corner) {
  int at = 0;
  for (int i = 1; i < static_cast<int>(count); ++i)
    at += i * static_cast<int>(corners[static_cast<std::size_t>(i)] == corner);
  return at;
}

}  // namespace

template <int Dimension>
void PolytopeIn<Dimension>::start(
    const std::array<Point, static_cast<std::size_t>(Dimension) + 1>& corners, double scale,
    double rounding, Planes planes) {
  rounding_ = rounding * scale;
  planes_ = planes;
  bound_ = std::numeric_limits<double>::infinity();
  facets_.clear();
  facets_.reserve(512);
  free_.clear();
  heap_.clear();
  visit_ = 0;
  facets_made_ = 0;
  points_.reserve(64);
  points_.assign(corners.begin(), corners.end());
  // Facet i of the simplex is the one opposite corner i.
  for (int without = 0; without <= Dimension; ++without) {
    Facet& facet = facets_[index(make_facet())];
    int slot = 0;
    Point centre = Point::Zero();
    for (int corner = 0; corner <= Dimension; ++corner) {
      if (corner == without) continue;
      // Facet `corner` lacks that corner, so it lies across the ridge opposite it.
      facet.beyond[index(slot)] = side_of(corner, without < corner ? without : without - 1);
      facet.corners[index(slot++)] = corner;
      centre += corners[index(corner)] / Dimension;
    }
    // The direction from the opposite corner to the facet's centre points outward.
    facet.plane = fit_plane<Dimension>(centre - corners[index(without)], corners_of(facet)).plane;
  }
  for (int facet = 0; facet <= Dimension; ++facet) offer(facet);
}

template <int Dimension>
CornersIn<Dimension> PolytopeIn<Dimension>::corners_of(const Facet& facet) const {
  CornersIn<Dimension> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = &points_[index(facet.corners[i])];
  return corners;
}

template <int Dimension>
int PolytopeIn<Dimension>::make_facet() {
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

// The heap has the smallest offset on top. An entry whose facet has been replaced since stays in it
// until it comes to the top (lazy deletion), where nearest() recognises it by its offset.
template <int Dimension>
void PolytopeIn<Dimension>::offer(int facet) {
  const double offset = facets_[index(facet)].plane.offset;
  if (offset >= bound_) return;
  heap_.emplace_back(offset, facet);
  std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
}

template <int Dimension>
typename PolytopeIn<Dimension>::Nearest PolytopeIn<Dimension>::nearest() {
  while (!heap_.empty()) {
    const auto [offset, facet] = heap_.front();
    // The offset of a replaced facet is NaN, which equals nothing. If the slot was used again for a
    // facet with the same offset, that facet is as good an answer.
    if (offset == facets_[index(facet)].plane.offset) return {facet, facets_[index(facet)].plane};
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    heap_.pop_back();
  }
  return {};
}

template <int Dimension>
bool PolytopeIn<Dimension>::is_corner(const Point& point) const {
  return std::find(points_.begin(), points_.end(), point) != points_.end();
}

// Also stores the height above the facet's plane, from which make_child weighs the planes.
template <int Dimension>
bool PolytopeIn<Dimension>::sees(int facet, const Point& point) {
  Facet& f = facets_[index(facet)];
  f.visit = visit_;
  f.height = height(facet, point);
  f.visible = f.height > rounding_;
  return f.visible;
}

// Flood fill from `facet`: fills visible_ with the connected facets that `point` sees, and border_
// with those of their sides across which lies a facet that it does not see. Each facet is tested
// once for a point, so that all its neighbours are told the same.
template <int Dimension>
void PolytopeIn<Dimension>::collect_visible(int facet, const Point& point) {
  ++visit_;
  visible_.clear();
  border_.clear();
  if (sees(facet, point)) visible_.push_back(facet);
  for (std::size_t k = 0; k < visible_.size(); ++k) {
    const int at = visible_[k];
    for (int corner = 0; corner < Dimension; ++corner) {
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

// The plane of the facet that joins the point to the ridge between these two.
//
// All planes through the ridge are combinations of those of the two facets that share it; the point
// lies at height h_s > 0 above the seen facet's plane and h_h <= 0 below the hidden one's, so h_s
// (hidden plane) - h_h (seen plane) has it at height 0. That costs a few products, where a fit to
// all corners would need an orthogonalisation. No weight is negative, so the new offset is at least
// the smaller of the two: the lower bound of epsilon does not fall. And what is below both planes
// is below the new one, even where the facet is so thin that its corners do not determine a plane.
// A fit to them would lose that.
template <int Dimension>
typename PolytopeIn<Dimension>::Plane PolytopeIn<Dimension>::plane_between(
    const Facet& seen, const Facet& hidden, const CornersIn<Dimension>& corners) const {
  const bool shared = planes_ == Planes::shared;
  if (shared && -hidden.height <= rounding_) return hidden.plane;
  // A hidden facet may be below the point by no more than rounding, hence the maximum with 0.
  const double hidden_weight = seen.height;
  const double seen_weight = std::max(-hidden.height, 0.0);
  Point normal = (hidden_weight * hidden.plane.normal + seen_weight * seen.plane.normal) /
                 (hidden_weight + seen_weight);
  const double length = normal.norm();
  if (length < kOpposite) normal = seen.plane.normal;
  const FittedPlane<Dimension> fitted = fit_offset<Dimension>(normal, corners);
  const bool cancels = length < (shared ? kCancellationShared : kCancellation);
  const bool misses = !shared && fitted.spread > kRefit * rounding_;
  return cancels || misses ? fit_plane<Dimension>(fitted.plane.normal, corners).plane
                           : fitted.plane;
}

// Makes the facet that joins the point to one ridge of the border, and links it to the neighbour
// across that ridge.
template <int Dimension>
int PolytopeIn<Dimension>::make_child(Side border, int point) {
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
  child.plane = plane_between(seen, hidden, corners_of(child));
  return made;
}

// Links the child over a ridge of the border to the children next to it. Leave out
// one corner of the ridge, and those that remain are shared by a fan of seen facets that turn
// around them, from this ridge to another one of the border. The child over that other ridge has
// these corners and the point in common with this child, and is its neighbour. The walk goes
// through the fan, across one ridge after the other, until it meets a side that already has its
// child.
template <int Dimension>
void PolytopeIn<Dimension>::link_child(Side border) {
  const int side = corner_of(border);
  const int parent = facet_of(border);
  const int child = -1 - facets_[index(parent)].beyond[index(side)];
  for (int k = 0; k < Dimension; ++k) {
    if (facets_[index(child)].beyond[index(k)] != kUnlinked) continue;
    const Facet* at = &facets_[index(parent)];
    int swinging = side;  // corner of `at` that is opposite the ridge crossed last
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

template <int Dimension>
bool PolytopeIn<Dimension>::expand(int facet, const Point& point) {
  if (is_corner(point)) return false;
  collect_visible(facet, point);
  // Either no facet sees the point, or by rounding all of them do, and nothing is left to join.
  if (border_.empty()) {
    for (const int seen : visible_) facets_[index(seen)].visible = false;
    return false;
  }
  const int corner = static_cast<int>(points_.size());
  points_.push_back(point);
  made_.clear();
  for (const Side border : border_) {
    made_.push_back(make_child(border, corner));
    offer(made_.back());
  }
  for (const Side border : border_) link_child(border);
  for (const int seen : visible_) {
    facets_[index(seen)].plane.offset = std::numeric_limits<double>::quiet_NaN();
    free_.push_back(seen);
  }
  return true;
}

template class PolytopeIn<3>;
template class PolytopeIn<6>;

}  // namespace prehend
