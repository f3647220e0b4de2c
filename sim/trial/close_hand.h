// Auto-grasp: every degree of freedom closes until what it moves touches something.
#pragma once

#include <vector>

#include "sim/base/run_context.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/trial_options.h"

namespace prehend {

struct ClosedHand {
  std::vector<double> dofs;  // per degree of freedom, where it ended
  std::vector<double>
      joints;  // per joint, where it ended; not ratio * dof where joints have parted
  std::vector<bool> stopped_by_contact;  // per joint
  int gap_queries = 0;
};

struct ClosingStart {
  Pose X_OH = Pose::Identity();
  std::vector<double> dofs;
  // Per joint; where joints have parted from their degree of freedom. Empty: ratio * dof + offset.
  std::vector<double> joints;
  std::vector<double> object_clearance;  // per link, a lower bound of its gap to the object [m]
  std::vector<double> self_clearance;    // per self pair of the scene; empty: not known [m]
};

// All degrees of freedom with a closing velocity move at it, together. When a link touches the
// object, an obstacle or another link (gap <= contact_gap, never a penetration), every joint before
// it stops; a rigid degree of freedom then stops whole, others go on with the joints that are left.
// A degree of freedom ends at its limit in the direction of closing; of two self-centering fingers
// one may go beyond it by as much as the other was stopped before it (center_hand brings both back
// inside). The hand's base stays where it is. Source: Miller and Allen 2004, "Robots" (auto-grasp,
// breakaway). Throws Cancelled.
ClosedHand close_hand(const CompiledScene& scene, const ClosingStart& start,
                      const TrialOptions& options, const RunContext& context = {});

}  // namespace prehend
