// The straight motion of the hand along its approach direction until it touches something.
#pragma once

#include <optional>
#include <vector>

#include "sim/base/reused_list.h"
#include "sim/base/run_context.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/gap_tracker.h"
#include "sim/trial/hand_collision.h"
#include "sim/trial/trial_options.h"

namespace prehend {

// A translation of the hand in the object's frame O. After the travel s [m] the hand is at X_OH_end
// moved back along `approach_O` by (distance - s).
struct ApproachMotion {
  Pose X_OH_end = Pose::Identity();       // of the hand's base at travel = distance
  Vector3 approach_O = Vector3::UnitZ();  // direction of the motion, unit
  double distance = 0.0;                  // >= 0 [m]

  Pose at(double travel) const;  // X_OH after `travel` in [0, distance] [m]
};

// Why the approach ended.
enum class ApproachEnd {
  stand_off,            // the hand moved the whole distance and touched nothing
  touched_object,       // a link is within contact_gap of the object
  touched_obstacle,     // a link is within contact_gap of an obstacle
  starts_in_collision,  // a link overlaps a body already at travel 0
};

struct ApproachResult {
  ApproachEnd end = ApproachEnd::stand_off;
  double travel = 0.0;               // how far the hand moved, in [0, distance] [m]
  std::optional<HandContact> touch;  // the link and body that ended it; nothing for stand_off
  // Per link of the hand, a lower bound of its gap to the object at the end [m].
  std::vector<double> object_clearance;
};

// One link against the object or an obstacle. Travels in metres along the approach.
struct ApproachPair {
  LinkId link = {};
  BodyId body = BodyId::object();
  GapTracker tracker;
  double asked_at = 0.0;    // travel at the last gap query
  double safe_until = 0.0;  // proven free of contact up to this travel
  double gap_then = 0.0;    // lower bound of the gap at that query, 0 where they touch [m]
};

// Buffers of approach, to allocate less; one for each thread.
struct ApproachWorkspace {
  RobotPoses poses;
  ReusedList<ApproachPair> pairs;
  NearBodies near;
};

// Moves the hand along `motion` until a link touches the object or an obstacle. Its joints stay at
// `joints` [rad or m]. The hand ends with a gap of contact_gap (at most 10 % more) to what it
// touches and penetrates nothing, because no step is longer than the smallest gap (conservative
// advancement: Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996).
// `result` is replaced. Throws Cancelled.
void approach(const CompiledScene& scene, const std::vector<double>& joints,
              const ApproachMotion& motion, const TrialOptions& options,
              ApproachWorkspace& workspace, ApproachResult& result, const RunContext& context = {});

// The same for callers to whom allocations do not matter.
ApproachResult approach(const CompiledScene& scene, const std::vector<double>& joints,
                        const ApproachMotion& motion, const TrialOptions& options,
                        const RunContext& context = {});

}  // namespace prehend
