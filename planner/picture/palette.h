// What has which colour, in pictures, 3-D files and reports alike.
#pragma once

#include "planner/picture/color.h"

namespace prehend::palette {

inline constexpr Color kObject{0.80, 0.78, 0.70, 0.22};
inline constexpr Color kHard{0.45, 0.53, 0.63, 1.0};    // links of a hand that do not give way
inline constexpr Color kRubber{0.27, 0.31, 0.37, 1.0};  // links that do
inline constexpr Color kArm{0.87, 0.70, 0.36, 1.0};
inline constexpr Color kObstacle{0.72, 0.72, 0.72, 0.25};
inline constexpr Color kPrimitive{0.16, 0.55, 0.55, 0.30};
inline constexpr Color kContact{0.88, 0.13, 0.12, 1.0};
inline constexpr Color kWeakest{0.50, 0.16, 0.75, 1.0};
inline constexpr Color kText{0.15, 0.15, 0.18, 1.0};

}  // namespace prehend::palette
