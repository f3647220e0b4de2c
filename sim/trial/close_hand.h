// Auto-grasp: every degree of freedom closes until a link that it moves touches something.
#pragma once

#include <vector>

#include "sim/base/run_context.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/trial_options.h"

namespace prehend {

struct ClosedHand {
  std::vector<double> dofs;  // final values, per degree of freedom
  // Final values per joint. Where a finger was stopped at one joint and went on at another
  // (breakaway), they are not ratio * dof + offset.
  std::vector<double> joints;
  std::vector<bool> stopped_by_contact;  // per joint
  int gap_queries = 0;
};

struct ClosingStart {
  Pose X_OH = Pose::Identity();
  std::vector<double> dofs;
  // Per joint, where joints do not follow their degree of freedom (see ClosedHand). Empty: each is
  // ratio * dof + offset.
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
