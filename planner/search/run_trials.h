// Runs the trials of many candidates in parallel.
#pragma once

#include <optional>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/trial/trial.h"

namespace prehend {

// Runs a trial of each candidate, on context.threads threads. Result i belongs to candidate i and
// is the same on any number of threads. Reports progress after each trial. Does not throw
// Cancelled: the results of trials that were not finished by then, or not begun by the deadline,
// are empty.
//
// `before`: the progress of a longer search that these trials are a part of, in which blocked
// trials (is_blocked) are not counted. Without it (a total of 0), all are.
std::vector<std::optional<Trial>> run_trials(const CompiledScene& scene,
                                             const std::vector<Candidate>& candidates,
                                             const TrialOptions& options,
                                             const RunContext& context = {},
                                             const Progress& before = {});

}  // namespace prehend
