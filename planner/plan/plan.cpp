#include "planner/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <tuple>
#include <utility>

#include "planner/plan/cut_short.h"
#include "planner/plan/find_advice.h"
#include "planner/plan/find_paths.h"
#include "planner/plan/measure_grasps.h"
#include "planner/plan/object_primitives.h"
#include "planner/plan/perturb_grasps.h"
#include "planner/plan/run_trials.h"
#include "planner/plan/search_settings.h"
#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/base/require_settings.h"

namespace prehend {
namespace {

// plan() runs the stages primitives, trials (which propose their candidates as they go), ranking,
// paths and volumes one after the other; trials, paths and volumes are computed in parallel.
// evaluate() starts at the trials. A cancelled stage leaves what it has finished in the result, and
// the stages behind it are skipped or end at once. A deadline ends the trials early enough for the
// stages behind them.

// The parts of the time left for trials and, behind them, for the refinement: without and with
// paths that follow.
struct TimeShares {
  double trials = 0.7;
  double refinement = 0.5;
};
constexpr TimeShares kSharesWithPaths = {0.4, 0.2};

// A refined grasp that gains less than this part of its parent's epsilon is no other grasp.
constexpr double kLeastGain = 0.01;

// A refinement takes at most this part of the number of trials.
constexpr double kRefinementPart = 0.4;

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
    ++result.outcomes[trial.outcome];
    result.trial_seconds.reach += trial.seconds.reach;
    result.trial_seconds.approach += trial.seconds.approach;
    result.trial_seconds.close += trial.seconds.close;
    const CollisionNames why = collision_of(scene, trial);
    result.tried.push_back(
        {static_cast<int>(c), candidates[c].X_OH, candidates[c].approach_O, trial.outcome, why});
    if (!why.by.empty()) ++blocked[{trial.outcome, why.link, why.by}];
  }
  for (const auto& [what, count] : blocked) {
    const auto& [outcome, link, by] = what;
    result.blockers.push_back({outcome, link, by, count});
  }
  std::stable_sort(
      result.blockers.begin(), result.blockers.end(),
      [](const CollisionCount& a, const CollisionCount& b) { return a.count > b.count; });
}

// Counts of the stages of a trial. Stages that the scene does not need are left out: reach without
// an arm, obstacles where there are none.
void add_trial_stages(const CompiledScene& scene, PlanResult& result) {
  const int total = static_cast<int>(result.tried.size());
  const auto count_of = [&](Outcome outcome) { return result.outcomes[outcome]; };
  if (scene.arm) {
    // For a hand that is blocked on its way the arm is not asked.
    const int lost = count_of(Outcome::unreachable) + count_of(Outcome::arm_blocked) +
                     count_of(Outcome::hand_blocked) + count_of(Outcome::approach_blocked);
    result.stages.push_back({PlanCount::reach, total - lost});
  }
  if (scene.has_obstacles()) {
    result.stages.push_back({PlanCount::obstacles, static_cast<int>(scene.obstacles().size())});
  }
  result.stages.push_back({PlanCount::trials, total});
}

// The stages of plan(), each of which adds to the result.
class PlanRun {
 public:
  PlanRun(const CompiledScene& scene, const PlanOptions& options, const RunContext& context,
          const FoundListener& found)
      : scene_(scene), options_(options), context_(context), found_(found) {}

  // plan() does not throw Cancelled: from here on it returns what it has.
  PlanResult run() {
    try {
      find_primitives();
      search();
      refine();
    } catch (const Cancelled&) {
      result_.status = PlanStatus::cancelled;
    }
    record();
    rank_trials();
    shortlist();
    count(PlanCount::ranked, result_.grasps.size());
    // A plan that was cancelled during the trials returns its ranked grasps without paths.
    if (goes_on() && options_.paths) {
      find_paths(scene_, options_, context_, result_);
      count(PlanCount::paths, result_.grasps.size());
      watch_.lap(Stage::paths);
    }
    if (result_.grasps.empty() && !is_over(context_)) explain();
    if (goes_on() && options_.robustness && options_.rank.by == RankBy::epsilon) {
      perturb_grasps(scene_, options_.trial, options_.uncertainty, options_.seed, context_,
                     result_);
      watch_.lap(Stage::disturb);
    }
    WantedMeasures wanted{.sections = options_.sections};
    if (!options_.volumes) wanted.volumes = 0;
    measure_grasps(scene_, options_.trial, wanted, context_, result_);
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
        object_primitives(scene_, options_.primitives, options_.thin_parts, context_);
    count(given ? PlanCount::primitives_given : PlanCount::primitives, result_.primitives.size());
    watch_.lap(Stage::primitives);
  }

