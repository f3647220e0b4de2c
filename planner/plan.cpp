#include "planner/plan.h"

#include <cmath>
#include <sstream>

#include "sim/geometry/input_error.h"
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

void count_outcomes(const std::vector<Trial>& trials, PlanResult& result) {
  for (const Trial& trial : trials) ++result.outcomes[static_cast<std::size_t>(trial.outcome)];
}

// The full hull, for those grasps only that will be shown.
void add_volumes(const CompiledScene& scene, const RunTrialsOptions& options, PlanResult& result) {
  for_each_in_parallel(result.grasps.size(), options.threads, [&](std::size_t i) {
    ScoredGrasp& grasp = result.grasps[i];
    if (grasp.trial.outcome != Outcome::stable) return;
    grasp.volume = wrench_hull(contact_wrenches(contacts_of(grasp.trial.contacts),
                                                scene.wrench_frame, options.trial.cone_edges))
                       .volume;
  });
}

}  // namespace

PlanResult plan(const CompiledScene& scene, const PlanOptions& options) {
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
  count_outcomes(trials, result);
  result.stages.push_back({"trials", static_cast<int>(trials.size())});
  watch.lap("trials");

  for (std::size_t i : rank(trials, options.rank)) {
    const ProposedGrasp& proposed = proposals.grasps[i];
    result.grasps.push_back(
        {std::move(trials[i]), proposed.candidate, 0.0, proposed.primitive, proposed.rule});
  }
  add_volumes(scene, options.trials, result);
  result.stages.push_back({"ranked", static_cast<int>(result.grasps.size())});
  watch.lap("rank");
  result.times = watch.laps();
  return result;
}

PlanResult evaluate(const CompiledScene& scene, const std::vector<Candidate>& candidates,
                    const RunTrialsOptions& options) {
  PlanResult result;
  Stopwatch watch;
  std::vector<Trial> trials = run_trials(scene, candidates, options);
  count_outcomes(trials, result);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    result.grasps.push_back({std::move(trials[i]), candidates[i], 0.0, -1, "given"});
  }
  result.stages.push_back({"trials", static_cast<int>(candidates.size())});
  watch.lap("trials");
  add_volumes(scene, options, result);
  watch.lap("volumes");
  result.times = watch.laps();
  return result;
}

}  // namespace prehend
