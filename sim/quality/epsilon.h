// The largest ball around the origin inside the convex hull of wrenches, without the hull.
#pragma once

#include "sim/quality/wrench.h"

namespace prehend {

enum class EpsilonStatus {
  converged,         // force closure; upper - lower <= tolerance * upper
  no_force_closure,  // proved: some direction has no support above zero, or the hull is flat
  below_cutoff,      // upper fell below the caller's cutoff; lower is what was proved until then
  limit,             // iterations used up; the bracket stands
};

struct EpsilonOptions {
  double relative_tolerance = 1e-9;
  double cutoff = 0.0;         // stop as soon as the upper bound is below this
  int max_facets = 200000;     // facets made before giving up
};

// lower <= epsilon <= upper. Without force closure both are 0.
struct EpsilonBracket {
  double lower = 0.0;
  double upper = 0.0;
  EpsilonStatus status = EpsilonStatus::no_force_closure;
  // The disturbance that the grasp resists least: -upper * (unit normal of the nearest facet).
  Wrench weakest = Wrench::Zero();
};

// Ferrari and Canny's L1 measure of the hull of the columns of `wrenches`: grows a polytope from an
// inner simplex and expands the facet nearest to the origin until it is final (the expanding polytope
// algorithm, van den Bergen 2001, in six dimensions). Columns must be finite.
EpsilonBracket epsilon_l1(const Wrenches& wrenches, const EpsilonOptions& options = {});

}  // namespace prehend
