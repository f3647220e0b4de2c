// A polytope in wrench space that grows, point by point, inside a convex set.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "sim/base/index.h"
#include "sim/quality/hyperplane.h"

namespace prehend {

// A closed surface of 5-simplices (facets), the hull of the points added so far up to rounding.
//
// What holds whatever the rounding: every ridge is shared by exactly two facets; no point of a
// facet is nearer to the origin than the facet's offset, if that is positive; and a surface around
// the origin, all offsets positive, stays around it: what is added lies beyond facets that have the
// origin behind them. So the smallest offset is then the radius of a ball inside the hull of the
// points, even where rounding has dented the surface.
class ExpandingPolytope {
 public:
  // Rounding of heights, relative to the scale: points within it of a facet's plane do not see it.
  static constexpr double kRounding = 1e-14;

  // `corners` are affinely independent; `scale` is the set's largest coordinate.
  ExpandingPolytope(const std::array<Wrench, 7>& corners, double scale);

  // Facets with an offset from `bound` on need not be offered by nearest() any more.
  void set_bound(double bound) { bound_ = bound; }

  struct Nearest {
    int facet = -1;  // none has an offset below the bound: -1
    Hyperplane plane;
  };
  // The facet with the smallest (signed) offset.
  Nearest nearest();

  // Replaces the facets that `point` sees, `facet` among them, by the cone from `point` over their
  // border. Returns false, unchanged, where rounding leaves no border, or where the point is
  // already a corner of the polytope.
  bool expand(int facet, const Wrench& point);

  int facets_made() const { return facets_made_; }

 private:
  // A side of a facet, the ridge opposite one of its six corners, as one number: 8 facet + corner.
  // Negative while a facet is being replaced: -1 - the new facet over that ridge.
  using Side = int;
  static Side side_of(int facet, int corner) { return 8 * facet + corner; }
  static int facet_of(Side side) { return side >> 3; }
  static int corner_of(Side side) { return side & 7; }
  static constexpr Side kUnlinked = -1;

  struct Facet {
    Hyperplane plane;         // an offset that is not a number: the facet was replaced
    double height = 0.0;      // of the point being added above the plane
    std::uint32_t visit = 0;  // the addition for which `height` was computed
    bool visible = false;     // whether that point sees the facet
    std::array<int, 6> corners = {};
    std::array<Side, 6> beyond = {};  // the neighbour's side of the ridge opposite corner i
  };

  FacetCorners corners_of(const Facet& facet) const;
  bool sees(int facet, const Wrench& point);
  void collect_visible(int facet, const Wrench& point);
  int make_facet();
  int make_child(Side border, int point);
  void link_child(Side border);
  void offer(int facet);
  bool is_corner(const Wrench& point) const;

  double rounding_ = 0.0;
  double bound_ = std::numeric_limits<double>::infinity();
  std::vector<Wrench> points_;
  std::vector<Facet> facets_;
  std::vector<int> free_;
  std::vector<std::pair<double, int>> heap_;  // offsets; entries of replaced facets are stale
  std::vector<int> visible_;
  std::vector<Side> border_;
  std::uint32_t visit_ = 0;
  int facets_made_ = 0;
};

}  // namespace prehend
