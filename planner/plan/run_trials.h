// Runs the trials of many candidates in parallel.
#pragma once

#include <optional>
#include <vector>

#include "sim/base/pool.h"
#include "sim/base/run_context.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/candidate.h"
#include "sim/trial/run_trial.h"
#include "sim/trial/trial.h"
#include "sim/trial/trial_options.h"

namespace prehend {

// What the trials of one thread use again and again. A result is a copy of `trial`.
struct TrialWorker {
  TrialWorkspace workspace;
  Trial trial;
};
using TrialWorkers = Pool<TrialWorker>;

// Runs a trial of each candidate, on context.threads threads. Result i belongs to candidate i and
// is the same on any number of threads. Reports progress after each trial. Does not throw
// Cancelled: the results of trials that were not finished by then, or not begun by the deadline,
// are empty.
std::vector<std::optional<Trial>> run_trials(const CompiledScene& scene,
                                             const std::vector<Candidate>& candidates,
                                             const TrialOptions& options,
                                             const RunContext& context = {});

// The same as a part of a longer search, which keeps the workers. `before`: the search's progress,
// in which blocked trials (is_blocked) are not counted. Without it (a total of 0), all are.
std::vector<std::optional<Trial>> run_trials(const CompiledScene& scene,
                                             const std::vector<Candidate>& candidates,
                                             const TrialOptions& options, TrialWorkers& workers,
                                             const RunContext& context, const Progress& before);

}  // namespace prehend
