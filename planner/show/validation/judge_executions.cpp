#include "planner/show/validation/judge_executions.h"

#include <algorithm>
#include <limits>

#include "planner/plan/plan.h"
#include "sim/base/index.h"
#include "sim/base/parallel/parallel.h"

namespace prehend {
namespace {

// The volumes come with the weight; without them the weight is computed here.
void add_holdings(const CompiledScene& scene, const RunContext& context,
                  std::vector<ScoredGrasp>& grasps) {
  for_each_in_parallel(grasps.size(), context.threads, [&](std::size_t i) {
    ScoredGrasp& grasp = grasps[i];
    if (grasp.holding || grasp.trial.contacts.empty()) return;
    grasp.holding = payload_margin(scene, grasp.trial, context);
  });
}

}  // namespace

JudgedExecutions judge_executions(const ExecutedGrasps& truth, const std::vector<Score>& scores,
                                  EvaluateOptions options, const RunContext& context) {
  const bool volumes = std::any_of(scores.begin(), scores.end(),
                                   [](const Score& score) { return score.needs_volume; });
  options.robustness = true;
  options.volumes = volumes ? std::numeric_limits<std::size_t>::max() : 0;
  options.sections = 0;
  JudgedExecutions judged;
  judged.scores.assign(scores.size(), std::vector<double>(truth.executions.size(), 0.0));
  for (std::size_t o = 0; o < truth.objects.size(); ++o) {
    std::vector<Candidate> grasps;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < truth.executions.size(); ++i) {
      if (index(truth.executions[i].label.object) != o) continue;
      grasps.push_back(truth.executions[i].grasp);
      places.push_back(i);
    }
    if (grasps.empty()) continue;
    const CompiledScene& scene = truth.objects[o].scene;
    PlanResult result = evaluate(scene, grasps, options, context);
    if (result.status != PlanStatus::complete) throw Cancelled();
    add_holdings(scene, context, result.grasps);
    for (std::size_t s = 0; s < scores.size(); ++s) {
      for (std::size_t i = 0; i < places.size(); ++i) {
        judged.scores[s][places[i]] = scores[s].of(result.grasps[i]);
      }
    }
    for (const Outcome outcome : kAll<Outcome>) {
      judged.outcomes[outcome] += result.outcomes[outcome];
    }
  }
  return judged;
}

}  // namespace prehend
