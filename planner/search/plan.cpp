#include "planner/search/plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <tuple>
#include <utility>

#include "planner/search/find_advice.h"
#include "planner/search/find_paths.h"
#include "planner/search/measure_grasps.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/random.h"

namespace prehend {
namespace {

// plan() runs the stages primitives, candidates, trials, ranking, paths and volumes one after the
// other; trials, paths and volumes are computed in parallel. evaluate() starts at the trials. A
// cancelled stage leaves what it has finished in the result, and the stages behind it are skipped
// or end at once.

// The trials that were finished, each with the place of its candidate.
struct Finished {
  std::vector<Trial> trials;
  std::vector<std::size_t> candidates;
};

Finished finished_of(std::vector<std::optional<Trial>> trials) {
  Finished finished;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (!trials[i]) continue;
    finished.trials.push_back(std::move(*trials[i]));
    finished.candidates.push_back(i);
  }
  return finished;
}

// Enters how every trial ended into the result. Collisions are counted by outcome, link and body.
// The map iterates in the order of these keys, so that blockers with equal counts are listed in the
// same order in every run.
void record_trials(const CompiledScene& scene, const std::vector<Candidate>& candidates,
                   const Finished& finished, PlanResult& result) {
  std::map<std::tuple<Outcome, std::string, std::string>, int> blocked;
  for (std::size_t i = 0; i < finished.trials.size(); ++i) {
    const Trial& trial = finished.trials[i];
    const std::size_t c = finished.candidates[i];
    ++result.outcomes[static_cast<std::size_t>(trial.outcome)];
    result.trial_seconds.reach += trial.seconds.reach;
    result.trial_seconds.approach += trial.seconds.approach;
    result.trial_seconds.close += trial.seconds.close;
    const Blame why = blame(scene, trial);
    result.tried.push_back(
        {static_cast<int>(c), candidates[c].X_OH, candidates[c].approach_O, trial.outcome, why});
    if (!why.by.empty()) ++blocked[{trial.outcome, why.link, why.by}];
  }
  for (const auto& [what, count] : blocked) {
    const auto& [outcome, link, by] = what;
    result.blockers.push_back({outcome, link, by, count});
  }
  std::stable_sort(result.blockers.begin(), result.blockers.end(),
                   [](const Blocker& a, const Blocker& b) { return a.count > b.count; });
}

// Counts of the stages of a trial. Stages that the scene does not need are left out: reach without
// an arm, obstacles where there are none.
void add_trial_stages(const CompiledScene& scene, PlanResult& result) {
  const int total = static_cast<int>(result.tried.size());
  const auto count_of = [&](Outcome outcome) {
    return result.outcomes[static_cast<std::size_t>(outcome)];
  };
  if (scene.arm) {
    // Trials that ended before the arm was asked to follow the approach (hand_blocked,
    // approach_blocked) count as reached: for them only a posture at the pre-grasp was found.
    const int lost = count_of(Outcome::unreachable) + count_of(Outcome::arm_blocked);
    result.stages.push_back({PlanCount::reach, total - lost});
  }
  if (scene.has_obstacles()) {
    result.stages.push_back({PlanCount::obstacles, static_cast<int>(scene.obstacles().size())});
  }
  result.stages.push_back({PlanCount::trials, total});
}

// Runs a trial of each candidate. Counts and outcomes go into `result`, the trials are returned.
Finished try_all(const CompiledScene& scene, const std::vector<Candidate>& candidates,
                 const TrialOptions& options, const RunContext& context, PlanResult& result) {
  Finished finished = finished_of(run_trials(scene, candidates, options, context));
  result.untested = static_cast<int>(candidates.size() - finished.trials.size());
  if (result.untested > 0) result.status = PlanStatus::cancelled;
  record_trials(scene, candidates, finished, result);
  add_trial_stages(scene, result);
  return finished;
}

// The options with every seed in them derived from the one seed of the plan.
PlanOptions with_seeds(PlanOptions options) {
  options.primitives.seed = derived_seed(options.seed);
  options.trial.reach.kinematics.seed = derived_seed(options.seed);
  if (options.paths) {
    options.paths->reach.kinematics.seed = derived_seed(options.seed);
    options.paths->transfer.seed = derived_seed(options.seed);
  }
  return options;
}

// The stages of plan(), each of which adds to the result.
class PlanRun {
 public:
  PlanRun(const CompiledScene& scene, const PlanOptions& options, const RunContext& context)
      : scene_(scene), options_(options), context_(context) {}

  // plan() does not throw Cancelled: from here on it returns what it has.
  PlanResult run() {
    try {
      find_primitives();
      propose();
    } catch (const Cancelled&) {
      result_.status = PlanStatus::cancelled;
    }
    // Cancelled before the trials, or without candidates, there is nothing to try or to rank.
    if (result_.status == PlanStatus::complete) try_and_rank();
    // A plan that was cancelled during the trials returns its ranked grasps without paths.
    if (result_.status == PlanStatus::complete && options_.paths) {
      find_paths(scene_, options_, context_, result_);
      count(PlanCount::paths, result_.grasps.size());
      watch_.lap(Stage::paths);
    }
    if (result_.grasps.empty() && result_.status != PlanStatus::cancelled) explain();
    measure_grasps(scene_, options_.trial, {.sections = options_.sections}, context_, result_);
    watch_.lap(Stage::volumes);
    result_.times = watch_.laps();
    return std::move(result_);
  }

 private:
  void count(PlanCount what, std::size_t number) {
    result_.stages.push_back({what, static_cast<int>(number)});
  }

  void begin(Stage stage) const {
    context_.cancellation.check();
    if (context_.progress) context_.progress({stage, 0, 1, 0});
  }

