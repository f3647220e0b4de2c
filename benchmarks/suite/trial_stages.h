// What the stages of one trial cost.
#pragma once

#include <array>

#include "benchmarks/report/names.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/candidate.h"
#include "sim/trial/trial.h"
#include "sim/trial/trial_options.h"

namespace prehend::bench {

// Seconds of each of kTrialStages.
using StageSeconds = std::array<double, kTrialStages.size()>;

// The stages of a trial that ended with contacts. Approach and reach are what the trial measured
// itself. The rest of its time is split as the same stages take when they are called again, one by
// one, for each closing that the trial made.
StageSeconds stage_seconds(const CompiledScene& scene, const Candidate& candidate,
                           const Trial& trial, const TrialOptions& options);

}  // namespace prehend::bench
