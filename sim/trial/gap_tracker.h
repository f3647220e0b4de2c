// Repeated queries of the gap between two moving bodies, which reuse what earlier queries found.
#pragma once

#include <span>
#include <vector>

#include "sim/shape/proximity.h"
#include "sim/trial/trial_options.h"

namespace prehend {

class ConvexPoints;  // sim/shape/separation.h

// A longer list of near triangle pairs is not kept; the next one is tried when the gap is half as
// large. Searches of the bounding-volume trees cost more than this many pairs, of which most are
// only looked at.
inline constexpr int kMostListedPairs = 2000;
// Most gap queries for one pair of bodies in one motion. A pair that needs more counts as touching
// where it is: the motion may then end short of a contact, but never in a penetration.
inline constexpr int kMaxGapQueries = 400;

// How far the bodies may move towards each other after a query gave `gap`, without their gap
// falling below contact_gap [m]. Where the lower bound is too loose to allow such a step but the
// upper bound does not show contact, they move by a quarter of the lower bound: that is safe too,
// and the next query may find a tighter bound.
inline double safe_step(const Gap& gap, const TrialOptions& options) {
  return gap.lower > options.closed_gap() ? gap.lower - options.contact_gap : 0.25 * gap.lower;
}

// Two convex parts, one of each body, and how far apart they are along one direction.
struct PartsApart {
  const ConvexPoints* part_of_b = nullptr;  // in B's frame
  const ConvexPoints* part_of_a = nullptr;
  // From the part of A to that of B, unit, in A's frame. Of any length, and the start of the next
  // search, where the last query did not come to the parts.
  Vector3 direction = Vector3::Zero();
  // All of B's part is so much farther along `direction` than all of A's part [m].
  double distance = 0.0;
};

// Answers a query at one of three costs, by the size of the gap. Large gaps: the distance between
// the convex parts that enclose the two surfaces. Medium gaps: an approximate search of the
// bounding-volume trees of the meshes. Small gaps: the exact distance of the triangle pairs that
// are near each other, listed once and reused until the bodies have moved too far for the list.
// Where fine meshes have too many such pairs, it is the search of the trees again, which is exact
// for gaps up to 0.3 mm. Every answer is a proven bound, whatever the constants.
class GapTracker {
 public:
  // To be started before it is asked.
  GapTracker() = default;
  // Both meshes must outlive the tracker. `most_pairs`: kMostListedPairs.
  GapTracker(const ProximityMesh& a, const ProximityMesh& b, int most_pairs = kMostListedPairs) {
    start(a, b, most_pairs);
  }

  // Begins anew, with these bodies, in the memory that it has.
  void start(const ProximityMesh& a, const ProximityMesh& b, int most_pairs = kMostListedPairs);

  // A proven lower bound and an upper bound of the gap [m] with B at X_AB in A's frame. `moved`
  // [m] bounds how far any point of one body moved relative to the other since the last query,
  // `motion_left` [m] how far it may still move. Of a gap larger than `motion_left` only that is
  // found out: its lower bound is at least `motion_left`.
  Gap query(const Pose& X_AB, double moved, double motion_left);

  // Where the last query was answered by convex parts that enclose the surfaces: all pairs of them,
  // which stay apart as long as the bodies do not move by `distance` along any `direction`. Empty
  // where it was answered otherwise.
  std::span<const PartsApart> parts_apart() const {
    return apart_ ? std::span<const PartsApart>(parts_) : std::span<const PartsApart>();
  }

  int queries() const { return queries_; }

 private:
  double part_separation(const Pose& X_AB);
  Gap query_trees(const Pose& X_AB, double motion_left);
  // Bounds from a search of the trees, loose ones.
  Gap loose_gap(const Pose& X_AB, double motion_left);
  Gap list_near_pairs(const Pose& X_AB, double motion_left);
  // The answer where there is no list, from that of a search of the trees: exact near contact.
  Gap without_list(const Pose& X_AB, const Gap& gap);

  const ProximityMesh* a_ = nullptr;
  const ProximityMesh* b_ = nullptr;
  int most_pairs_ = kMostListedPairs;
  double list_below_ = 0.0;        // gaps above this are not worth a list of near pairs [m]
  std::vector<PartsApart> parts_;  // per pair of convex parts
  bool apart_ = false;             // the last query was answered by them
  bool parts_meet_ = false;  // convex parts have overlapped: their distance is no use any more
  NearPairs near_;           // beyond is 0 where there is no list
  TrianglePair last_pair_;   // the closest pair found last, where the next search begins
  int queries_ = 0;
};

}  // namespace prehend
