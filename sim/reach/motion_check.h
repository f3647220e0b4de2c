// Whether an arm can move along a path of postures without touching anything.
#pragma once

#include <optional>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/base/settings.h"
#include "sim/scene/compiled_arm.h"

namespace prehend {

// Postures to be joined by straight lines in joint space; one value for each joint of the platform.
using JointPath = std::vector<std::vector<double>>;

struct MotionCheckOptions {
  // A stretch on which no point of a pair moves more than this relative to the other is not cut any
  // further: if its gap is still not proven, the pair counts as blocked [m].
  double tightest = 2e-4;
  // Part by which the gap of a pair may be underestimated: a looser query is quicker, but cuts the
  // motion into more stretches.
  double gap_error = 0.5;
};

template <SettingsOf<MotionCheckOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [tightest, gap_error] = options;
  visit("tightest", tightest);
  visit("gap_error", gap_error);
}

// The first pair that was not proven to stay apart all along the path; none: the whole motion is
// free, not only at samples. A gap in the middle of a stretch speaks for all of it when it is
// larger than the farthest that any point moves from there; else the stretch is cut in two
// (Schwarzer, Saha and Latombe 2005, "Adaptive dynamic collision checking"). The path's postures
// themselves must be free of bodies that hold each other without their surfaces meeting (see
// first_meeting). Throws Cancelled.
std::optional<ArmPair> first_blocked(const CompiledArm& arm, const std::vector<ArmPair>& pairs,
                                     const JointPath& path, const MotionCheckOptions& options = {},
                                     const RunContext& context = {});

// The first of the pairs whose bodies meet, or hold each other, in a posture.
std::optional<ArmPair> first_meeting(const CompiledArm& arm, const std::vector<ArmPair>& pairs,
                                     const std::vector<double>& joints);

}  // namespace prehend
