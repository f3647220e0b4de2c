// The smallest forces of many contacts that balance a wrench.
#pragma once

#include "sim/quality/force_balance.h"

namespace prehend {

// Forces, and the multipliers that bound the measure of all others from below
// (ForceBalance::lower_bound). Where no forces were found that balance the wrench, the components
// are zero.
struct GeneratedForces {
  Eigen::Matrix4Xd components;
  ForceBalance::Separation separation;
};

// Solves the same problem as ForceProgram, but for a time that grows in proportion to the number of
// contacts where that of the program grows with its cube. For contacts without joint limits.
// `gap_tolerance` as in ForceOptions. Source: column generation (Dantzig and Wolfe 1960).
GeneratedForces generate_forces(const ForceBalance& balance, ForceMeasure measure,
                                double gap_tolerance);

}  // namespace prehend
