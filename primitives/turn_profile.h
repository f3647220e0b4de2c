// The outline of what turns about an axis.
#pragma once

#include <array>
#include <span>

#include "primitives/turn_axis.h"

namespace prehend {

// The outer radius along an axis, in steps of equal length.
struct TurnProfile {
  static constexpr std::size_t kSteps = 80;

  double low = 0.0;                        // along the axis, where the first step begins
  double step = 0.0;                       // length of each
  std::array<double, kSteps> radius = {};  // in the middle of each
  // What it counts: the share of the whole surface, of `whole` points, that lies there, and part of
  // its length, since hands close on a thin stem as well as on what it carries. 0: the surface is
  // no circle there.
  std::array<double, kSteps> share = {};

  double at(std::size_t border) const { return low + step * static_cast<double>(border); }
};

TurnProfile turn_profile(const TurnAxis& axis, std::span<const SurfacePoint> points,
                         std::size_t whole);

// The axis near this one from which the points of the profile have its radius most closely
// (Gauss-Newton). Positions are better known than normals, which noise turns.
TurnAxis centered(const TurnAxis& axis, const TurnProfile& profile,
                  std::span<const SurfacePoint> points);

}  // namespace prehend
