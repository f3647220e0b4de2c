// Many trials on many threads, each result where its candidate stands.
#pragma once

#include <optional>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/trial/trial.h"

namespace prehend {

// Result i belongs to candidate i; the same on any number of threads. Reports progress after each
// trial. Does not throw Cancelled: what was not finished by then is empty.
std::vector<std::optional<Trial>> run_trials(const CompiledScene& scene,
                                             const std::vector<Candidate>& candidates,
                                             const TrialOptions& options,
                                             const RunContext& context = {});

}  // namespace prehend
