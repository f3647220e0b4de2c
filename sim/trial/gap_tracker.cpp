#include "sim/trial/gap_tracker.h"

#include <algorithm>
#include <limits>

#include "sim/base/index.h"
#include "sim/shape/separation.h"

namespace prehend {
namespace {

// Below this gap the pairs of nearby triangles are listed; at larger gaps the list would be too
// long [m].
constexpr double kNear = 5e-4;
// The list holds all pairs closer than this times the gap, and at least those closer than the gap
// and kLeastReach [m].
constexpr double kReach = 2.0;
constexpr double kLeastReach = 3e-4;
// Relative error allowed in a query of the trees, whose answer only limits the next step. A looser
// bound costs less but allows shorter steps, so that more queries are needed.
constexpr double kRelativeError = 0.5;

}  // namespace

void GapTracker::start(const ProximityMesh& a, const ProximityMesh& b, int most_pairs) {
  a_ = &a;
  b_ = &b;
  most_pairs_ = most_pairs;
  list_below_ = kNear;
  parts_.assign(a.parts().size() * b.parts().size(), {});
  apart_ = false;
  parts_meet_ = false;
  near_.pairs.clear();
  near_.beyond = 0.0;
  last_pair_ = {};
  queries_ = 0;
}

Gap GapTracker::query(const Pose& X_AB, double moved, double motion_left) {
  ++queries_;
  apart_ = false;
  if (near_.beyond > 0.0) {
    const Gap gap = gap_of_pairs(*a_, *b_, X_AB, moved, near_);
    if (gap.lower <= near_.beyond) {
      last_pair_ = gap.pair;
      return gap;
    }
    // The listed pairs are farther apart than the bound for all others. That bound still holds for
    // every pair, and is worth a step while it is not too small.
    if (near_.beyond > kLeastReach) return {near_.beyond, gap.upper, gap.pair};
    near_.beyond = 0.0;
  }
  return query_trees(X_AB, motion_left);
}

double GapTracker::part_separation(const Pose& X_AB) {
  double least = std::numeric_limits<double>::infinity();
  auto parts = parts_.begin();
  for (const ConvexPoints& part_a : a_->parts()) {
    for (const ConvexPoints& part_b : b_->parts()) {
      parts->part_of_a = &part_a;
      parts->part_of_b = &part_b;
      parts->distance = separation(part_a, part_b, X_AB, parts->direction);
      least = std::min(least, parts->distance);
      ++parts;
    }
  }
  return least;
}

Gap GapTracker::query_trees(const Pose& X_AB, double motion_left) {
  // The distance of the convex parts that enclose the surfaces is quick to find (separation). Once
  // they overlap it no longer bounds the gap, and bodies that approach each other will not come
  // apart again: the test is then dropped for the rest of the motion.
  if (!parts_meet_) {
    // Far away, the distance of the parts is answer enough. It is only a lower bound: the surfaces
    // lie somewhere inside the parts, so that nothing is known of the upper bound.
    const double apart = part_separation(X_AB);
    if (apart > std::min(kNear, motion_left)) {
      apart_ = true;
      return {apart, std::numeric_limits<double>::infinity(), {}};
    }
    parts_meet_ = apart <= 0.0;
  }
  // The pair found last is often near enough still to list what is near at once.
  const double at_most = last_pair_.a >= 0 ? triangle_gap(*a_, *b_, X_AB, last_pair_).distance
                                           : std::numeric_limits<double>::infinity();
  if (at_most == 0.0) return {0.0, 0.0, last_pair_};
  if (at_most > std::min(list_below_, motion_left)) {
    const Gap gap = loose_gap(X_AB, motion_left);
    if (gap.upper == 0.0) return gap;
    if (gap.upper > list_below_) return without_list(X_AB, gap);
  }
  return list_near_pairs(X_AB, motion_left);
}

Gap GapTracker::loose_gap(const Pose& X_AB, double motion_left) {
  const Gap gap = find_gap(
      *a_, *b_, X_AB, {.cap = motion_left, .relative_error = kRelativeError, .hint = last_pair_});
  if (gap.pair.a >= 0) last_pair_ = gap.pair;
  return gap;
}

// Near contact, list the triangle pairs within a somewhat larger distance than the gap, and take
// the exact gap from them. Until the bodies have moved by the difference, the closest pair is in
// the list, and queries need not search the trees.
Gap GapTracker::list_near_pairs(const Pose& X_AB, double motion_left) {
  const NearPairsOptions near{kReach, kLeastReach, index(most_pairs_), last_pair_};
  if (find_near_pairs(*a_, *b_, X_AB, near, near_)) {
    const Gap exact = gap_of_pairs(*a_, *b_, X_AB, 0.0, near_);
    last_pair_ = exact.pair;
    return exact;
  }
  // Fine meshes that lie flat on each other have too many such pairs. The next attempt waits until
  // the gap has shrunk, since attempts take time.
  near_.beyond = 0.0;
  const Gap gap = loose_gap(X_AB, motion_left);
  list_below_ = 0.5 * std::min(list_below_, gap.upper);
  return gap.upper == 0.0 ? gap : without_list(X_AB, gap);
}

Gap GapTracker::without_list(const Pose& X_AB, const Gap& gap) {
  if (gap.upper > kLeastReach) return gap;
  const Gap exact = find_gap(*a_, *b_, X_AB, {.hint = gap.pair});
  last_pair_ = exact.pair;
  return exact;
}

}  // namespace prehend
