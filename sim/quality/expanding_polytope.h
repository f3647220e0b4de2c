// A polytope that grows, point by point, inside a convex set: the data structure of the expanding
// polytope algorithm in epsilon.cpp, and of quickhull.cpp.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "sim/base/index.h"
#include "sim/quality/hyperplane.h"

namespace prehend {

// A closed surface of simplices (facets, with as many corners as there are dimensions): up to
// rounding, the boundary of the convex hull of the points added so far. Two neighbouring facets
// share a ridge, the simplex of all corners but one. In six dimensions and in three.
//
// Whatever the rounding, the following holds. Every ridge is shared by exactly two facets. With
// Planes::below_corners no point of a facet is nearer to the origin than the facet's offset, if
// that is positive. A surface that encloses the origin, with all offsets positive, keeps enclosing
// it, because points are added only beyond facets that have the origin behind them. The smallest
// offset is therefore the radius of a ball inside the hull of the points, even where rounding has
// made the surface slightly non-convex.
template <int Dimension>
class PolytopeIn {
 public:
  static_assert(Dimension <= 8);  // for side_of
  using Point = Eigen::Vector<double, Dimension>;
  using Plane = HyperplaneIn<Dimension>;
  using Corners = std::array<int, static_cast<std::size_t>(Dimension)>;

  // Rounding error of a point's height above a plane, relative to the scale: a point no higher than
  // this above a facet's plane counts as one that does not see the facet.
  static constexpr double kRounding = 1e-14;

  // How the planes of new facets are made.
  enum class Planes {
    // So that no corner is below the plane of its facet: the offset is a lower bound of the
    // distance between the facet and the origin.
    below_corners,
    // Facets that are in one plane up to the rounding have the same plane, bit by bit: a new facet
    // takes over that of its hidden neighbour where the point is in it. Of such facets a point sees
    // all or none, and no new facet folds back over them.
    shared,
  };

  // Makes it the simplex of `corners`, which are affinely independent, in the memory that it has.
  // `scale` is the set's largest coordinate, `rounding` the height relative to it that counts as
  // rounding. To be called before anything else.
  void start(const std::array<Point, static_cast<std::size_t>(Dimension) + 1>& corners,
             double scale, double rounding = kRounding, Planes planes = Planes::below_corners);

  // Lets nearest() ignore facets with an offset of `bound` or more. The bound must only decrease:
  // facets ignored once are not kept for later.
  void set_bound(double bound) { bound_ = bound; }

  // A facet and its plane.
  struct Nearest {
    int facet = -1;  // -1: no facet has an offset below the bound
    Plane plane;
  };
  // The facet with the smallest (signed) offset.
  Nearest nearest();

  // Adds a point: the facets that it sees, `facet` among them, are replaced by new facets that join
  // the point to each ridge on the border of the seen region. Returns false and changes nothing
  // where rounding leaves that region without a border, or where the point is already a corner.
  bool expand(int facet, const Point& point);

  // How many facets were made so far, those replaced since included.
  int facets_made() const { return facets_made_; }

  // The facets that the last expansion has replaced, and those that it has made. The number of a
  // facet that was replaced is used again by later expansions.
  std::span<const int> replaced() const { return visible_; }
  std::span<const int> made() const { return made_; }

  // Numbers of facets are below this. Some may be those of replaced facets.
  int facet_end() const { return static_cast<int>(facets_.size()); }
  bool exists(int facet) const { return !std::isnan(plane(facet).offset); }
  const Plane& plane(int facet) const { return facets_[index(facet)].plane; }
  // Points are numbered in the order in which they were added, from 0: those of start() first.
  const Corners& corners(int facet) const { return facets_[index(facet)].corners; }

  // Height above the facet's plane. The facet sees points that are higher than rounding().
  double height(int facet, const Point& point) const {
    return plane(facet).normal.dot(point) - plane(facet).offset;
  }
  double rounding() const { return rounding_; }

 private:
  // A side of a facet is the ridge opposite one of its corners, stored as one number,
  // 8 facet + corner. While a facet is being replaced, a negative number stands for a side that
  // already has its new facet: -1 - (index of the new facet over that ridge).
  using Side = int;
  static Side side_of(int facet, int corner) { return 8 * facet + corner; }
  static int facet_of(Side side) { return side >> 3; }
  static int corner_of(Side side) { return side & 7; }
  static constexpr Side kUnlinked = -1;

  struct Facet {
    Plane plane;              // offset NaN: the facet was replaced, and its slot is free
    double height = 0.0;      // height above the plane of the point that is being added
    std::uint32_t visit = 0;  // number of the addition for which `height` was computed
    bool visible = false;     // whether that point sees the facet
    Corners corners = {};
    Corners beyond = {};  // the neighbour's side of the ridge opposite corner i
  };

  CornersIn<Dimension> corners_of(const Facet& facet) const;
  Plane plane_between(const Facet& seen, const Facet& hidden,
                      const CornersIn<Dimension>& corners) const;
  bool sees(int facet, const Point& point);
  void collect_visible(int facet, const Point& point);
  int make_facet();
  int make_child(Side border, int point);
  void link_child(Side border);
  void offer(int facet);
  bool is_corner(const Point& point) const;

  double rounding_ = 0.0;
  Planes planes_ = Planes::below_corners;
  double bound_ = std::numeric_limits<double>::infinity();
  std::vector<Point> points_;
  std::vector<Facet> facets_;
  std::vector<int> free_;
  std::vector<std::pair<double, int>> heap_;  // offsets; entries of replaced facets are stale
  std::vector<int> visible_;
  std::vector<Side> border_;
  std::vector<int> made_;
  std::uint32_t visit_ = 0;
  int facets_made_ = 0;
};

using ExpandingPolytope = PolytopeIn<6>;

}  // namespace prehend
