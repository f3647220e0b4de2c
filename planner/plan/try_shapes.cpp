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

// What a trial adds to the certainty of its grasp: 0 where it does not hold.
double worth_of(const Trial& trial) {
  constexpr double kEnough = 0.02;
  constexpr double kBeyond = 0.2;
  if (trial.outcome != Outcome::stable) return 0.0;
  const double epsilon = trial.epsilon.lower;
  return std::min(epsilon, kEnough) + kBeyond * epsilon;
}

// The worth of each candidate's trial. Throws Cancelled where not all were tried.
std::vector<double> worth_on(const CompiledScene& scene, const std::vector<Candidate>& candidates,
                             const TrialOptions& options, const RunContext& context) {
  std::vector<double> worth;
  for (const std::optional<Trial>& trial : run_trials(scene, candidates, options, context)) {
    if (!trial) throw Cancelled();
    worth.push_back(worth_of(*trial));
  }
  return worth;
}

// The candidates with the hand moved, in the object's frame.
std::vector<Candidate> moved_by(const Vector3& move_O, std::vector<Candidate> candidates) {
  for (Candidate& candidate : candidates) candidate.X_OH = translation(move_O) * candidate.X_OH;
  return candidates;
}

}  // namespace

void try_shapes(const CompiledScene& scene, const PlanOptions& options, const RunContext& context,
                PlanResult& result) {
  const std::optional<Completion>& completion = scene.scene.object.completion;
  constexpr double kWrong = 0.003;  // [m]
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
    shapes[i].certainty = worth_of(result.grasps[i].trial);
  }
  try {
    const auto fill = [&](const TriangleMesh& shape, std::optional<bool> HeldShapes::*which) {
      if (is_over(context)) throw Cancelled();
      const std::optional<CompiledScene> other = with_shape(scene, shape, context);
      if (!other) return;
      const std::vector<double> worth = worth_on(*other, candidates, options.trial, quiet);
      for (std::size_t i = 0; i < count; ++i) {
        shapes[i].*which = worth[i] > 0.0;
        shapes[i].certainty += worth[i];
      }
    };
    fill(completion->thin, &HeldShapes::thin);
    fill(completion->thick, &HeldShapes::thick);
    for (int axis = 0; axis < 3; ++axis) {
      for (const double move : {kWrong, -kWrong}) {
        if (is_over(context)) throw Cancelled();
        const std::vector<double> worth =
            worth_on(scene, moved_by(move * Vector3::Unit(axis), candidates), options.trial, quiet);
        for (std::size_t i = 0; i < count; ++i) shapes[i].certainty += worth[i];
      }
    }
  } catch (const Cancelled&) {
    result.status = cut_short(context);
    return;
  }
  for (std::size_t i = 0; i < count; ++i) result.grasps[i].shapes = shapes[i];
  const auto place = [](const ScoredGrasp& grasp) {
    return std::tuple(grasp.trial.preferred, grasp.shapes->certainty);
  };
  std::stable_sort(result.grasps.begin(),
                   result.grasps.begin() + static_cast<std::ptrdiff_t>(count),
                   [&](const ScoredGrasp& a, const ScoredGrasp& b) { return place(a) > place(b); });
}

}  // namespace prehend
