// The smallest contact forces that balance a wrench, by a barrier in the multipliers.
#pragma once

#include "sim/quality/force_balance.h"

namespace prehend {

// Solves the same problem as ForceProgram where that is not degenerate, in much less time: there
// are six multipliers of the balance and one for each joint limit, however many contacts there are,
// so that the time grows in proportion to these. Tolerances as in `options`.
//
// Where contacts cannot act in some direction, or rounding stands in the way, what is returned is
// worse than the tolerances ask for, as the checks of ForceBalance show. The components are in the
// friction cones in any case. Source: the logarithmic barrier method, Boyd and Vandenberghe, Convex
// Optimization, 2004, sections 11.3 and 11.6.
ProposedForces barrier_forces(const ForceBalance& balance, const ForceOptions& options);

// Forces that balance as large a part of the wrench as they can, at most the whole: minimises the
// measure plus `price` times the part that is missing. The price has to be much larger than the
// measure. Their residual is that part.
ProposedForces partial_forces(const ForceBalance& balance, const ForceOptions& options,
                              double price);

}  // namespace prehend
