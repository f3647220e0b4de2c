#include "sim/trial/gap_tracker.h"

#include <algorithm>

namespace prehend {
namespace {

// Within this gap the pairs are listed [m]. Farther away they would be too many.
constexpr double kNear = 2e-3;
// How far the list reaches beyond the gap, as a multiple of it, and at least [m].
constexpr double kReach = 1.5;
constexpr double kLeastReach = 3e-4;
// A list longer than this costs more than walking the trees.
constexpr std::size_t kMostPairs = 400;
// Looseness of a query that only has to say how far to go.
constexpr double kLoose = 0.4;

}  // namespace

Gap GapTracker::query(const Pose& X_AB, double moved, double motion_left) {
  ++queries_;
  if (near_bound_ > 0.0) {
    near_bound_ -= moved;
    Gap gap = gap_of_pairs(*a_, *b_, X_AB, near_pairs_);
    if (gap.lower <= near_bound_) {
      last_pair_ = gap.pair;
      return gap;
    }
    // Listed pairs are farther than what the others are sure of: still a bound worth stepping by.
    if (near_bound_ > kLeastReach) return {near_bound_, gap.upper, gap.pair};
    near_bound_ = 0.0;
  }
  return query_trees(X_AB, motion_left);
}

double GapTracker::part_separation(const Pose& X_AB) {
  double least = std::numeric_limits<double>::infinity();
  auto direction = directions_.begin();
  for (const ConvexPoints& part_a : a_->parts()) {
    for (const ConvexPoints& part_b : b_->parts()) {
      least = std::min(least, separation(part_a, part_b, X_AB, *direction++));
    }
  }
  return least;
}

Gap GapTracker::query_trees(const Pose& X_AB, double motion_left) {
  if (!parts_meet_) {
    const double apart = part_separation(X_AB);
    if (apart > std::min(kNear, motion_left)) {
      return {apart, std::numeric_limits<double>::infinity(), {}};
    }
    parts_meet_ = apart <= 0.0;
  }
  Gap gap =
      find_gap(*a_, *b_, X_AB, {.cap = motion_left, .relative_error = kLoose, .hint = last_pair_});
  if (gap.pair.a >= 0) last_pair_ = gap.pair;
  if (gap.upper > kNear || gap.upper == 0.0) return gap;
  const double bound = std::max(kReach * gap.upper, gap.upper + kLeastReach);
  find_pairs_within(*a_, *b_, X_AB, bound, near_pairs_);
  const Gap exact = gap_of_pairs(*a_, *b_, X_AB, near_pairs_);
  if (near_pairs_.size() <= kMostPairs) near_bound_ = bound;
  last_pair_ = exact.pair;
  return exact;
}

}  // namespace prehend
