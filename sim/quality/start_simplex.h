// Seven points of a convex set that span six dimensions, with which the growth of a polytope inside
// the set starts; or the proof that the set has no such points.
#pragma once

#include <array>

#include "sim/quality/support.h"

namespace prehend {

// A set thinner than this in some direction, relative to its size, counts as flat: the largest ball
// inside it cannot be told from a point.
inline constexpr double kFlatness = 1e-9;

struct StartSimplex {
  bool flat = true;    // no simplex was found, and `points` are not valid
  double scale = 0.0;  // largest coordinate, in magnitude, of any point of the set
  // Upper bound of the largest ball around the origin: the smallest support value seen. At or below
  // kFlatness * scale it proves that there is none.
  double upper = 0.0;
  Wrench upper_normal = Wrench::Zero();  // unit direction of `upper`
  std::array<Wrench, 7> points = {};     // affinely independent unless `flat`
};

// Finds the simplex from the support points along the six axes both ways, and, where these span
// less than six dimensions, along directions orthogonal to their span. With `stop_outside` it
// returns at once, as flat, where a direction proves that the origin is not inside the set.
StartSimplex start_simplex(const SupportMap& set, bool stop_outside);

}  // namespace prehend
