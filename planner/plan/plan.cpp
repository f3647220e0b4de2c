#include "planner/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>

#include "planner/plan/cut_short.h"
#include "planner/plan/find_advice.h"
#include "planner/plan/find_paths.h"
#include "planner/plan/free_grasps.h"
#include "planner/plan/measure_grasps.h"
#include "planner/plan/object_primitives.h"
#include "planner/plan/perturb_grasps.h"
#include "planner/plan/run_trials.h"
#include "planner/plan/search_grasps.h"
#include "planner/plan/search_settings.h"
#include "planner/plan/stopwatch.h"
#include "planner/plan/try_shapes.h"
#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/base/range.h"
#include "sim/base/require_settings.h"
#include "sim/trial/pad_contacts.h"

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

// The grasps that were proposed, and the trials of them that were finished.
struct Attempts {
  std::vector<ProposedGrasp> proposed;
  std::vector<Trial> trials;
  std::vector<std::size_t> candidates;            // of each trial, the index into `proposed`
  std::map<std::size_t, Refinement> refinements;  // of the trials that a refinement found
};

// Enters how every trial ended into the result.
void record_trials(const CompiledScene& scene, const Attempts& attempts, PlanResult& result) {
  for (std::size_t i = 0; i < attempts.trials.size(); ++i) {
    const Trial& trial = attempts.trials[i];
    const std::size_t c = attempts.candidates[i];
    const Candidate& candidate = attempts.proposed[c].candidate;
    ++result.outcomes[trial.outcome];
    result.trial_seconds.reach += trial.seconds.reach;
    result.trial_seconds.approach += trial.seconds.approach;
    result.trial_seconds.close += trial.seconds.close;
    result.tried.push_back({static_cast<int>(c), candidate.X_OH, candidate.approach_O,
                            trial.outcome, collision_of(scene, trial)});
  }
  count_blockers(result);
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

void add_count(PlanCount what, std::size_t number, PlanResult& result) {
  result.stages.push_back({what, static_cast<int>(number)});
}

RunContext until(double share, const RunContext& context) {
  RunContext part = context;
  part.deadline = context.deadline.part(share);
  return part;
}

TimeShares shares(const PlanOptions& options) {
  return options.paths ? kSharesWithPaths : TimeShares{};
}

// Throws Cancelled.
ObjectPrimitives find_primitives(const CompiledScene& scene, const PlanOptions& options,
                                 const RunContext& context) {
  context.cancellation.check();
  if (context.progress) context.progress({Stage::primitives, 0, 1, 0});
  return object_primitives(scene, options.primitives, options.thin_parts, context);
}

bool is_short_of_trials(const SearchResult& found) {
  return found.end == SearchEnd::out_of_time || found.end == SearchEnd::cancelled;
}

PlanStatus status_of(const SearchResult& found, const RunContext& context) {
  if (is_short_of_trials(found)) return cut_short(context);
  if (!found.trials.empty()) return PlanStatus::complete;
  // Otherwise some width is at most the largest opening, but no preshape has a range that
  // contains it, or the rules gave nothing at all.
  const bool too_large =
      std::isfinite(found.smallest_width) && found.smallest_width > found.largest_opening;
  return too_large ? PlanStatus::object_too_large : PlanStatus::no_candidates;
}

// How many of the trials that were asked for a search has not made.
int untested(const SearchResult& found, int trials) {
  if (!is_short_of_trials(found)) return 0;
  const auto made = std::count_if(found.trials.begin(), found.trials.end(),
                                  [](const Trial& t) { return !is_blocked(t.outcome); });
  return trials - static_cast<int>(made);
}

// Searches, enters how that ended into the result, and returns the attempts. Throws Cancelled
// before it begins.
Attempts search(const CompiledScene& scene, const PlanOptions& options, const RunContext& context,
                const FoundListener& listener, PlanResult& result) {
  context.cancellation.check();
  SearchResult found =
      search_grasps(scene, result.primitives, options.candidates, options.search, options.trial,
                    until(shares(options).trials, context), listener, KeptTrials::holding);
  result.smallest_width = found.smallest_width;
  result.largest_opening = found.largest_opening;
  result.families = found.families;
  result.families_untested = found.families_untested;
  result.untested = untested(found, options.search.trials);
  result.status = status_of(found, context);
  return {std::move(found.proposed), std::move(found.trials), std::move(found.candidates), {}};
}

// Which trials a refinement starts from, and how.
struct RefinementPlan {
  std::vector<std::size_t> best;  // indices into Attempts::trials
  RefineOptions options;

  bool is_empty() const { return refine_trials(best.size(), options) == 0; }
};

// The stable trials as rank() orders them, of those that the limit to the approach allows: in the
// end, the hand of a candidate that it allows may point elsewhere. `hand`: as of rank().
std::vector<std::size_t> ranked_trials(const CompiledScene& scene, const PlanOptions& options,
                                       const RankOptions& ranking, const Attempts& attempts,
                                       const Hand* hand = nullptr) {
  const std::optional<ApproachLimit>& limit = options.candidates.approach;
  if (!limit) return rank(attempts.trials, ranking, {}, hand);
  const auto is_allowed = [&](std::size_t i) {
    return allows(*limit, scene, attempts.proposed[attempts.candidates[i]].candidate,
                  attempts.trials[i]);
  };
  return rank(attempts.trials, ranking, is_allowed, hand);
}

RefinementPlan plan_refinement(const CompiledScene& scene, const Attempts& attempts,
                               const PlanOptions& options) {
  RefinementPlan from{{}, options.refine};
  from.options.trials =
      std::min(from.options.trials,
               static_cast<int>(kRefinementPart * static_cast<double>(attempts.trials.size())));
  RankOptions ranking = options.rank;
  ranking.top = from.options.grasps;
  from.best = ranked_trials(scene, options, ranking, attempts);
  return from;
}

// Adds what is better than the best of the attempts. Throws Cancelled, and then adds nothing.
void refine(const CompiledScene& scene, const RefinementPlan& from, const PlanOptions& options,
            const RunContext& context, Attempts& attempts) {
  std::vector<TriedGrasp> grasps;
  for (const std::size_t i : from.best) {
    grasps.push_back({attempts.proposed[attempts.candidates[i]].candidate, attempts.trials[i]});
  }
  for (RefinedGrasp& refined : refine_grasps(scene, grasps, options.trial, from.options,
                                             until(shares(options).refinement, context))) {
    const std::size_t parent = from.best[index(refined.parent)];
    if (refined.gain < kLeastGain * attempts.trials[parent].epsilon.lower) continue;
    ProposedGrasp proposed = attempts.proposed[attempts.candidates[parent]];
    proposed.candidate = std::move(refined.candidate);
    attempts.refinements[attempts.trials.size()] = {static_cast<int>(parent), refined.gain,
                                                    refined.trials_used};
    attempts.candidates.push_back(attempts.proposed.size());
    attempts.trials.push_back(std::move(refined.trial));
    attempts.proposed.push_back(std::move(proposed));
  }
}

// Enters the attempts of a plan into the result.
void record(const CompiledScene& scene, const Attempts& attempts, PlanResult& result) {
  if (!attempts.proposed.empty())
    add_count(PlanCount::candidates, attempts.proposed.size(), result);
  record_trials(scene, attempts, result);
  if (result.status == PlanStatus::complete || !result.tried.empty()) {
    add_trial_stages(scene, result);
  }
  if (!attempts.refinements.empty()) {
    add_count(PlanCount::refined, attempts.refinements.size(), result);
  }
}

// Whether the ranked grasps are closed again on an object that gives way: it has not given way yet.
// Suction cups do not close.
bool closes_freely(const CompiledScene& scene, const PlanOptions& options) {
  return options.free_closing > 0 && !options.trial.formation.dynamic &&
         scene.scene.hand.hand->cups.empty();
}

// How many grasps are ranked. `goes_on`: whether the stages behind the ranking are wanted.
int ranked_grasps(const CompiledScene& scene, const PlanOptions& options, bool goes_on) {
  // With paths, all stable grasps are ranked instead of the best few: some may turn out to have
  // no path, and the next in rank takes their place. A cancelled plan does not search for paths.
  const bool by_epsilon = options.rank.by == RankBy::epsilon;
  if (options.paths && goes_on && by_epsilon) return static_cast<int>(kLargestCount);
  const bool more = goes_on && (closes_freely(scene, options) || scene.scene.object.completion);
  if (by_epsilon && !more) return options.rank.top;
  const double pool = options.rank.pool * static_cast<double>(options.rank.top);
  return static_cast<int>(std::min(pool, kLargestCount));
}

// The grasp of a trial, which it takes. Trial i is entry i of PlanResult::tried.
ScoredGrasp scored(Attempts& attempts, std::size_t i) {
  const ProposedGrasp& proposed = attempts.proposed[attempts.candidates[i]];
  return {.trial = std::move(attempts.trials[i]),
          .candidate = proposed.candidate,
          .primitive = proposed.primitive,
          .rule = proposed.rule,
          .tried = static_cast<int>(i)};
}

// The best grasps of the attempts, whose trials they take.
std::vector<ScoredGrasp> ranked(const CompiledScene& scene, const PlanOptions& options,
                                const RankOptions& ranking, Attempts& attempts) {
  std::vector<ScoredGrasp> grasps;
  const Hand* hand = &*scene.scene.hand.hand;
  for (const std::size_t i : ranked_trials(scene, options, ranking, attempts, hand)) {
    grasps.push_back(scored(attempts, i));
    const auto refined = attempts.refinements.find(i);
    if (refined != attempts.refinements.end()) grasps.back().refinement = refined->second;
  }
  return grasps;
}

// How the candidates of each rule ended, in the order in which the rules were first proposed.
std::vector<RuleCount> rule_counts(const std::vector<Tried>& all,
                                   const std::vector<ProposedGrasp>& proposed) {
  std::vector<RuleCount> rules;
  for (const Tried& tried : all) {
    const std::string& rule = proposed[index(tried.candidate)].rule;
    auto known = std::find_if(rules.begin(), rules.end(),
                              [&](const RuleCount& count) { return count.rule == rule; });
    if (known == rules.end()) known = rules.insert(known, {rule, {}});
    ++known->outcomes[tried.outcome];
  }
  return rules;
}

// Says why there is no grasp. A caller who does not wait for advice gets the rest.
void explain(const CompiledScene& scene, const PlanOptions& options, const RunContext& context,
             const Attempts& attempts, PlanResult& result) {
  result.rules = rule_counts(result.tried, attempts.proposed);
  try {
    result.advice = find_advice(scene, options, result, attempts.trials, context);
  } catch (const Cancelled&) {
    result.advice.clear();
  }
}

// The stages up to the trials. plan() does not throw Cancelled: what was found until then is
// returned, and the status says so.
Attempts find_grasps(const CompiledScene& scene, const PlanOptions& options,
                     const RunContext& context, const FoundListener& listener, PlanResult& result,
                     Stopwatch& watch) {
  Attempts attempts;
  try {
    const bool given = !scene.scene.primitives.empty();
    ObjectPrimitives found = find_primitives(scene, options, context);
    result.primitives = std::move(found.all);
    result.solids = std::move(found.solids);
    add_count(given ? PlanCount::primitives_given : PlanCount::primitives, result.primitives.size(),
              result);
    watch.lap(Stage::primitives);
    attempts = search(scene, options, context, listener, result);
    watch.lap(Stage::trials);
    const RefinementPlan refinement = plan_refinement(scene, attempts, options);
    if (!refinement.is_empty()) {
      refine(scene, refinement, options, context, attempts);
      watch.lap(Stage::refine);
    }
  } catch (const Cancelled&) {
    result.status = PlanStatus::cancelled;
  }
  return attempts;
}

PlanResult plan_in_stages(const CompiledScene& scene, const PlanOptions& options,
                          const RunContext& context, const FoundListener& listener) {
  PlanResult result;
  Stopwatch watch;
  Attempts attempts = find_grasps(scene, options, context, listener, result, watch);
  record(scene, attempts, result);
  // Whether stages that take time are still wanted.
  const auto goes_on = [&] {
    return result.status != PlanStatus::cancelled && !result.tried.empty();
  };
  const bool by_epsilon = options.rank.by == RankBy::epsilon;
  if (!attempts.trials.empty()) {
    RankOptions ranking = options.rank;
    ranking.top = ranked_grasps(scene, options, goes_on());
    result.grasps = ranked(scene, options, ranking, attempts);
    watch.lap(Stage::rank);
  }
  // Of grasps that are not ranked by epsilon, more than wanted are tried with errors. Some may
  // turn out to have no path: then none is dropped.
  if (!by_epsilon && goes_on()) {
    const int top = options.paths ? static_cast<int>(result.grasps.size()) : options.rank.top;
    shortlist_grasps(scene, options.trial, options.uncertainty, options.seed, options.rank.by, top,
                     context, result);
    watch.lap(Stage::disturb);
  }
  if (closes_freely(scene, options) && goes_on() && !result.grasps.empty()) {
    free_grasps(scene, options, context, result);
    add_free_ends(scene, options.trial, context, result);
    if (!by_epsilon) rank_by(options.rank.by, result);
    watch.lap(Stage::close);
  }
  if (scene.scene.object.completion && goes_on() && !result.grasps.empty()) {
    try_shapes(scene, options, context, result);
    watch.lap(Stage::disturb);
  }
  if (!options.paths && result.grasps.size() > index(options.rank.top)) {
    result.grasps.erase(result.grasps.begin() + options.rank.top, result.grasps.end());
  }
  add_count(PlanCount::ranked, result.grasps.size(), result);
  // A plan that was cancelled during the trials returns its ranked grasps without paths.
  if (goes_on() && options.paths) {
    find_paths(scene, options, context, result);
    add_count(PlanCount::paths, result.grasps.size(), result);
    watch.lap(Stage::paths);
  }
  if (result.grasps.empty() && !is_over(context)) {
    explain(scene, options, context, attempts, result);
  }
  if (goes_on() && options.robustness && by_epsilon) {
    perturb_grasps(scene, options.trial, options.uncertainty, options.seed, context, result);
    add_free_ends(scene, options.trial, context, result);
    watch.lap(Stage::disturb);
  }
  WantedMeasures wanted{.sections = options.sections};
  if (!options.volumes) wanted.volumes = 0;
  measure_grasps(scene, options.trial, wanted, context, result);
  watch.lap(Stage::volumes);
  result.times = watch.laps();
  return result;
}

// Hands close in time with drives, which suction cups have not.
void require_closing(const CompiledScene& scene, const TrialOptions& options) {
  if (!options.formation.dynamic || scene.scene.hand.hand->cups.empty()) return;
  throw InputError({scene.scene.hand.name, "cups",
                    "are not simulated: plan without --dynamic (formation.dynamic)"});
}

}  // namespace

