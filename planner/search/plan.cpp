#include "planner/search/plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <span>
#include <sstream>
#include <tuple>
#include <utility>

#include "planner/search/find_advice.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/parallel/parallel.h"
#include "sim/quality/set_hull.h"
#include "sim/quality/wrench_hull.h"
#include "sim/quality/wrench_space.h"
#include "sim/trial/sensitivity.h"

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

struct SpaceHull {
  double volume = 0.0;
  PointHull points;
};

// The full hull of the contacts' pyramids or, where these have many edges, one inside it, whose
// volume is a lower bound.
SpaceHull space_hull_of(std::span<const Contact> contacts, const WrenchFrame& frame, int edges) {
  if (edges <= kMostHullEdges) {
    WrenchHull hull = wrench_hull(contact_wrenches(contacts, frame, edges));
    return {hull.volume, std::move(hull.points)};
  }
  SetHull hull = set_hull(*wrench_space(contacts, frame, {.edges = edges}));
  return {hull.volume_lower, std::move(hull.hull)};
}

// Volumes and sections of the wrench space, for the returned grasps only: the full 6-D hull takes
// much longer than epsilon, which is all that ranking needs. A cancelled run leaves the rest
// without.
struct WantedSpaces {
  std::size_t volumes = std::numeric_limits<std::size_t>::max();  // of the first grasps
  std::size_t sections = 0;
};

void add_volumes(const CompiledScene& scene, const TrialOptions& options,
                 const WantedSpaces& wanted, const RunContext& context, PlanResult& result) {
  const std::size_t count = std::min(wanted.volumes, result.grasps.size());
  for_each_in_parallel(count, context.threads, [&](std::size_t i) {
    if (context.cancellation.requested()) return;
    ScoredGrasp& grasp = result.grasps[i];
    // The volume is defined as 0 without force closure, which needs no hull.
    if (grasp.trial.outcome != Outcome::stable) {
      grasp.volume = 0.0;
      return;
    }
    const std::vector<Contact> contacts = contacts_of(grasp.trial.contacts);
    const SpaceHull hull = space_hull_of(contacts, scene.wrench_frame, options.cone_edges);
    grasp.volume = hull.volume;
    grasp.epsilon_nearby = epsilon_nearby(scene, grasp.trial, options);
    if (i < wanted.sections && !context.cancellation.requested()) {
      grasp.sections = wrench_sections(hull.points);
    }
  });
  const auto is_missing = [&](const ScoredGrasp& grasp) { return !grasp.volume; };
  if (std::any_of(result.grasps.begin(), result.grasps.begin() + static_cast<std::ptrdiff_t>(count),
                  is_missing)) {
    result.status = PlanStatus::cancelled;
  }
}

// Finds paths for the best of the ranked grasps.
class PathSearch {
 public:
  PathSearch(const CompiledScene& scene, const PlanOptions& options, const RunContext& context,
             PlanResult& result)
      : scene_(scene), options_(options), context_(context), result_(result) {}

  // Searches in groups of as many grasps as are still wanted, in the order of their rank. All of a
  // group are searched before the next one begins, so that the same grasps are searched, and the
  // result is the same, on any number of threads. Grasps without a path are left out and counted
  // as Outcome::no_path.
  void run() {
    // result_.grasps is refilled with those that have a path, in the order of their rank.
    all_ = std::move(result_.grasps);
    result_.grasps.clear();
    const std::size_t wanted = std::min(index(options_.rank.top), all_.size());
    progress_ = {Stage::paths, 0, static_cast<int>(wanted), 0};
    if (context_.progress) context_.progress(progress_);
    std::size_t next = 0;
    while (next < all_.size() && result_.grasps.size() < wanted &&
           result_.status != PlanStatus::cancelled) {
      // Depends on results of earlier groups only, never on the number of threads.
      const std::size_t count = std::min(wanted - result_.grasps.size(), all_.size() - next);
      // Bytes instead of vector<bool>, whose elements share words and must not be written by
      // several threads.
      std::vector<std::uint8_t> searched(count, 0);
      for_each_in_parallel(count, context_.threads,
                           [&](std::size_t i) { searched[i] = search(next + i) ? 1 : 0; });
      for (std::size_t i = 0; i < count; ++i) take(all_[next + i], searched[i] != 0);
      next += count;
    }
  }

 private:
  // Plans the path of grasp i; false when it was cancelled. The seed derives from the grasp's rank,
  // not from the thread or the order of the calls.
  bool search(std::size_t i) {
    ScoredGrasp& grasp = all_[i];
    GraspPathOptions path = *options_.paths;
    path.transfer.seed = derived_seed(options_.seed, i);
    try {
      grasp.path = plan_grasp_path(scene_, grasp.candidate, grasp.trial, path, context_);
    } catch (const Cancelled&) {
      return false;
    }
    if (grasp.path && context_.progress) {
      const std::lock_guard lock(progress_lock_);
      ++progress_.done;
      context_.progress(progress_);
    }
    return true;
  }

  // Moves a grasp with a path into the result, or records why it is not there.
  void take(ScoredGrasp& grasp, bool searched) {
    if (!searched) {
      result_.status = PlanStatus::cancelled;
    } else if (grasp.path) {
      result_.grasps.push_back(std::move(grasp));
    } else {
      // The trial was counted as stable. Each candidate is counted under one outcome only.
      --result_.outcomes[static_cast<std::size_t>(Outcome::stable)];
      ++result_.outcomes[static_cast<std::size_t>(Outcome::no_path)];
      result_.tried[index(grasp.tried)].outcome = Outcome::no_path;
    }
  }

  const CompiledScene& scene_;
  const PlanOptions& options_;
  const RunContext& context_;
  PlanResult& result_;
  std::vector<ScoredGrasp> all_;
  std::mutex progress_lock_;
  Progress progress_;
};

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
      PathSearch(scene_, options_, context_, result_).run();
      count(PlanCount::paths, result_.grasps.size());
      watch_.lap(Stage::paths);
    }
    if (result_.grasps.empty() && result_.status != PlanStatus::cancelled) explain();
    add_volumes(scene_, options_.trial, {.sections = options_.sections}, context_, result_);
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
  add_volumes(scene, options.trial, {options.volumes, options.sections}, context, result);
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