  // Whether stages that take time are still wanted.
  bool goes_on() const { return result_.status != PlanStatus::cancelled && !result_.tried.empty(); }

  void search() {
    context_.cancellation.check();
    const RunContext context = context_until(shares().trials);
    SearchResult found = search_grasps(scene_, result_.primitives, options_.candidates,
                                       options_.search, options_.trial, context, found_);
    result_.smallest_width = found.smallest_width;
    result_.largest_opening = found.largest_opening;
    result_.families = found.families;
    result_.families_untested = found.families_untested;
    result_.status = status_of(found);
    proposed_ = std::move(found.proposed);
    finished_.trials = std::move(found.trials);
    finished_.candidates = std::move(found.candidates);
    watch_.lap(Stage::trials);
  }

  TimeShares shares() const { return options_.paths ? kSharesWithPaths : TimeShares{}; }

  RunContext context_until(double share) const {
    RunContext context = context_;
    context.deadline = context_.deadline.part(share);
    return context;
  }

  // Adds what is better than the best of the search to the trials. Throws Cancelled, and then adds
  // nothing.
  void refine() {
    RefineOptions options = options_.refine;
    options.trials =
        std::min(options.trials,
                 static_cast<int>(kRefinementPart * static_cast<double>(finished_.trials.size())));
    RankOptions ranking = options_.rank;
    ranking.top = options.grasps;
    const std::vector<std::size_t> best = rank(finished_.trials, ranking);
    std::vector<TriedGrasp> grasps;
    for (const std::size_t i : best) {
      grasps.push_back({proposed_[finished_.candidates[i]].candidate, finished_.trials[i]});
    }
    if (refine_trials(grasps.size(), options) == 0) return;
    const RunContext context = context_until(shares().refinement);
    for (RefinedGrasp& refined : refine_grasps(scene_, grasps, options_.trial, options, context)) {
      const std::size_t parent = best[index(refined.parent)];
      if (refined.gain < kLeastGain * finished_.trials[parent].epsilon.lower) continue;
      ProposedGrasp proposed = proposed_[finished_.candidates[parent]];
      proposed.candidate = std::move(refined.candidate);
      refinements_[finished_.trials.size()] = {static_cast<int>(parent), refined.gain,
                                               refined.trials_used};
      finished_.candidates.push_back(proposed_.size());
      finished_.trials.push_back(std::move(refined.trial));
      proposed_.push_back(std::move(proposed));
    }
    watch_.lap(Stage::refine);
  }

  void record() {
    std::vector<Candidate> candidates;
    for (const ProposedGrasp& grasp : proposed_) candidates.push_back(grasp.candidate);
    if (!candidates.empty()) count(PlanCount::candidates, candidates.size());
    record_trials(scene_, candidates, finished_, result_);
    if (result_.status == PlanStatus::complete || !result_.tried.empty()) {
      add_trial_stages(scene_, result_);
    }
    if (!refinements_.empty()) count(PlanCount::refined, refinements_.size());
  }

  PlanStatus status_of(const SearchResult& found) {
    const bool short_of_trials =
        found.end == SearchEnd::out_of_time || found.end == SearchEnd::cancelled;
    if (short_of_trials) {
      const auto made = std::count_if(found.trials.begin(), found.trials.end(),
                                      [](const Trial& t) { return !is_blocked(t.outcome); });
      result_.untested = options_.search.trials - static_cast<int>(made);
      return cut_short(context_);
    }
    if (!found.trials.empty()) return PlanStatus::complete;
    // Otherwise some width is at most the largest opening, but no preshape has a range that
    // contains it, or the rules gave nothing at all.
    const bool too_large =
        std::isfinite(found.smallest_width) && found.smallest_width > found.largest_opening;
    return too_large ? PlanStatus::object_too_large : PlanStatus::no_candidates;
  }

  void rank_trials() {
    if (finished_.trials.empty()) return;
    RankOptions ranking = options_.rank;
    // With paths, all stable grasps are ranked instead of the best few: some may turn out to have
    // no path, and the next in rank takes their place. A cancelled plan does not search for paths.
    if (options_.paths && goes_on()) ranking.top = std::numeric_limits<int>::max();
    if (options_.rank.by != RankBy::epsilon) {
      const double pool = options_.rank.pool * static_cast<double>(options_.rank.top);
      ranking.top = static_cast<int>(std::min(pool, 1e9));
    }
    // Finished trial i is entry i of result_.tried, which ScoredGrasp::tried refers to.
    for (const std::size_t i : rank(finished_.trials, ranking)) {
      const ProposedGrasp& proposed = proposed_[finished_.candidates[i]];
      result_.grasps.push_back({.trial = std::move(finished_.trials[i]),
                                .candidate = proposed.candidate,
                                .primitive = proposed.primitive,
                                .rule = proposed.rule,
                                .tried = static_cast<int>(i)});
      const auto refined = refinements_.find(i);
      if (refined != refinements_.end()) result_.grasps.back().refinement = refined->second;
    }
    watch_.lap(Stage::rank);
  }

