#include "sim/quality/epsilon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/require_settings.h"
#include "sim/quality/epsilon_workspace.h"
#include "sim/quality/expanding_polytope.h"
#include "sim/quality/start_simplex.h"
#include "sim/quality/wrench_hull.h"
#include "sim/quality/wrench_size.h"

// The set is known by its support function h(n) = max n . x over the set, n a unit vector. A ball
// of radius r around the origin is inside the set exactly if h(n) >= r for all n, so that epsilon
// is the minimum of h over all unit vectors. Two facts enclose it. Any value h(n) is an upper
// bound. And the hull of any points of the set is inside the set, so that the smallest offset of
// the hull's facets is a lower bound.
//
// The search takes the facet with the smallest offset, which sets the lower bound, and asks for the
// support point along its normal. If the set reaches no farther than the facet, both bounds meet
// there. Else the value lowers the upper bound, perhaps, and the point is added to the hull, which
// removes that facet. Only facets near the origin are refined, which is why this needs a small part
// of the facets of the full hull.
namespace prehend {
namespace {

// The search for the epsilon of one set, from a simplex inside it.
class Growth {
 public:
  Growth(const SupportMap& set, const StartSimplex& start, const EpsilonOptions& options,
         ExpandingPolytope& polytope)
      : set_(set),
        options_(options),
        zero_(kFlatness * start.scale),
        rounding_(2.0 * ExpandingPolytope::kRounding * start.scale),
        upper_(start.upper),
        upper_normal_(start.upper_normal),
        polytope_(polytope) {
    polytope_.start(start.points, start.scale);
  }

  EpsilonBracket run() {
    descend();
    while (true) {
      if (upper_ <= zero_) return {};
      polytope_.set_bound(upper_);
      const ExpandingPolytope::Nearest nearest = polytope_.nearest();
      // If every facet is at least as far away as the upper bound, the lower bound equals it.
      const double offset = nearest.facet < 0 ? upper_ : std::min(nearest.plane.offset, upper_);
      // A growing hull that has enclosed the origin keeps it inside. Offsets that fall to zero or
      // below after that show that rounding has spoiled the surface. A lower bound within rounding
      // of zero does not count as enclosed: in symmetric sets the start simplex often has the
      // origin on its border, at an offset that is zero up to rounding.
      if (offset <= 0.0 && lower_ > rounding_) return bracket(EpsilonStatus::stalled);
      lower_ = std::max(lower_, offset);
      if (lower_ > upper_ + slack()) return bracket(EpsilonStatus::stalled);
      if (upper_ - lower_ <= slack()) return bracket(EpsilonStatus::converged);
      if (upper_ < options_.cutoff) return bracket(EpsilonStatus::below_cutoff);
      if (polytope_.facets_made() >= options_.max_facets) return bracket(EpsilonStatus::limit);
      if (!expand(nearest)) return bracket(EpsilonStatus::stalled);
    }
  }

 private:
  // Adds the support point along the normal of the nearest facet to the polytope, and lowers the
  // upper bound if its value is smaller. A facet beyond which the set does not reach is final and
  // needs no point: the next test for convergence ends the search. False where rounding prevents
  // the point from being added.
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

  // Lowers the upper bound by gradient descent over unit normals n. The gradient of the support
  // function h at n is the support point p; its part along the unit sphere is p - h n. Divided by h
  // it is without unit, so that one initial step length suits sets of any size. The step grows by
  // half after a success and shrinks to 0.4 of itself after a failure.
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

  // The difference of the bounds at which the search has converged.
  double slack() const { return std::max(options_.relative_tolerance * upper_, rounding_); }

  // The upper bound is a support value, which rounding hardly changes. A lower bound beyond it is
  // that of facets which rounding has spoiled, and proves nothing.
  EpsilonBracket bracket(EpsilonStatus status) const {
    const bool spoiled = lower_ > upper_ + slack();
    const double lower = lower_ > zero_ && !spoiled ? std::min(lower_, upper_) : 0.0;
    return {lower, upper_, status, -upper_ * upper_normal_};
  }

