// Moving the hand straight along its approach until something is touched.
#pragma once

#include <optional>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/hand_collision.h"
#include "sim/trial/trial_options.h"

namespace prehend {

// The hand's pose in the object's frame at travel s is X_OH_end moved back along `approach_O` by
// (distance - s).
struct ApproachMotion {
  Pose X_OH_end = Pose::Identity();
  Vector3 approach_O = Vector3::UnitZ();  // unit
  double distance = 0.0;                  // >= 0 [m]

  Pose at(double travel) const;
};

enum class ApproachEnd {
  stand_off,  // the hand went the whole distance and touched nothing
  touched_object,
  touched_obstacle,
  starts_in_collision,
};

struct ApproachResult {
  ApproachEnd end = ApproachEnd::stand_off;
  double travel = 0.0;               // [m]
  std::optional<HandContact> touch;  // what ended it; nothing for stand_off
  // Per link, a lower bound of its gap to the object at the end [m].
  std::vector<double> object_clearance;
};

// Joint values stay at `joints`. The hand ends within contact_gap of what it touches and penetrates
// nothing: no step is longer than the smallest gap (conservative advancement, Mirtich 1996).
// Throws Cancelled.
ApproachResult approach(const CompiledScene& scene, const std::vector<double>& joints,
                        const ApproachMotion& motion, const TrialOptions& options,
                        const RunContext& context = {});

}  // namespace prehend
