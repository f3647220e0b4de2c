#include "sim/quality/epsilon.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/base/input_error.h"
#include "sim/quality/expanding_polytope.h"
#include "sim/quality/start_simplex.h"
#include "sim/quality/wrench_hull.h"
#include "sim/quality/wrench_size.h"

namespace prehend {
namespace {

void check(const EpsilonOptions& options) {
  if (!(options.relative_tolerance >= 0.0)) {
    throw InputError({.field = "relative_tolerance",
                      .problem = "must not be negative",
                      .value = std::to_string(options.relative_tolerance)});
  }
}

// The bracket of a set in growth.
class Growth {
 public:
  Growth(const SupportMap& set, const StartSimplex& start, const EpsilonOptions& options)
      : set_(set),
        options_(options),
        zero_(kFlatness * start.scale),
        rounding_(2.0 * ExpandingPolytope::kRounding * start.scale),
        upper_(start.upper),
        upper_normal_(start.upper_normal),
        polytope_(start.points, start.scale) {}

  EpsilonBracket run() {
    descend();
    while (true) {
      if (upper_ <= zero_) return {};
      polytope_.set_bound(upper_);
      const ExpandingPolytope::Nearest nearest = polytope_.nearest();
      const double offset = nearest.facet < 0 ? upper_ : std::min(nearest.plane.offset, upper_);
      // Offsets that fall from above zero again are rounding: the surface is not to be trusted. Up
      // to `rounding_` they were zero all along: symmetric sets start with the origin on an edge.
      if (offset <= 0.0 && lower_ > rounding_) return bracket(EpsilonStatus::stalled);
      lower_ = std::max(lower_, offset);
      if (upper_ - lower_ <= slack()) return bracket(EpsilonStatus::converged);
      if (upper_ < options_.cutoff) return bracket(EpsilonStatus::below_cutoff);
      if (polytope_.facets_made() >= options_.max_facets) return bracket(EpsilonStatus::limit);
      if (!expand(nearest)) return bracket(EpsilonStatus::stalled);
    }
  }

 private:
  // Grows the polytope beyond its nearest facet; where that facet is final, lowers the upper bound
  // to it instead.
  bool expand(const ExpandingPolytope::Nearest& nearest) {
    const Wrench point = set_.support(nearest.plane.normal);
    const double value = nearest.plane.normal.dot(point);
    if (value < upper_) {
      upper_ = value;
      upper_normal_ = nearest.plane.normal;
      descend();
    }
    const bool final = value - nearest.plane.offset <= slack();
    return final || upper_ <= zero_ || polytope_.expand(nearest.facet, point);
  }

  // Lowers the upper bound by descent over unit normals. The gradient of the support function h at
  // n is the support point p, along the sphere p - h n. Over h it has no unit; the step grows where
  // it succeeds and shrinks where it does not.
  void descend() {
    if (options_.descent_steps <= 0) return;
    Wrench point = set_.support(upper_normal_);
    double step = 1.0;
    for (int i = 0; i < options_.descent_steps && upper_ > zero_; ++i) {
      const Wrench downhill = upper_normal_ - point / upper_;
      const Wrench normal = (upper_normal_ + step * downhill).normalized();
      const Wrench next = set_.support(normal);
      const double value = normal.dot(next);
      step *= value < upper_ ? 1.5 : 0.4;
      if (value >= upper_) continue;
      upper_ = value;
      upper_normal_ = normal;
      point = next;
    }
  }

  double slack() const { return std::max(options_.relative_tolerance * upper_, rounding_); }

  EpsilonBracket bracket(EpsilonStatus status) const {
    return {lower_ > zero_ ? lower_ : 0.0, upper_, status, -upper_ * upper_normal_};
  }

  const SupportMap& set_;
  const EpsilonOptions& options_;
  double zero_;
  double rounding_;
  double lower_ = 0.0;
  double upper_;
  Wrench upper_normal_;
  ExpandingPolytope polytope_;
};

// What the full hull says about a set on which growth stalled at `bracket`.
EpsilonBracket from_hull(const Wrenches& wrenches, const EpsilonOptions& options,
                         const EpsilonBracket& bracket) {
  WrenchHull hull;
  try {
    hull = wrench_hull(wrenches);
  } catch (const std::runtime_error&) {
    return bracket;
  }
  if (!hull.force_closure()) return {};
  const double epsilon = std::clamp(hull.min_offset, bracket.lower, bracket.upper);
  const bool dropped = epsilon < options.cutoff;
  return {epsilon, epsilon, dropped ? EpsilonStatus::below_cutoff : EpsilonStatus::converged,
          hull.weakest};
}

// The bracket of wrenches whose squares are not in the range of doubles, from that of the same
// wrenches times 2^-exponent.
EpsilonBracket from_scaled(const Wrenches& wrenches, EpsilonOptions options, int exponent) {
  options.cutoff = std::ldexp(options.cutoff, -exponent);
  EpsilonBracket bracket = epsilon_l1(times_power_of_two(wrenches, -exponent), options);
  bracket.lower = std::ldexp(bracket.lower, exponent);
  bracket.upper = std::ldexp(bracket.upper, exponent);
  bracket.weakest = times_power_of_two(bracket.weakest, exponent);
  return bracket;
}

}  // namespace

EpsilonBracket epsilon(const SupportMap& set, const EpsilonOptions& options) {
  check(options);
  const StartSimplex start = start_simplex(set, true);
  if (start.flat) return {};
  return Growth(set, start, options).run();
}

EpsilonBracket epsilon_l1(const Wrenches& wrenches, const EpsilonOptions& options) {
  check(options);
  if (wrenches.cols() == 0) return {};
  const int exponent = excess_exponent(wrenches);
  if (exponent != 0) return from_scaled(wrenches, options, exponent);
  const EpsilonBracket bracket = epsilon(ColumnSupport(wrenches), options);
  if (bracket.status != EpsilonStatus::stalled) return bracket;
  return from_hull(wrenches, options, bracket);
}

}  // namespace prehend