  const SupportMap& set_;
  const EpsilonOptions& options_;
  double zero_;      // support values up to this count as zero: the set is flat there
  double rounding_;  // difference of two heights that may be rounding alone
  double lower_ = 0.0;
  double upper_;
  Wrench upper_normal_;
  ExpandingPolytope& polytope_;
};

// A lower bound from the facets of the full hull: the smallest distance of one of its simplices
// from the origin. Where the hull comes from qhull, facets that are nearly in one plane were
// merged, so that planes may miss corners by far more than rounding; what counts here is the lowest
// corner (fit_offset).
Hyperplane lowest_simplex(const Eigen::Ref<const Wrenches>& wrenches, const PointHull& hull) {
  std::vector<Wrench> points;
  for (const auto& column : wrenches.colwise()) points.emplace_back(column);
  Hyperplane lowest{Wrench::Zero(), std::numeric_limits<double>::infinity()};
  for (Eigen::Index f = 0; f < hull.offsets.size(); ++f) {
    FacetCorners corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      corners[i] = &points[index(hull.corners(static_cast<Eigen::Index>(i), f))];
    }
    Hyperplane plane = fit_offset<6>(hull.normals.col(f), corners).plane;
    if (plane.offset >= lowest.offset) continue;
    const Hyperplane fitted = fit_plane<6>(plane.normal, corners).plane;
    if (fitted.offset > plane.offset) plane = fitted;
    if (plane.offset < lowest.offset) lowest = plane;
  }
  return lowest;
}

// The bounds with the help of the full hull, for wrenches on which the search stalled at `bracket`.
// If there is no full hull either, the bracket remains the answer.
EpsilonBracket from_hull(const Eigen::Ref<const Wrenches>& wrenches, const EpsilonOptions& options,
                         EpsilonBracket bracket) {
  WrenchHull hull;
  try {
    hull = wrench_hull(wrenches);
  } catch (const std::runtime_error&) {
    return bracket;
  }
  if (!hull.force_closure()) return {};
  const Hyperplane lowest = lowest_simplex(wrenches, hull.points);
  for (const Wrench& normal : {Wrench(-hull.weakest.normalized()), lowest.normal}) {
    const double value = (normal.transpose() * wrenches).maxCoeff();
    if (value >= bracket.upper) continue;
    bracket.upper = value;
    bracket.weakest = -value * normal;
  }
  bracket.lower = std::min(std::max(bracket.lower, lowest.offset), bracket.upper);
  const double rounding = 2.0 * ExpandingPolytope::kRounding * wrenches.cwiseAbs().maxCoeff();
  const double slack = std::max(options.relative_tolerance * bracket.upper, rounding);
  if (bracket.upper < options.cutoff) {
    bracket.status = EpsilonStatus::below_cutoff;
  } else if (bracket.upper - bracket.lower <= slack) {
    bracket.status = EpsilonStatus::converged;
  }
  return bracket;
}

// The bracket of wrenches whose squares would leave the range of doubles, computed from the same
// wrenches times 2^-exponent. Powers of two scale without rounding.
EpsilonBracket from_scaled(const Eigen::Ref<const Wrenches>& wrenches, EpsilonOptions options,
                           int exponent) {
  options.cutoff = std::ldexp(options.cutoff, -exponent);
  EpsilonBracket bracket = epsilon_l1(times_power_of_two(wrenches, -exponent), options);
  bracket.lower = std::ldexp(bracket.lower, exponent);
  bracket.upper = std::ldexp(bracket.upper, exponent);
  bracket.weakest = times_power_of_two(bracket.weakest, exponent);
  return bracket;
}

EpsilonBracket epsilon_with(ExpandingPolytope& polytope, const SupportMap& set,
                            const EpsilonOptions& options) {
  const StartSimplex start = start_simplex(set, true);
  if (start.flat) return {};
  return Growth(set, start, options, polytope).run();
}

}  // namespace

EpsilonBracket epsilon(const SupportMap& set, const EpsilonOptions& options) {
  require_settings(options);
  ExpandingPolytope polytope;
  return epsilon_with(polytope, set, options);
}

EpsilonBracket epsilon_l1(const Eigen::Ref<const Wrenches>& wrenches,
                          const EpsilonOptions& options) {
  EpsilonWorkspace workspace;
  return epsilon_l1(wrenches, options, workspace);
}

EpsilonBracket epsilon_l1(const Eigen::Ref<const Wrenches>& wrenches, const EpsilonOptions& options,
                          EpsilonWorkspace& workspace) {
  require_settings(options);
  if (wrenches.cols() == 0) return {};
  const int exponent = excess_exponent(wrenches);
  if (exponent != 0) return from_scaled(wrenches, options, exponent);
  workspace.set.assign(wrenches);
  const EpsilonBracket bracket = epsilon_with(workspace.polytope, workspace.set, options);
  if (bracket.status != EpsilonStatus::stalled) return bracket;
  return from_hull(wrenches, options, bracket);
}

}  // namespace prehend
