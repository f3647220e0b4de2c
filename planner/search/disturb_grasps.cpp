#include "planner/search/disturb_grasps.h"

#include <algorithm>
#include <tuple>

#include "planner/search/cut_short.h"
#include "planner/search/run_trials.h"
#include "sim/base/random.h"
#include "sim/parallel/parallel.h"
#include "sim/trial/success.h"

namespace prehend {
namespace {

using RankKey = std::tuple<double, double, double>;  // larger is better

RankKey probability_key(const Robustness& robustness) {
  return {robustness.probability(), robustness.spare, robustness.epsilon_mean};
}

RankKey success_key(const Robustness& robustness) {
  return {success_probability(robustness), robustness.spare, robustness.epsilon_mean};
}

void rank_by(RankKey (*key)(const Robustness&), PlanResult& result) {
  const auto key_of = [&](const ScoredGrasp& grasp) {
    return grasp.robustness ? key(*grasp.robustness) : RankKey{-1.0, 0.0, 0.0};
  };
  std::stable_sort(
      result.grasps.begin(), result.grasps.end(),
      [&](const ScoredGrasp& a, const ScoredGrasp& b) { return key_of(a) > key_of(b); });
}

}  // namespace

void disturb_grasps(const CompiledScene& scene, const TrialOptions& options,
                    const UncertaintyOptions& uncertainty, std::uint64_t seed,
                    const RunContext& context, PlanResult& result) {
  const std::vector<Disturbance> all = disturbances(scene, uncertainty, derived_seed(seed));
  TrialWorkers workers;
  for_each_in_parallel(result.grasps.size(), context.threads, [&](std::size_t i) {
    ScoredGrasp& grasp = result.grasps[i];
    if (grasp.trial.contacts.empty() || is_over(context)) return;
    try {
      const TrialWorkers::Loan worker(workers);
      grasp.robustness = try_disturbed(scene, grasp.candidate, grasp.trial, options, all,
                                       worker->workspace, context);
    } catch (const Cancelled&) {
      return;
    }
  });
  const bool all_tried =
      std::all_of(result.grasps.begin(), result.grasps.end(), [](const ScoredGrasp& grasp) {
        return grasp.robustness.has_value() || grasp.trial.contacts.empty();
      });
  if (!all_tried) result.status = cut_short(context);
}

void rank_by_probability(PlanResult& result) { rank_by(probability_key, result); }

void rank_by_success(PlanResult& result) { rank_by(success_key, result); }

}  // namespace prehend
