// Auto-grasp: closes a hand at rest until each degree of freedom is stopped by contact or by its
// limit.
#pragma once

#include <cstddef>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include "sim/base/reused_list.h"
#include "sim/base/run_context.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/closing_motion.h"
#include "sim/trial/gap_tracker.h"
#include "sim/trial/trial_options.h"

namespace prehend {

// Where the hand has closed.
struct ClosedHand {
  std::vector<double> dofs;  // final values, per degree of freedom [rad or m]
  // Final values per joint [rad or m]. They differ from ratio * dof + offset where contact stopped
  // one joint of a degree of freedom while another moved on (breakaway, self-centering).
  std::vector<double> joints;
  std::vector<bool> stopped_by_contact;  // per joint
  int gap_queries = 0;                   // gap queries that closing took, of all pairs together
};

// Where the hand is when it starts to close.
struct ClosingStart {
  Pose X_OH = Pose::Identity();
  std::vector<double> dofs;  // per degree of freedom [rad or m]
  // Per joint [rad or m], where joints do not follow their degree of freedom (see ClosedHand).
  // Empty: each is ratio * dof + offset.
  std::vector<double> joints;
  // Of a hand that closes in time (close_dynamic), as in DynamicGraspStart.
  ClosingStrategy strategy = {};
  double farthest = std::numeric_limits<double>::infinity();
  // Known lower bounds of gaps save the first queries. Per link, of its gap to the object, and per
  // entry of CompiledScene::self_pairs, of the gap between its links; empty: not known [m].
  std::vector<double> object_clearance;
  std::vector<double> self_clearance;
};

// A link against another link, or against the object or an obstacle.
struct ClosingPair {
  LinkId link = {};
  std::variant<LinkId, BodyId> other = LinkId{};
  GapTracker tracker;
  double asked_at = 0.0;          // time of the last gap query [s]
  double speed_when_asked = 0.0;  // bound on how fast the gap can shrink from then on [m/s]
  double safe_until = 0.0;        // proven free of contact up to this time [s]
};

// Buffers of close_hand, to allocate less; one for each thread.
struct ClosingWorkspace {
  ClosingMotion motion;
  ReusedList<ClosingPair> pairs;
  std::vector<std::pair<double, std::size_t>> queue;  // when the proof of each pair ends
  std::vector<double> joints;
  ClosingLink link;   // of the pair that is asked for
  ClosingLink other;  // what it is paired with, where that is a link
  NearBodies near;
};

// All degrees of freedom with a closing velocity move at once, each at its own velocity. When a
// link comes within contact_gap of the object, an obstacle or another link (it never penetrates),
// every joint between the hand's base and that link stops. If such a joint belongs to a rigid
// degree of freedom, all joints of that degree of freedom stop; with the other couplings its
// remaining joints move on (see Coupling).
//
// A degree of freedom ends at its limit in the closing direction. Of two self-centering fingers one
// may pass its limit by as much as the other was stopped short of it; center_hand brings both back
// inside. The hand's base does not move. Source: Miller and Allen 2004, "GraspIt!", section
// "Robots" (auto-grasp, breakaway). `closed` is replaced. Throws Cancelled.
void close_hand(const CompiledScene& scene, const ClosingStart& start, const TrialOptions& options,
                ClosingWorkspace& workspace, ClosedHand& closed, const RunContext& context = {});

// The same for callers to whom allocations do not matter.
ClosedHand close_hand(const CompiledScene& scene, const ClosingStart& start,
                      const TrialOptions& options, const RunContext& context = {});

}  // namespace prehend