PlanResult plan(const CompiledScene& scene, const PlanOptions& options, const RunContext& context,
                const FoundListener& found) {
  require_settings(options);
  require_pads(scene, options.trial);
  require_closing(scene, options.trial);
  if (options.paths && !scene.arm) {
    throw InputError({scene.scene.name, "robot", "no arm to plan paths for, the hand flies free"});
  }
  if (options.rank.by != RankBy::epsilon && !options.robustness) {
    throw InputError({.field = "rank.by", .problem = "needs the trials with errors (robustness)"});
  }
  return plan_in_stages(scene, search_settings(options), context, found);
}

PlanResult evaluate(const CompiledScene& scene, const std::vector<Candidate>& candidates,
                    const EvaluateOptions& options, const RunContext& context) {
  require_settings(options);
  require_pads(scene, options.trial);
  require_closing(scene, options.trial);
  PlanResult result;
  if (candidates.empty()) result.status = PlanStatus::no_candidates;
  Stopwatch watch;
  // As search_settings does for plan().
  TrialOptions trial = options.trial;
  trial.reach.kinematics.seed = derived_seed(options.seed);
  Attempts attempts;
  for (const Candidate& candidate : candidates) {
    attempts.proposed.push_back({.candidate = candidate, .rule = "given"});
  }
  std::vector<std::optional<Trial>> trials = run_trials(scene, candidates, trial, context);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (!trials[i]) continue;
    attempts.trials.push_back(std::move(*trials[i]));
    attempts.candidates.push_back(i);
  }
  result.untested = static_cast<int>(candidates.size() - attempts.trials.size());
  if (result.untested > 0) result.status = cut_short(context);
  record_trials(scene, attempts, result);
  add_trial_stages(scene, result);
  for (std::size_t i = 0; i < attempts.trials.size(); ++i) {
    result.grasps.push_back(scored(attempts, i));
    result.grasps.back().primitive.reset();
  }
  watch.lap(Stage::trials);
  if (options.robustness && result.status == PlanStatus::complete) {
    perturb_grasps(scene, options.trial, options.uncertainty, options.seed, context, result);
    watch.lap(Stage::disturb);
    const bool closes = scene.scene.hand.hand->cups.empty() && !options.trial.formation.dynamic;
    if (closes) close_freely(scene, options.trial, context, result);
    add_free_ends(scene, options.trial, context, result);
    watch.lap(Stage::close);
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
  const bool by_choice =
      std::any_of(result.advice.begin(), result.advice.end(), [](const Advice& advice) {
        return advice.hint == Hint::approach || advice.hint == Hint::keep_out;
      });
  if (!by_choice && std::isfinite(result.smallest_width)) {
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
