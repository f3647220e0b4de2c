// The full convex hull of wrenches: its volume, and an independent computation of epsilon.
#pragma once

#include "sim/quality/point_hull.h"
#include "sim/quality/wrench.h"

namespace prehend {

// Of friction pyramids with more edges the full hull of a grasp of a few contacts takes qhull,
// where it has to be asked, a minute and more: set_hull bounds its volume in about a second.
inline constexpr int kMostHullEdges = 16;

enum class HullStatus {
  solid,  // a hull with volume
  flat,   // the wrenches do not span six dimensions: no volume, no force closure
};

struct WrenchHull {
  HullStatus status = HullStatus::flat;
  double min_offset = 0.0;  // smallest signed facet offset: negative when the origin is outside
  double volume = 0.0;      // of the 6-D hull; 0 or infinite where no double is as small or large
  // -min_offset * unit normal of that facet (solid only): with force closure, the disturbance that
  // the grasp resists least.
  Wrench weakest = Wrench::Zero();
  // The numerical error of min_offset, which it must exceed to prove that the origin is inside:
  // kFlatness times the size of the wrenches, more where qhull had to joggle them.
  double doubt = 0.0;
  PointHull points;  // the facets, where it is solid

  bool force_closure() const { return status == HullStatus::solid && min_offset > doubt; }
};

// Wrenches thinner than kFlatness times their size in some direction are flat. The hull of others
// comes from quickhull(). Where that cannot prove its result (the wrenches are nearly flat), it
// comes from qhull, and where qhull fails (near-duplicates), from qhull with joggled input (QJ); a
// joggled hull shows force closure only beyond the joggle.
//
// Thread-safe. Throws InputError on a value that is not finite,
// std::runtime_error (with qhull's message) where qhull fails for another reason than flatness.
WrenchHull wrench_hull(const Wrenches& wrenches);

}  // namespace prehend
