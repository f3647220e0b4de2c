#include "planner/bulk/design/design_series.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/object_friction.h"

namespace prehend {
namespace {

double largest_opening(const Robot& hand) {
  double largest = 0.0;
  for (const Preshape& preshape : hand.hand->preshapes) {
    largest = std::max(largest, preshape.max_width);
  }
  return largest;
}

DesignPoint planned(Scene scene, const PlanOptions& options, const RunContext& context) {
  DesignPoint point{.object = scene.object.name, .opening = largest_opening(scene.hand)};
  const PlanResult result = plan(compile(std::move(scene), context), options, context);
  if (result.status == PlanStatus::cancelled) throw Cancelled();
  for (const ScoredGrasp& grasp : result.grasps) {
    point.epsilon = std::max(point.epsilon, grasp.trial.epsilon.lower);
  }
  point.trials = static_cast<int>(result.tried.size());
  for (const auto& tried : result.tried) point.stable += tried.outcome == Outcome::stable ? 1 : 0;
  return point;
}

void require_one_hand(const std::vector<Scene>& scenes) {
  require(!scenes.empty(), {.field = "objects", .problem = "there is none"});
  for (const Scene& scene : scenes) {
    require(!scene.carrier, {.field = "objects",
                             .problem = "a hand on an arm cannot be varied; name an object, or a "
                                        "scene without arm",
                             .value = scene.name});
    require(scene.hand.name == scenes.front().hand.name,
            {.field = "objects", .problem = "have different hands", .value = scene.hand.name});
  }
}

}  // namespace

std::vector<DesignPoint> design_series(const std::vector<Scene>& scenes,
                                       const HandVariation& variation, const PlanOptions& options,
                                       const RunContext& context) {
  require_one_hand(scenes);
  std::vector<DesignPoint> points;
  std::optional<InputError> first;
  bool any = false;
  for (int i = 0; i < variation.count; ++i) {
    const double value = variation.value(i);
    std::optional<Robot> hand;
    std::string problem;
    try {
      hand = with_measure(scenes.front().hand, variation, value);
      any = true;
    } catch (const InputError& error) {
      if (error.field() == "--vary") throw;
      problem = error.what();
      if (!first) first = error;
    }
    for (const Scene& scene : scenes) {
      context.cancellation.check();
      DesignPoint point{.object = scene.object.name, .problem = problem};
      if (hand) {
        Scene varied = scene;
        varied.hand = *hand;
        if (variation.measure == HandMeasure::friction) set_object_friction(varied, value);
        point = planned(std::move(varied), options, context);
      }
      point.value = value;
      points.push_back(std::move(point));
    }
  }
  if (!any && first) throw InputError(*first);
  return points;
}

}  // namespace prehend
