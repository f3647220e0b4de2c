// The largest ball around the origin inside a convex set of wrenches, without its hull.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "sim/quality/support.h"
#include "sim/quality/wrench.h"

namespace prehend {

enum class EpsilonStatus {
  converged,         // force closure; upper - lower <= tolerance * upper, or is rounding
  no_force_closure,  // proved: some direction has no support above zero, or the set is flat
  below_cutoff,      // upper fell below the caller's cutoff; lower is what was proved until then
  limit,             // facets used up; the bracket stands
  stalled,           // rounding leaves no better polytope; the bracket stands. From epsilon_l1 only
                     // where qhull fails on the same wrenches
};

constexpr std::string_view epsilon_status_name(EpsilonStatus status) {
  constexpr std::array<std::string_view, 5> kNames = {"converged", "no_force_closure",
                                                      "below_cutoff", "limit", "stalled"};
  return kNames[static_cast<std::size_t>(status)];
}

struct EpsilonOptions {
  // Of upper - lower, >= 0. Differences of 2e-14 of the set's size are rounding, whatever is asked.
  double relative_tolerance = 1e-9;
  // Stop as soon as the upper bound is below this: for callers who rank and know a better grasp.
  double cutoff = 0.0;
  // Most facets; checked before each expansion.
  int max_facets = 200000;
  // Steps of descent on the support function from each new upper bound. They save facets on smooth
  // sets, where the normal of the nearest facet is only near the minimum; on a polytope the last
  // facet has the minimum as its normal, and they are not needed.
  int descent_steps = 0;
};

// lower <= epsilon <= upper. Without force closure both are 0.
struct EpsilonBracket {
  double lower = 0.0;
  double upper = 0.0;
  EpsilonStatus status = EpsilonStatus::no_force_closure;
  // The disturbance that the grasp resists least: -upper * (unit normal of the nearest facet).
  Wrench weakest = Wrench::Zero();

  // Whether force closure was proved: also before convergence.
  bool force_closure() const { return lower > 0.0; }
};

// Grows a polytope from an inner simplex and expands the facet nearest to the origin until it is
// final: the expanding polytope algorithm (van den Bergen 2001), in six dimensions. The smallest
// support value seen is the upper bound, the smallest facet offset the lower one. Deterministic.
//
// A set whose smallest support value is below kFlatness (1e-9) of its size has no force closure.
// The squares of its coordinates must neither overflow nor vanish: sizes from 1e-150 to 1e150.
// epsilon_l1 takes any size.
// Throws InputError for a tolerance that is negative or not a number.
EpsilonBracket epsilon(const SupportMap& set, const EpsilonOptions& options = {});

// Ferrari and Canny's L1 measure of the hull of the columns of `wrenches` (ICRA 1992): their hull's
// smallest facet offset. Where rounding stalls the growth, wrench_hull decides.
// No columns: no force closure. Throws InputError where a column is not finite.
EpsilonBracket epsilon_l1(const Wrenches& wrenches, const EpsilonOptions& options = {});

}  // namespace prehend
