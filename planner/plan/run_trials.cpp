#include "planner/plan/run_trials.h"

#include <mutex>

#include "sim/base/parallel/parallel.h"

namespace prehend {

std::vector<std::optional<Trial>> run_trials(const CompiledScene& scene,
                                             const std::vector<Candidate>& candidates,
                                             const TrialOptions& options,
                                             const RunContext& context) {
  TrialWorkers workers;
  return run_trials(scene, candidates, options, workers, context, {});
}

std::vector<std::optional<Trial>> run_trials(const CompiledScene& scene,
                                             const std::vector<Candidate>& candidates,
                                             const TrialOptions& options, TrialWorkers& workers,
                                             const RunContext& context, const Progress& before) {
  std::vector<std::optional<Trial>> trials(candidates.size());
  std::mutex progress_lock;
  const bool all_count = before.total == 0;
  Progress progress = before;
  if (all_count) progress = {Stage::trials, 0, static_cast<int>(candidates.size()), 0};
  if (context.progress && progress.done == 0) context.progress(progress);
  for_each_in_parallel(candidates.size(), context.threads, [&](std::size_t i) {
    // Candidates that have not begun are skipped without an exception each: throwing is slow, and
    // hundreds may be left.
    if (context.cancellation.requested() || context.deadline.has_passed()) return;
    // Caught for each trial: an exception that left the loop would discard the finished trials.
    try {
      const TrialWorkers::Loan worker(workers);
      run_trial(scene, candidates[i], options, worker->workspace, worker->trial, context);
      trials[i] = worker->trial;
    } catch (const Cancelled&) {
      return;
    }
    // RunContext promises that the callback is never called by two threads at once; the lock also
    // keeps the counts that it is given increasing.
    if (!context.progress) return;
    const std::lock_guard lock(progress_lock);
    if (all_count || !is_blocked(trials[i]->outcome)) ++progress.done;
    if (trials[i]->outcome == Outcome::stable) ++progress.stable;
    context.progress(progress);
  });
  return trials;
}

}  // namespace prehend
