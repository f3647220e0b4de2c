#include <algorithm>
#include <numeric>
#include <optional>

#include "benchmarks/report/names.h"
#include "benchmarks/suite/parts.h"
#include "benchmarks/suite/planning.h"
#include "benchmarks/suite/record.h"
#include "benchmarks/suite/trial_stages.h"
#include "benchmarks/support/resources.h"
#include "planner/plan/path/check_path.h"
#include "sim/base/formatted.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_library.h"
#include "sim/trial/approach_line.h"
#include "sim/trial/run_trial.h"

namespace prehend::bench {
namespace {

using benchmark::processor_milliseconds;

double percent(std::size_t part, std::size_t whole) {
  return 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

void record_shares(const std::string& series, const StageSeconds& stages, Record& record) {
  const double whole = std::accumulate(stages.begin(), stages.end(), 0.0);
  if (!(whole > 0.0)) return;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    record.add(std::string(kShareOf) + kTrialStages.at(i), series, "%",
               100.0 * stages.at(i) / whole);
  }
}

// Every candidate once, on this thread.
void measure_hand(const std::string& series, const CompiledScene& scene, int count,
                  Record& record) {
  record.say(series);
  const AccuracySetting setting = standard_setting();
  const std::vector<Candidate> candidates = propose(scene, count);
  std::vector<double> in_contact;  // ms
  double all = 0.0;                // ms
  std::size_t holding = 0;
  StageSeconds stages{};
  for (const Candidate& candidate : candidates) {
    std::optional<Trial> trial;
    const double took = processor_milliseconds(
        [&] { trial.emplace(run_trial(scene, candidate, setting.options.trial)); });
    all += took;
    if (trial->outcome == Outcome::stable) ++holding;
    if (trial->contacts.empty()) continue;
    in_contact.push_back(took);
    const StageSeconds once = stage_seconds(scene, candidate, *trial, setting.options.trial);
    std::transform(stages.begin(), stages.end(), once.begin(), stages.begin(), std::plus<>());
  }
  if (candidates.empty() || !(all > 0.0)) return;
  record.add(kTrialTime, series, "ms", in_contact);
  record.add(kInContact, series, "%", percent(in_contact.size(), candidates.size()));
  record.add(kHolds, series, "%", percent(holding, candidates.size()));
  record.add(kTriedPerSecond, series, "1/s", 1e3 * static_cast<double>(candidates.size()) / all);
  record.add(kHoldingPerSecond, series, "1/s", 1e3 * static_cast<double>(holding) / all);
  record_shares(series, stages, record);
}

void measure_paths_of(const std::string& name, const Sizes& sizes, Record& record) {
  record.say("paths, " + name);
  const CompiledScene scene = compile(load_scene(find_scene(name)));
  std::vector<double> reaches;
  std::vector<double> paths;
  std::vector<double> checks;
  std::vector<double> motions;
  for (const ScoredGrasp& grasp : best_grasps(scene, sizes.path_trials, sizes.paths)) {
    reaches.push_back(processor_milliseconds([&] {
      (void)find_reach(*scene.arm, approach_line(scene, grasp.candidate, grasp.trial), {});
    }));
    std::optional<GraspPath> path;
    const double planned = processor_milliseconds(
        [&] { path = plan_grasp_path(scene, grasp.candidate, grasp.trial); });
    if (!path) continue;
    paths.push_back(planned);
    motions.push_back(path->motion.times.back());
    checks.push_back(processor_milliseconds([&] { (void)check_path(scene, path->motion); }));
  }
  record.add(kReach, name, "ms", reaches);
  record.add(kPath, name, "ms", paths);
  record.add(kPathCheck, name, "ms", checks);
  // Not a time that planning takes: no unit of time, so that comparisons do not judge it as one.
  record.add(kMotion, name, "s of motion", motions);
}

}  // namespace

void measure_trials(const Sizes& sizes, std::vector<Entry>& entries) {
  Record record(kTrials, entries);
  for (const std::string& hand : sizes.hands) {
    for (const std::string& object : sizes.objects) {
      measure_hand(formatted("%s, %s", hand.c_str(), object.c_str()),
                   object_scene(object, 5000, hand), sizes.trials, record);
    }
  }
  for (const std::string& name : sizes.arm_scenes) {
    measure_hand("arm, " + name, compile(load_scene(find_scene(name))), sizes.trials, record);
  }
}

void measure_paths(const Sizes& sizes, std::vector<Entry>& entries) {
  Record record(kTrials, entries);
  for (const std::string& name : sizes.arm_scenes) measure_paths_of(name, sizes, record);
}

}  // namespace prehend::bench
