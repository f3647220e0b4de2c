#include "planner/run_trials.h"

#include <mutex>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

namespace prehend {

void for_each_in_parallel(std::size_t count, int threads,
                          const std::function<void(std::size_t)>& work) {
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute([&] {
    // One at a time: trials differ in length a hundredfold.
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t i = range.begin(); i != range.end(); ++i) work(i);
        },
        tbb::simple_partitioner());
  });
}

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
