#include "planner/search/plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <tuple>
#include <utility>

#include "sim/base/input_error.h"
#include "sim/parallel/parallel.h"
#include "sim/quality/wrench_hull.h"

namespace prehend {
namespace {

[[noreturn]] void fail_without_candidates(const CompiledScene& scene, const Proposals& proposals) {
  std::ostringstream message;
  message.precision(3);
  message << scene.scene.object.name << ": no grasp to try with hand " << scene.scene.hand.name;
  if (std::isfinite(proposals.smallest_width)) {
    message << ": the smallest size to close on is " << 1000.0 * proposals.smallest_width
            << " mm, the hand opens to " << 1000.0 * proposals.largest_opening << " mm";
  }
  throw InputError(message.str());
}

void record_trials(const CompiledScene& scene, const std::vector<Candidate>& candidates,
                   const std::vector<Trial>& trials, PlanResult& result) {
  std::map<std::tuple<Outcome, std::string, std::string>, int> blocked;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const Trial& trial = trials[i];
    ++result.outcomes[static_cast<std::size_t>(trial.outcome)];
    result.trial_seconds.reach += trial.seconds.reach;
    result.trial_seconds.approach += trial.seconds.approach;
    result.trial_seconds.close += trial.seconds.close;
    const Blame why = blame(scene, trial);
    result.tried.push_back({candidates[i].X_OH, candidates[i].approach_O, trial.outcome, why});
    if (!why.by.empty()) ++blocked[{trial.outcome, why.link, why.by}];
  }
  for (const auto& [what, count] : blocked) {
    const auto& [outcome, link, by] = what;
    result.blockers.push_back({outcome, link, by, count});
  }
  std::stable_sort(result.blockers.begin(), result.blockers.end(),
                   [](const Blocker& a, const Blocker& b) { return a.count > b.count; });
}

// What the trials of this scene had to do: a stage that a scene does not ask for is not there.
void add_trial_stages(const CompiledScene& scene, PlanResult& result) {
  int total = 0;
  for (const int count : result.outcomes) total += count;
  const auto count_of = [&](Outcome outcome) {
    return result.outcomes[static_cast<std::size_t>(outcome)];
  };
  if (scene.arm) {
    const int lost = count_of(Outcome::unreachable) + count_of(Outcome::arm_blocked);
    result.stages.push_back({"reach", total - lost});
  }
  if (scene.has_obstacles()) {
    result.stages.push_back({"obstacles", static_cast<int>(scene.obstacles.size())});
  }
  result.stages.push_back({"trials", total});
}

// The full hull, for those grasps only that will be shown.
void add_volumes(const CompiledScene& scene, const RunTrialsOptions& options, std::size_t sections,
                 PlanResult& result) {
  for_each_in_parallel(result.grasps.size(), options.threads, [&](std::size_t i) {
    ScoredGrasp& grasp = result.grasps[i];
    if (grasp.trial.outcome != Outcome::stable) return;
    const WrenchHull hull = wrench_hull(contact_wrenches(
        contacts_of(grasp.trial.contacts), scene.wrench_frame, options.trial.cone_edges));
    grasp.volume = hull.volume;
    if (i < sections) grasp.sections = wrench_sections(hull.points);
  });
}

// Paths for the best grasps, in groups of as many as are still wanted, so that the answer does not
// depend on the threads. Grasps without a path go.
void add_paths(const CompiledScene& scene, const PlanOptions& options, PlanResult& result) {
  std::vector<ScoredGrasp> all = std::move(result.grasps);
  result.grasps.clear();
  const auto wanted = static_cast<std::size_t>(options.rank.top);
  std::size_t next = 0;
  while (next < all.size() && result.grasps.size() < wanted) {
    const std::size_t count = std::min(wanted - result.grasps.size(), all.size() - next);
    for_each_in_parallel(count, options.trials.threads, [&](std::size_t i) {
      ScoredGrasp& grasp = all[next + i];
      GraspPathOptions path = *options.paths;
      path.transfer.seed += next + i;
      grasp.path = plan_grasp_path(scene, grasp.candidate, grasp.trial, path);
    });
    for (std::size_t i = next; i < next + count; ++i) {
      if (all[i].path) {
        result.grasps.push_back(std::move(all[i]));
      } else {
        --result.outcomes[static_cast<std::size_t>(Outcome::stable)];
        ++result.outcomes[static_cast<std::size_t>(Outcome::no_path)];
        result.tried[static_cast<std::size_t>(all[i].tried)].outcome = Outcome::no_path;
      }
    }
    next += count;
  }
}

}  // namespace

PlanResult plan(const CompiledScene& scene, const PlanOptions& options) {
  if (options.paths && !scene.arm) {
    throw InputError(scene.scene.name + ": robot: no arm to plan paths for, the hand flies free");
  }
  PlanResult result;
  Stopwatch watch;
  const bool given = !scene.scene.primitives.empty();
  result.primitives = given ? scene.scene.primitives
                            : decompose(scene.scene.object.mesh, options.primitives).primitives;
  result.stages.push_back(
      {given ? "primitives given" : "primitives", static_cast<int>(result.primitives.size())});
  watch.lap("primitives");

  const Proposals proposals = propose_grasps(scene, result.primitives, options.candidates);
  if (proposals.grasps.empty()) fail_without_candidates(scene, proposals);
  result.stages.push_back({"candidates", static_cast<int>(proposals.grasps.size())});
  watch.lap("candidates");

  std::vector<Candidate> candidates;
  for (const ProposedGrasp& grasp : proposals.grasps) candidates.push_back(grasp.candidate);
  std::vector<Trial> trials = run_trials(scene, candidates, options.trials);
  record_trials(scene, candidates, trials, result);
  add_trial_stages(scene, result);
  watch.lap("trials");

  RankOptions ranking = options.rank;
  if (options.paths) ranking.top = std::numeric_limits<int>::max();  // some may have no path
  for (std::size_t i : rank(trials, ranking)) {
    const ProposedGrasp& proposed = proposals.grasps[i];
    result.grasps.push_back({std::move(trials[i]),
                             proposed.candidate,
                             0.0,
                             proposed.primitive,
                             proposed.rule,
                             {},
                             {},
                             static_cast<int>(i)});
  }
  result.stages.push_back({"ranked", static_cast<int>(result.grasps.size())});
  watch.lap("rank");
  if (options.paths) {
    add_paths(scene, options, result);
    result.stages.push_back({"paths", static_cast<int>(result.grasps.size())});
    watch.lap("paths");
  }
  add_volumes(scene, options.trials, options.sections, result);
  watch.lap("volumes");
  result.times = watch.laps();
  return result;
}

PlanResult evaluate(const CompiledScene& scene, const std::vector<Candidate>& candidates,
                    const RunTrialsOptions& options, std::size_t sections) {
  PlanResult result;
  Stopwatch watch;
  std::vector<Trial> trials = run_trials(scene, candidates, options);
  record_trials(scene, candidates, trials, result);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    result.grasps.push_back(
        {std::move(trials[i]), candidates[i], 0.0, -1, "given", {}, {}, static_cast<int>(i)});
  }
  add_trial_stages(scene, result);
  watch.lap("trials");
  add_volumes(scene, options, sections, result);
  watch.lap("volumes");
  result.times = watch.laps();
  return result;
}

}  // namespace prehend
