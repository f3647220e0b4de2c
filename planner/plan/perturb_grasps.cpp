#include "planner/plan/perturb_grasps.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <span>
#include <tuple>
#include <vector>

#include "planner/plan/cut_short.h"
#include "planner/plan/run_trials.h"
#include "sim/base/index.h"
#include "sim/base/parallel/parallel.h"
#include "sim/base/random.h"
#include "sim/trial/close_dynamic.h"
#include "sim/trial/success.h"

namespace prehend {
namespace {

using RankKey = std::tuple<bool, double, double, double>;  // larger is better

// Calls work(grasp, workspace) for all of them, in parallel; false if time ran out before the end.
template <typename Work>
bool for_each_grasp(std::vector<ScoredGrasp>& grasps, const RunContext& context, const Work& work) {
  TrialWorkers workers;
  std::atomic<bool> all = true;
  for_each_in_parallel(grasps.size(), context.threads, [&](std::size_t i) {
    try {
      if (is_over(context)) throw Cancelled();
      const TrialWorkers::Loan worker(workers);
      work(grasps[i], worker->workspace);
    } catch (const Cancelled&) {
      all = false;
    }
  });
  return all;
}

// Whether the hand gets to where it is to close, or only the object is in its way: that may be
// elsewhere.
bool reaches(Outcome outcome) {
  return outcome != Outcome::unreachable && outcome != Outcome::arm_blocked &&
         outcome != Outcome::no_path;
}

// The grasps that stay while the samples are tried, in parts.
class Shortlist {
 public:
  Shortlist(const CompiledScene& scene, const TrialOptions& options,
            const UncertaintyOptions& uncertainty, std::uint64_t seed, std::size_t top,
            const RunContext& context)
      : scene_(scene),
        options_(options),
        perturbations_(perturbations(scene, uncertainty, derived_seed(seed))),
        top_(top),
        context_(context) {}

  // False where time ran out: none has a robustness then.
  bool fill(std::vector<ScoredGrasp>& grasps) const {
    const std::size_t count = perturbations_.size();
    for (std::size_t part = 0; part < kParts; ++part) {
      const std::size_t first = part * count / kParts;
      const std::size_t last = (part + 1) * count / kParts;
      const auto samples = std::span(perturbations_).subspan(first, last - first);
      const bool finished =
          for_each_grasp(grasps, context_, [&](ScoredGrasp& grasp, TrialWorkspace& workspace) {
            if (!grasp.robustness) grasp.robustness.emplace();
            add_samples(scene_, grasp.candidate, grasp.trial, options_, samples, workspace,
                        context_, *grasp.robustness);
          });
      if (!finished) return without_parts(grasps);
      if (part + 1 < kParts) drop(grasps);
    }
    const bool finished =
        for_each_grasp(grasps, context_, [&](ScoredGrasp& grasp, TrialWorkspace& workspace) {
          add_spare(scene_, grasp.candidate, grasp.trial, options_, workspace, context_,
                    *grasp.robustness);
        });
    return finished || without_parts(grasps);
  }

 private:
  static constexpr std::size_t kParts = 4;

  static bool without_parts(std::vector<ScoredGrasp>& grasps) {
    for (ScoredGrasp& grasp : grasps) grasp.robustness.reset();
    return false;
  }

  void drop(std::vector<ScoredGrasp>& grasps) const {
    if (grasps.size() <= top_) return;
    std::vector<double> lower;
    for (const ScoredGrasp& grasp : grasps) lower.push_back(interval_of(grasp).lower);
    const auto last = lower.begin() + static_cast<std::ptrdiff_t>(top_) - 1;
    std::nth_element(lower.begin(), last, lower.end(), std::greater<>());
    std::erase_if(grasps, [&](const ScoredGrasp& grasp) {
      return !grasp.trial.preferred && interval_of(grasp).upper < *last;
    });
  }

  static Interval interval_of(const ScoredGrasp& grasp) {
    return held_interval(grasp.robustness->held, grasp.robustness->samples);
  }

  const CompiledScene& scene_;
  const TrialOptions& options_;
  std::vector<Perturbation> perturbations_;
  std::size_t top_;
  const RunContext& context_;
};

}  // namespace

void perturb_grasps(const CompiledScene& scene, const TrialOptions& options,
                    const UncertaintyOptions& uncertainty, std::uint64_t seed,
                    const RunContext& context, PlanResult& result) {
  const std::vector<Perturbation> all = perturbations(scene, uncertainty, derived_seed(seed));
  const auto disturb = [&](ScoredGrasp& grasp, TrialWorkspace& workspace) {
    if (!reaches(grasp.trial.outcome)) return;
    grasp.robustness =
        try_perturbed(scene, grasp.candidate, grasp.trial, options, all, workspace, context);
  };
  if (!for_each_grasp(result.grasps, context, disturb)) result.status = cut_short(context);
}

void shortlist_grasps(const CompiledScene& scene, const TrialOptions& options,
                      const UncertaintyOptions& uncertainty, std::uint64_t seed, RankBy by, int top,
                      const RunContext& context, PlanResult& result) {
  const Shortlist list(scene, options, uncertainty, seed, index(top), context);
  if (!list.fill(result.grasps)) result.status = cut_short(context);
  rank_by(by, result);
}

void add_free_ends(const CompiledScene& scene, const TrialOptions& options,
                   const RunContext& context, PlanResult& result) {
  for_each_in_parallel(result.grasps.size(), context.threads, [&](std::size_t i) {
    ScoredGrasp& grasp = result.grasps[i];
    if (!grasp.robustness || grasp.robustness->free) return;
    if (options.formation.dynamic) {
      grasp.robustness->free = free_end(scene, grasp.trial);
    } else if (grasp.free) {
      grasp.robustness->free = free_end(scene, *grasp.free);
    }
  });
}

void rank_by(RankBy by, PlanResult& result) {
  const auto key_of = [&](const ScoredGrasp& grasp) {
    if (!grasp.robustness) return RankKey{grasp.trial.preferred, -1.0, 0.0, 0.0};
    const Robustness& robustness = *grasp.robustness;
    const double first =
        by == RankBy::success ? success_probability(robustness) : robustness.probability();
    return RankKey{grasp.trial.preferred, first, robustness.position_margin,
                   robustness.epsilon_mean};
  };
  std::stable_sort(
      result.grasps.begin(), result.grasps.end(),
      [&](const ScoredGrasp& a, const ScoredGrasp& b) { return key_of(a) > key_of(b); });
}

}  // namespace prehend
