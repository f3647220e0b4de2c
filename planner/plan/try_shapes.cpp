#include "planner/plan/try_shapes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "planner/plan/cut_short.h"
#include "planner/plan/run_trials.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"

namespace prehend {
namespace {

// The scene with another surface of its object; nothing where that overlaps an obstacle.
std::optional<CompiledScene> with_shape(const CompiledScene& scene, const TriangleMesh& shape,
                                        const RunContext& context) {
  if (shape.empty()) return {};
  Scene changed = scene.scene;
  changed.object.mesh = shape;
  changed.object.completion.reset();
  try {
    return compile(std::move(changed), context);
  } catch (const InputError&) {
    return {};
  }
}

// Whether each candidate holds. Throws Cancelled where not all were tried.
std::vector<bool> held_on(const CompiledScene& scene, const std::vector<Candidate>& candidates,
                          const TrialOptions& options, const RunContext& context) {
  std::vector<bool> held;
  for (const std::optional<Trial>& trial : run_trials(scene, candidates, options, context)) {
    if (!trial) throw Cancelled();
    held.push_back(trial->outcome == Outcome::stable);
  }
  return held;
}

}  // namespace

void try_shapes(const CompiledScene& scene, const PlanOptions& options, const RunContext& context,
                PlanResult& result) {
  const std::optional<Completion>& completion = scene.scene.object.completion;
  if (!completion || result.grasps.empty()) return;
  const double most = std::round(options.rank.pool * static_cast<double>(options.rank.top));
  const auto count =
      static_cast<std::size_t>(std::min(most, static_cast<double>(result.grasps.size())));
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < count; ++i) candidates.push_back(result.grasps[i].candidate);
  RunContext quiet = context;
  quiet.progress = {};
  std::vector<HeldShapes> shapes(count);
  for (std::size_t i = 0; i < count; ++i) {
    shapes[i].likely = result.grasps[i].trial.outcome == Outcome::stable;
  }
  try {
    const auto fill = [&](const TriangleMesh& shape, std::optional<bool> HeldShapes::*which) {
      if (is_over(context)) throw Cancelled();
      const std::optional<CompiledScene> other = with_shape(scene, shape, context);
      if (!other) return;
      const std::vector<bool> held = held_on(*other, candidates, options.trial, quiet);
      for (std::size_t i = 0; i < count; ++i) shapes[i].*which = held[i];
    };
    fill(completion->thin, &HeldShapes::thin);
    fill(completion->thick, &HeldShapes::thick);
  } catch (const Cancelled&) {
    result.status = cut_short(context);
    return;
  }
  for (std::size_t i = 0; i < count; ++i) result.grasps[i].shapes = shapes[i];
  const auto place = [](const ScoredGrasp& grasp) {
    return std::tuple(grasp.trial.preferred, grasp.shapes->held());
  };
  std::stable_sort(result.grasps.begin(),
                   result.grasps.begin() + static_cast<std::ptrdiff_t>(count),
                   [&](const ScoredGrasp& a, const ScoredGrasp& b) { return place(a) > place(b); });
}

}  // namespace prehend
