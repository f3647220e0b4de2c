#include "planner/results/datasets/set_candidates.h"

#include <algorithm>

#include "planner/plan/plan_result.h"
#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {

int set_preshape(const Hand& hand, const std::optional<double>& configuration) {
  constexpr double kRounding = 1e-6;  // m
  const std::vector<Preshape>& preshapes = hand.preshapes;
  const auto narrower = [](const Preshape& a, const Preshape& b) {
    return a.max_width < b.max_width;
  };
  auto chosen = std::max_element(preshapes.begin(), preshapes.end(), narrower);
  for (auto preshape = preshapes.begin(); configuration && preshape != preshapes.end();
       ++preshape) {
    const bool wide_enough = preshape->max_width >= *configuration - kRounding;
    if (wide_enough && narrower(*preshape, *chosen)) chosen = preshape;
  }
  return static_cast<int>(chosen - preshapes.begin());
}

std::vector<Candidate> set_candidates(const GraspSet& set, const CompiledScene& scene) {
  const Hand& hand = *scene.scene.hand.hand;
  const int preshape = set_preshape(hand, set.configuration);
  std::vector<Candidate> candidates;
  candidates.reserve(set.grasps.size());
  for (const GraspSetEntry& grasp : set.grasps) {
    Candidate& candidate = candidates.emplace_back();
    candidate.X_OH = grasp.X_OH;
    candidate.approach_O = grasp.X_OH.linear() * hand.approach;
    candidate.preshape = preshape;
  }
  return candidates;
}

std::vector<bool> set_labels(const GraspSet& set) {
  std::vector<bool> labels;
  labels.reserve(set.grasps.size());
  for (const GraspSetEntry& grasp : set.grasps) labels.push_back(grasp.outcome == Outcome::stable);
  return labels;
}

LabelAgreement compare_labels(const std::vector<bool>& labels, const std::vector<Tried>& tried) {
  LabelAgreement agreement;
  for (const Tried& trial : tried) {
    const bool there = labels[index(trial.candidate)];
    const bool here = trial.outcome == Outcome::stable;
    ++(there ? (here ? agreement.both : agreement.there_only)
             : (here ? agreement.here_only : agreement.neither));
  }
  return agreement;
}

std::string agreement_text(const LabelAgreement& agreement) {
  const int trials = agreement.trials();
  const double agree = trials == 0 ? 0.0 : 100.0 * (agreement.both + agreement.neither) / trials;
  return formatted(
      "labels of the file: %d of %d agree (%.1f %%); held there and here %d, there only %d, here "
      "only %d, neither %d",
      agreement.both + agreement.neither, trials, agree, agreement.both, agreement.there_only,
      agreement.here_only, agreement.neither);
}

}  // namespace prehend
