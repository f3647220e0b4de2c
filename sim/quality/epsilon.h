// Epsilon, the radius of the largest ball around the origin inside a convex set of wrenches: the
// smallest disturbance that the grasp cannot resist. Computed without the set's full convex hull.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "sim/base/named_enum.h"
#include "sim/base/settings.h"
#include "sim/quality/contact_map.h"

namespace prehend {

class SupportMap;

// How the search for epsilon ended.
enum class EpsilonStatus {
  converged,         // force closure; upper - lower <= tolerance * upper, or is rounding
  no_force_closure,  // proved: some direction has no support above zero, or the set is flat
  below_cutoff,      // upper fell below the caller's cutoff; lower is what was proved until then
  limit,             // facets used up; the bracket stands
  stalled,           // rounding leaves no better polytope; the bracket stands. From epsilon_l1 only
                     // where the full hull brings the bounds no closer either
};

// The enumerator's name, as it is written in files.
constexpr auto enum_names(EpsilonStatus /*of*/) {
  return std::to_array<std::string_view>(
      {"converged", "no_force_closure", "below_cutoff", "limit", "stalled"});
}

struct EpsilonOptions {
  static constexpr AboutSettings kAbout{"EpsilonOptions", "When the search for epsilon stops."};
  // A difference of 2e-14 of the set's largest coordinate counts as rounding and is accepted in any
  // case.
  double relative_tolerance = 1e-9;
  double cutoff = 0.0;
  int max_facets = 200000;
  // They save facets on smooth sets, where the normal of the nearest facet only approximates the
  // direction of the smallest support value. On a polytope that direction is the normal of one of
  // its facets, which the search finds exactly, and 0 steps are best.
  int descent_steps = 0;
};

template <SettingsOf<EpsilonOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [relative_tolerance, cutoff, max_facets, descent_steps] = options;
  visit("relative_tolerance", relative_tolerance, kRatio, "",
        "The search has converged when upper - lower is at most this part of upper.");
  visit("cutoff", cutoff, kAtLeast0, "",
        "Stop as soon as the upper bound is below this: for callers who rank and know a better "
        "grasp.");
  visit("max_facets", max_facets, kCount, "",
        "Most facets made in all; checked before each expansion, which may exceed it.");
  visit("descent_steps", descent_steps, kCount, "",
        "Steps of gradient descent on the support function from each new upper bound; they pay on "
        "smooth sets.");
}

// Bounds of epsilon: lower <= epsilon <= upper, in the units of the set (for a grasp wrench space,
// those of the unit normal force). Without force closure both are 0.
struct EpsilonBracket {
  double lower = 0.0;
  double upper = 0.0;
  EpsilonStatus status = EpsilonStatus::no_force_closure;
  // The disturbance that the grasp resists least: -upper times the unit direction in which the
  // support value `upper` was found.
  Wrench weakest = Wrench::Zero();

  // Whether force closure was proved, which a search stopped early can have done already.
  bool force_closure() const { return lower > 0.0; }
};

// Epsilon of a set given by its support function. Grows a polytope inside the set from an inner
// simplex, and repeatedly expands the facet nearest to the origin until the set does not reach
// beyond it: the expanding polytope algorithm (van den Bergen 2001), in six dimensions. The
// smallest support value seen is the upper bound, the smallest facet offset the lower one.
// Deterministic.
//
// A set whose smallest support value is below kFlatness (1e-9) of its size counts as one without
// force closure. The squares of the coordinates must neither overflow nor underflow: sizes from
// 1e-150 to 1e150. epsilon_l1 accepts any size.
// Throws InputError for a tolerance that is negative or not a number.
EpsilonBracket epsilon(const SupportMap& set, const EpsilonOptions& options = {});

// Epsilon of the convex hull of the columns of `wrenches` (6 x n), which is the hull's smallest
// facet offset: Ferrari and Canny's L1 measure (ICRA 1992) when the columns are those of
// contact_wrenches. Where rounding stalls the growth, the facets of the full hull (wrench_hull)
// give the bounds. No columns: no force closure. Throws InputError for a column that is not finite,
// and for a tolerance as epsilon does.
EpsilonBracket epsilon_l1(const Eigen::Ref<const Wrenches>& wrenches,
                          const EpsilonOptions& options = {});

}  // namespace prehend
