#include "planner/search/run_trials.h"

#include <mutex>

#include "sim/parallel/parallel.h"

namespace prehend {

std::vector<Trial> run_trials(const CompiledScene& scene, const std::vector<Candidate>& candidates,
                              const RunTrialsOptions& options) {
  std::vector<Trial> trials(candidates.size());
  std::mutex progress_lock;
  TrialProgress progress{0, static_cast<int>(candidates.size()), 0};
  for_each_in_parallel(candidates.size(), options.threads, [&](std::size_t i) {
    trials[i] = run_trial(scene, candidates[i], options.trial);
    if (!options.progress) return;
    const std::lock_guard lock(progress_lock);
    ++progress.done;
    if (trials[i].outcome == Outcome::stable) ++progress.stable;
    options.progress(progress);
  });
  return trials;
}

}  // namespace prehend
