// The gap between two bodies while one of them moves, asked again and again at little cost.
#pragma once

#include <vector>

#include "sim/geometry/proximity.h"
#include "sim/trial/trial_options.h"

namespace prehend {

// How far bodies with this gap may still move: what is beyond contact_gap; where the bound is loose
// and promises next to nothing, a part of it, so that the next query is nearer to the truth.
inline double safe_step(const Gap& gap, const TrialOptions& options) {
  return gap.lower > options.closed_gap() ? gap.lower - options.contact_gap : 0.25 * gap.lower;
}

// Far away the distance of the convex parts does, closer a loose query of the meshes; close by, the
// triangle pairs that can still meet are listed once and only they are looked at until the bodies
// have moved on.
class GapTracker {
 public:
  // Both meshes and the options must outlive the tracker.
  GapTracker(const ProximityMesh& a, const ProximityMesh& b, const GapTrackerOptions& options)
      : a_(&a),
        b_(&b),
        options_(&options),
        directions_(a.parts().size() * b.parts().size(), Vector3::Zero()) {}

  // A proven lower bound and an upper bound of the gap at X_AB. `moved` bounds how far any point of
  // one body moved relative to the other since the last query, `motion_left` how far it still can:
  // gaps beyond that come back as at least that.
  Gap query(const Pose& X_AB, double moved, double motion_left);

  int queries() const { return queries_; }

 private:
  double part_separation(const Pose& X_AB);
  Gap query_trees(const Pose& X_AB, double motion_left);

  const ProximityMesh* a_;
  const ProximityMesh* b_;
  const GapTrackerOptions* options_;
  std::vector<Vector3> directions_;  // per pair of convex parts, what separated them last
  bool parts_meet_ = false;          // the parts have met: their distance has no more to say
  std::vector<TrianglePair> near_pairs_;
  double near_bound_ = 0.0;  // pairs not listed are at least this far apart; 0: nothing is listed
  TrianglePair last_pair_;
  int queries_ = 0;
};

}  // namespace prehend
