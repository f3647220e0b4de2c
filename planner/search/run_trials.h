// Many trials on many threads, each result where its candidate stands.
#pragma once

#include <functional>
#include <vector>

#include "sim/trial/trial.h"

namespace prehend {

struct TrialProgress {
  int done = 0;
  int total = 0;
  int stable = 0;
};

struct RunTrialsOptions {
  TrialOptions trial;
  int threads = 0;  // 0: as many as there are processors
  // Called after each trial, never by two threads at once; may be empty.
  std::function<void(const TrialProgress&)> progress;
};

// Result i belongs to candidate i; the same on any number of threads.
std::vector<Trial> run_trials(const CompiledScene& scene, const std::vector<Candidate>& candidates,
                              const RunTrialsOptions& options);

}  // namespace prehend
