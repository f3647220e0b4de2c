// Moving the hand straight along its approach until something is touched.
#pragma once

#include <string>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/scene/compiled_scene.h"
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
  stand_off,  // the whole distance, nothing touched
  touched_object,
  touched_obstacle,
  starts_in_collision,
};

struct ApproachResult {
  ApproachEnd end = ApproachEnd::stand_off;
  double travel = 0.0;  // [m]
  int link = -1;        // that touched, -1 for none
  int obstacle = -1;    // that was touched, -1 for the object or nothing
  std::vector<double>
      object_clearance;  // per link, a lower bound of its gap to the object at the end
};

// Joint values stay at `joints`. The end is within contact_gap of what is touched and penetrates
// nothing: no step is longer than the smallest gap (conservative advancement, Mirtich 1996).
// Throws Cancelled.
ApproachResult approach(const CompiledScene& scene, const std::vector<double>& joints,
                        const ApproachMotion& motion, const TrialOptions& options,
                        const RunContext& context = {});

}  // namespace prehend
