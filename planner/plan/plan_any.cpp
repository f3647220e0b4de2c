#include "planner/plan/plan_any.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

#include "planner/plan/cut_short.h"
#include "planner/plan/search_grasps.h"
#include "planner/plan/search_settings.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/success.h"

namespace prehend {
namespace {

// What rank() and the stages behind it order by: larger is better.
std::tuple<bool, double, double> merit(const ScoredGrasp& grasp, RankBy by) {
  double value = grasp.trial.epsilon.lower;
  if (by != RankBy::epsilon && grasp.robustness) {
    value = by == RankBy::success ? success_probability(*grasp.robustness)
                                  : grasp.robustness->probability();
  } else if (grasp.free) {
    value = grasp.free->outcome == Outcome::stable ? grasp.free->epsilon.lower : 0.0;
  }
  return {grasp.trial.preferred, grasp.shapes ? grasp.shapes->certainty : 0.0, value};
}

std::vector<AnyGrasp> merged(const std::vector<PlanResult>& results, RankBy by) {
  std::vector<AnyGrasp> ranked;
  std::vector<std::size_t> next(results.size(), 0);
  while (true) {
    std::size_t best = results.size();
    for (std::size_t s = 0; s < results.size(); ++s) {
      if (next[s] == results[s].grasps.size()) continue;
      if (best == results.size() ||
          merit(results[s].grasps[next[s]], by) > merit(results[best].grasps[next[best]], by)) {
        best = s;
      }
    }
    if (best == results.size()) return ranked;
    ranked.push_back({static_cast<int>(best), static_cast<int>(next[best]++)});
  }
}

// Whether a grasp of the scene's object holds without the obstacles of these names.
bool holds_without(const CompiledScene& scene, const std::vector<std::string>& names,
                   const std::vector<Primitive>& primitives, const PlanOptions& options,
                   const RunContext& context) {
  Scene changed = scene.scene;
  std::erase_if(changed.obstacles, [&](const StaticBody& body) {
    return std::find(names.begin(), names.end(), body.name) != names.end();
  });
  const CompiledScene freed = compile(std::move(changed), context);
  PlanOptions settings = search_settings(options);
  settings.search.enough = 1;
  const SearchResult found = search_grasps(freed, primitives, settings.candidates, settings.search,
                                           settings.trial, context);
  return std::any_of(found.trials.begin(), found.trials.end(),
                     [](const Trial& trial) { return trial.outcome == Outcome::stable; });
}

// Of `others`, those without which the scene has a grasp: one alone if that is enough, else all
// less those that may stay, looked at one after the other. Empty where nothing helps.
std::vector<std::string> blocking(const CompiledScene& scene,
                                  const std::vector<std::string>& others, const PlanResult& result,
                                  const PlanOptions& options, const RunContext& context) {
  const auto holds = [&](const std::vector<std::string>& without) {
    return holds_without(scene, without, result.primitives, options, context);
  };
  if (others.empty() || !holds(others)) return {};
  for (const std::string& other : others) {
    if (holds({other})) return {other};
  }
  std::vector<std::string> needed = others;
  for (const std::string& other : others) {
    std::vector<std::string> fewer = needed;
    std::erase(fewer, other);
    if (holds(fewer)) needed = std::move(fewer);
  }
  return needed;
}

std::vector<std::string> object_names(const std::vector<CompiledScene>& scenes) {
  std::vector<std::string> names;
  for (const CompiledScene& scene : scenes) {
    const std::string& name = scene.scene.object.name;
    require(std::find(names.begin(), names.end(), name) == names.end(),
            {.field = "scenes", .problem = "two have an object of the same name", .value = name});
    names.push_back(name);
  }
  return names;
}

}  // namespace

AnyPlan plan_any(const std::vector<CompiledScene>& scenes, const PlanOptions& options,
                 const RunContext& context) {
  const std::vector<std::string> names = object_names(scenes);
  AnyPlan any;
  for (std::size_t s = 0; s < scenes.size(); ++s) {
    RunContext share = context;
    share.deadline = context.deadline.part(1.0 / static_cast<double>(scenes.size() - s));
    any.results.push_back(plan(scenes[s], options, share));
  }
  any.ranked = merged(any.results, options.rank.by);
  any.first.resize(scenes.size());
  for (std::size_t s = 0; s < scenes.size(); ++s) {
    if (!any.results[s].grasps.empty() || is_over(context)) continue;
    std::vector<std::string> others = names;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(s));
    try {
      any.first[s] = blocking(scenes[s], others, any.results[s], options, context);
    } catch (const Cancelled&) {
      break;
    }
  }
  return any;
}

}  // namespace prehend
