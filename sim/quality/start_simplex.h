// Seven wrenches of a convex set that span six dimensions, or the proof that there are none.
#pragma once

#include <array>

#include "sim/quality/support.h"

namespace prehend {

// Where wrench space ends numerically. A set thinner than this in some direction, relative to its
// size, is flat: the largest ball inside it is indistinguishable from a point.
inline constexpr double kFlatness = 1e-9;

struct StartSimplex {
  bool flat = true;    // `points` mean nothing
  double scale = 0.0;  // largest coordinate, in magnitude, of any point of the set
  // Upper bound of the largest ball around the origin: the smallest support value seen. At or below
  // kFlatness * scale it proves that there is none.
  double upper = 0.0;
  Wrench upper_normal = Wrench::Zero();  // unit direction of `upper`
  std::array<Wrench, 7> points = {};     // affinely independent unless `flat`
};

// Asks for support along the six axes both ways, and where these points span less than six
// dimensions, along directions orthogonal to what they span. With `stop_outside` it returns at
// once, as flat, where a direction proves that the origin is not inside.
StartSimplex start_simplex(const SupportMap& set, bool stop_outside);

}  // namespace prehend