  void find_primitives() {
    begin(Stage::primitives);
    const bool given = !scene_.scene.primitives.empty();
    result_.primitives =
        given ? scene_.scene.primitives
              : decompose(scene_.scene.object.mesh, options_.primitives, context_).primitives;
    count(given ? PlanCount::primitives_given : PlanCount::primitives, result_.primitives.size());
    watch_.lap(Stage::primitives);
  }

  void propose() {
    begin(Stage::candidates);
    Proposals proposals = propose_grasps(scene_, result_.primitives, options_.candidates, context_);
    result_.smallest_width = proposals.smallest_width;
    result_.largest_opening = proposals.largest_opening;
    proposed_ = std::move(proposals.grasps);
    in_all_ = proposals.in_all;
    if (proposed_.empty()) {
      // Otherwise some width is at most the largest opening, but no preshape has a range that
      // contains it, or the rules gave nothing at all.
      const bool too_large =
          std::isfinite(result_.smallest_width) && result_.smallest_width > result_.largest_opening;
      result_.status = too_large ? PlanStatus::object_too_large : PlanStatus::no_candidates;
      return;
    }
    count(PlanCount::candidates, proposed_.size());
    watch_.lap(Stage::candidates);
  }

  void try_and_rank() {
    std::vector<Candidate> candidates;
    for (const ProposedGrasp& grasp : proposed_) candidates.push_back(grasp.candidate);
    Finished finished = try_all(scene_, candidates, options_.trial, context_, result_);
    watch_.lap(Stage::trials);
    RankOptions ranking = options_.rank;
    // With paths, all stable grasps are ranked instead of the best few: some may turn out to have
    // no path, and the next in rank takes their place. A cancelled plan does not search for paths.
    const bool for_paths = options_.paths && result_.status == PlanStatus::complete;
    if (for_paths) ranking.top = std::numeric_limits<int>::max();
    // Finished trial i is entry i of result_.tried, which ScoredGrasp::tried refers to.
    for (const std::size_t i : rank(finished.trials, ranking)) {
      const ProposedGrasp& proposed = proposed_[finished.candidates[i]];
      result_.grasps.push_back({std::move(finished.trials[i]),
                                proposed.candidate,
                                {},
                                proposed.primitive,
                                proposed.rule,
                                {},
                                {},
                                static_cast<int>(i)});
    }
    count(PlanCount::ranked, result_.grasps.size());
    watch_.lap(Stage::rank);
    if (result_.grasps.empty()) unranked_ = std::move(finished.trials);
  }

  // Says why there is no grasp. A caller who does not wait for advice gets the rest.
  void explain() {
    for (const Tried& tried : result_.tried) {
      const std::string& rule = proposed_[index(tried.candidate)].rule;
      auto known = std::find_if(result_.rules.begin(), result_.rules.end(),
                                [&](const RuleCount& count) { return count.rule == rule; });
      if (known == result_.rules.end()) {
        known = result_.rules.insert(known, {rule, {}});
      }
      ++known->outcomes[static_cast<std::size_t>(tried.outcome)];
    }
    try {
      result_.advice = find_advice(scene_, options_, result_, unranked_, in_all_, context_);
    } catch (const Cancelled&) {
      result_.advice.clear();
    }
  }

  const CompiledScene& scene_;
  const PlanOptions& options_;
  const RunContext& context_;
  std::vector<ProposedGrasp> proposed_;
  int in_all_ = 0;               // number of candidates before they were thinned out
  std::vector<Trial> unranked_;  // all trials, where none is stable
  PlanResult result_;
  Stopwatch watch_;
};

}  // namespace

PlanResult plan(const CompiledScene& scene, const PlanOptions& options, const RunContext& context) {
  if (options.paths && !scene.arm) {
    throw InputError({scene.scene.name, "robot", "no arm to plan paths for, the hand flies free"});
  }
  const PlanOptions seeded = with_seeds(options);
  return PlanRun(scene, seeded, context).run();
}

PlanResult evaluate(const CompiledScene& scene, const std::vector<Candidate>& candidates,
                    const EvaluateOptions& options, const RunContext& context) {
  PlanResult result;
  if (candidates.empty()) result.status = PlanStatus::no_candidates;
  Stopwatch watch;
  // As with_seeds does for plan().
  TrialOptions trial = options.trial;
  trial.reach.kinematics.seed = derived_seed(options.seed);
  Finished finished = try_all(scene, candidates, trial, context, result);
  for (std::size_t i = 0; i < finished.trials.size(); ++i) {
    result.grasps.push_back({std::move(finished.trials[i]),
                             candidates[finished.candidates[i]],
                             {},
                             std::nullopt,
                             "given",
                             {},
                             {},
                             static_cast<int>(i)});
  }
  watch.lap(Stage::trials);
  measure_grasps(scene, options.trial, {options.volumes, options.sections}, context, result);
  watch.lap(Stage::volumes);
  result.times = watch.laps();
  return result;
}

std::string no_candidates_words(const CompiledScene& scene, const PlanResult& result) {
  std::ostringstream message;
  message.precision(3);
  message << scene.scene.object.name << unit_hint(scene.scene.object)
          << ": no grasp to try with hand " << scene.scene.hand.name;
  if (std::isfinite(result.smallest_width)) {
    message << ": the smallest size to close on is " << 1000.0 * result.smallest_width
            << " mm, the hand opens to " << 1000.0 * result.largest_opening << " mm";
  }
  // The words above end with the hint about the unit.
  for (const Advice& advice : result.advice) {
    if (advice.hint != Hint::unit) message << "; try " << advice.words;
  }
  return message.str();
}

}  // namespace prehend
