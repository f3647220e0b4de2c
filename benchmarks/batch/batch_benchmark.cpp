// What a batch costs beside its trials: its rate against that of the same trials by themselves, the
// memory while it runs, the size of its results, and how fast they are merged.
//   batch_benchmark FOLDER [TRIALS]     a new folder; 100,000 trials
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "benchmarks/support/percentile.h"
#include "benchmarks/support/resources.h"
#include "planner/bulk/merge_batch.h"
#include "planner/bulk/part_worker.h"
#include "planner/bulk/run_batch.h"
#include "planner/plan/object_primitives.h"
#include "planner/plan/run_trials.h"
#include "planner/plan/search_grasps.h"
#include "sim/base/formatted.h"
#include "sim/base/json/json_field.h"
#include "sim/base/output_file.h"

namespace prehend::benchmark {
namespace {

constexpr int kTrialsOfAPart = 2000;
constexpr int kThreads = 2;

// Seven objects with three hands: 21 parts for each seed.
std::string batch_text(int seeds) {
  std::string list = "1";
  for (int i = 2; i <= seeds; ++i) list += formatted(",%d", i);
  return formatted(
      R"({"objects": [{"generate": ["mug", "wine_glass", "phone", "flask", "bottle", "bowl", "box"]}],
          "hands": ["franka_hand", "barrett", "robotiq_2f85"], "settings": [{"trials": %d}],
          "seeds": [%s]})",
      kTrialsOfAPart, list.c_str());
}

double seconds_since(Clock::time_point start) { return 1e-3 * milliseconds_since(start); }

// Trials a second of the parts' candidates, with all else left out.
double trial_rate(const Batch& batch, const BatchInputs& inputs, std::size_t parts) {
  PartWorker worker;
  TrialWorkers workers;
  double seconds = 0.0;
  std::size_t trials = 0;
  for (std::size_t i = 0; i < parts; ++i) {
    // Every part of the first seed.
    const BatchPart part = part_at(batch, i * batch.seeds.size());
    const PlanOptions& options = inputs.options_of(part);
    const CompiledScene scene = compile(worker.scene(batch, inputs, part));
    const SearchResult found =
        search_grasps(scene, object_primitives(scene, options.primitives, options.thin_parts).all,
                      options.candidates, options.search, options.trial);
    std::vector<Candidate> candidates;
    for (const ProposedGrasp& grasp : found.proposed) candidates.push_back(grasp.candidate);
    RunContext context;
    context.threads = kThreads;
    const Clock::time_point start = Clock::now();
    trials += run_trials(scene, candidates, options.trial, workers, context, {}).size();
    seconds += seconds_since(start);
  }
  return static_cast<double>(trials) / seconds;
}

std::uintmax_t bytes_below(const std::filesystem::path& folder) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) bytes += entry.file_size();
  }
  return bytes;
}

void measure(const std::filesystem::path& folder, int trials) {
  const int of_a_seed = 21 * kTrialsOfAPart;
  const int seeds = std::max(1, (trials + of_a_seed - 1) / of_a_seed);
  const Batch batch = read_batch(JsonFile("batch.json", batch_text(seeds)));
  const BatchInputs inputs(batch);
  const BatchFolder out(folder, batch);
  RunContext context;
  context.threads = kThreads;

  // Rates of a machine drift: the trials by themselves are measured before and after the batch.
  const double before = trial_rate(batch, inputs, 21);
  std::vector<double> memory;  // MB
  forget_most_megabytes();
  BatchListener listener;
  listener.progress = [&](const BatchCount& count) {
    if (count.made == 0) return;
    memory.push_back(most_megabytes());
    forget_most_megabytes();
  };
  const Clock::time_point start = Clock::now();
  const BatchCount count = run_batch(batch, inputs, out, {}, context, listener);
  const double took = seconds_since(start);
  const double after = trial_rate(batch, inputs, 21);
  const double rate = static_cast<double>(count.trials) / took;
  std::printf("batch: %zu trials in %zu parts, %.1f s, %.0f trials/s\n", count.trials, count.made,
              took, rate);
  std::printf("the same trials by themselves: %.0f and %.0f trials/s; the batch has %.3f of that\n",
              before, after, rate / (0.5 * (before + after)));
  const std::size_t tenth = std::max<std::size_t>(1, memory.size() / 10);
  for (std::size_t i = 0; i + tenth <= memory.size(); i += tenth) {
    const std::vector<double> some(memory.begin() + static_cast<std::ptrdiff_t>(i),
                                   memory.begin() + static_cast<std::ptrdiff_t>(i + tenth));
    std::printf("memory, parts %zu to %zu: at most %.0f MB\n", i + 1, i + tenth,
                percentile(some, 1.0));
  }
  const auto bytes = static_cast<double>(bytes_below(folder / "parts"));
  std::printf("results: %.1f MB, %.0f bytes a trial, %.0f kB a part\n", 1e-6 * bytes,
              bytes / static_cast<double>(count.trials),
              1e-3 * bytes / static_cast<double>(count.made));
  forget_most_megabytes();
  const Clock::time_point merge = Clock::now();
  (void)merge_batch(batch, inputs, out, {}, context);
  const double merged = seconds_since(merge);
  std::printf("merge: %.1f s, %.1f parts/s, %.1f MB/s of results, at most %.0f MB\n", merged,
              static_cast<double>(count.made) / merged, 1e-6 * bytes / merged, most_megabytes());
}

}  // namespace
}  // namespace prehend::benchmark

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "batch_benchmark FOLDER [TRIALS]\n");
    return 2;
  }
  const std::vector<std::string> words(argv + 1, argv + argc);
  prehend::benchmark::measure(words[0], words.size() > 1 ? std::stoi(words[1]) : 100000);
  return 0;
}
