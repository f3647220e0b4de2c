#include "planner/plan/shake_grasps.h"

#include <algorithm>

#include "planner/plan/cut_short.h"
#include "sim/base/parallel/parallel.h"
#include "sim/manipulation/shake.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {
namespace {

bool has_closed(const Trial& trial) {
  return trial.outcome == Outcome::stable || trial.outcome == Outcome::not_force_closure;
}

// Of the tests; a grasp that failed in the preparation survived none.
double share_survived(const ScoredGrasp& grasp) {
  if (!grasp.shake) return -1.0;
  const ShakeReport& report = *grasp.shake;
  return static_cast<double>(report.survived()) / std::max(1, report.count());
}

}  // namespace

void shake_grasps(const CompiledScene& scene, const TestProcedure& procedure,
                  const RunContext& context, PlanResult& result) {
  const std::shared_ptr<const RobotModel> hand = hand_model(scene);
  for_each_in_parallel(result.grasps.size(), context.threads, [&](std::size_t i) {
    ScoredGrasp& grasp = result.grasps[i];
    if (!has_closed(grasp.trial) || is_over(context)) return;
    try {
      grasp.shake = shake_grasp(scene, hand, posture_of(grasp.trial), procedure, {}, context);
    } catch (const Cancelled&) {
      return;
    }
  });
  const bool all = std::all_of(
      result.grasps.begin(), result.grasps.end(),
      [](const ScoredGrasp& grasp) { return grasp.shake.has_value() || !has_closed(grasp.trial); });
  if (!all) result.status = cut_short(context);
}

void rank_by_shake(PlanResult& result) {
  std::stable_sort(result.grasps.begin(), result.grasps.end(),
                   [](const ScoredGrasp& a, const ScoredGrasp& b) {
                     if (a.trial.preferred != b.trial.preferred) return a.trial.preferred;
                     return share_survived(a) > share_survived(b);
                   });
}

}  // namespace prehend