  // Of grasps that are not ranked by epsilon, more than wanted are tried with errors.
  void shortlist() {
    if (options_.rank.by == RankBy::epsilon || !goes_on()) return;
    // Some may turn out to have no path: then none is dropped.
    const int top = options_.paths ? static_cast<int>(result_.grasps.size()) : options_.rank.top;
    shortlist_grasps(scene_, options_.trial, options_.uncertainty, options_.seed, options_.rank.by,
                     top, context_, result_);
    watch_.lap(Stage::disturb);
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
      ++known->outcomes[tried.outcome];
    }
    try {
      result_.advice = find_advice(scene_, options_, result_, finished_.trials, context_);
    } catch (const Cancelled&) {
      result_.advice.clear();
    }
  }

  const CompiledScene& scene_;
  const PlanOptions& options_;
  const RunContext& context_;
  const FoundListener& found_;
  std::vector<ProposedGrasp> proposed_;
  Finished finished_;  // trials of all of them; those of ranked grasps are in the result
  std::map<std::size_t, Refinement> refinements_;  // of trials that a refinement found
  PlanResult result_;
  Stopwatch watch_;
};

}  // namespace

PlanResult plan(const CompiledScene& scene, const PlanOptions& options, const RunContext& context,
                const FoundListener& found) {
  require_settings(options);
  if (options.paths && !scene.arm) {
    throw InputError({scene.scene.name, "robot", "no arm to plan paths for, the hand flies free"});
  }
  if (options.rank.by != RankBy::epsilon && !options.robustness) {
    throw InputError({.field = "rank.by", .problem = "needs the trials with errors (robustness)"});
  }
  return PlanRun(scene, search_settings(options), context, found).run();
}

PlanResult evaluate(const CompiledScene& scene, const std::vector<Candidate>& candidates,
                    const EvaluateOptions& options, const RunContext& context) {
  require_settings(options);
  PlanResult result;
  if (candidates.empty()) result.status = PlanStatus::no_candidates;
  Stopwatch watch;
  // As search_settings does for plan().
  TrialOptions trial = options.trial;
  trial.reach.kinematics.seed = derived_seed(options.seed);
  Finished finished = finished_of(run_trials(scene, candidates, trial, context));
  result.untested = static_cast<int>(candidates.size() - finished.trials.size());
  if (result.untested > 0) result.status = cut_short(context);
  record_trials(scene, candidates, finished, result);
  add_trial_stages(scene, result);
  for (std::size_t i = 0; i < finished.trials.size(); ++i) {
    result.grasps.push_back({.trial = std::move(finished.trials[i]),
                             .candidate = candidates[finished.candidates[i]],
                             .rule = "given",
                             .tried = static_cast<int>(i)});
  }
  watch.lap(Stage::trials);
  if (options.robustness && result.status == PlanStatus::complete) {
    perturb_grasps(scene, options.trial, options.uncertainty, options.seed, context, result);
    watch.lap(Stage::disturb);
  }
  measure_grasps(scene, options.trial, {options.volumes, options.sections}, context, result);
  watch.lap(Stage::volumes);
  result.times = watch.laps();
  return result;
}

namespace {

// Three digits, and all there are from a metre on.
std::string in_millimetres(double length) {
  const double number = 1000.0 * length;
  return formatted(number < 999.5 ? "%.3g mm" : "%.0f mm", number);
}

}  // namespace

std::string no_candidates_text(const CompiledScene& scene, const PlanResult& result) {
  std::ostringstream message;
  message << scene.scene.object.name << unit_hint(scene.scene.object)
          << ": no grasp to try with hand " << scene.scene.hand.name;
  if (std::isfinite(result.smallest_width)) {
    message << ": the smallest size to close on is " << in_millimetres(result.smallest_width)
            << ", the hand opens to " << in_millimetres(result.largest_opening);
  }
  // The words above end with the hint about the unit.
  for (const Advice& advice : result.advice) {
    if (advice.hint != Hint::unit) message << "; try " << advice.words;
  }
  return message.str();
}

}  // namespace prehend
