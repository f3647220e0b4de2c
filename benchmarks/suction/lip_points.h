// The lips of cups as rings of points that lie on an object.
#pragma once

#include <vector>

#include "benchmarks/suction/hanging_object.h"

namespace prehend::bench {

inline constexpr int kLipPoints = 16;         // of each cup
inline constexpr double kPointRadius = 1e-3;  // of the ball that each is [m]

struct LipPoint {
  int cup = 0;
  Vector3 center_O = Vector3::Zero();
  double facing = 1.0;  // cosine between the axis of the cup and the surface's normal
};

// Where the rings meet the pieces along the axes of the cups, from twice the travel behind them, as
// cup_seal looks for it: balls that touch the object. In the order of the cups. Throws InputError
// where a ring is beside the pieces.
std::vector<LipPoint> lip_points(const std::vector<HangingCup>& cups,
                                 const std::vector<TriangleMesh>& pieces);

// How many times the weight the points bear before one comes off, if friction held and they were
// parallel springs that share it: each bears the pull of its cup, divided by its points. Infinite
// where the weight pulls at none.
double linear_margin(const HangingObject& object, const std::vector<LipPoint>& points);

}  // namespace prehend::bench
