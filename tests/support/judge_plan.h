// What is promised of a plan as a whole: the order of its grasps, that no two are the same, and
// that its counts add up.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "planner/plan/plan_options.h"
#include "planner/plan/plan_result.h"
#include "tests/support/judge_grasp.h"

namespace prehend::test {

// The same hand pose within both limits; the angle from the trace of R_a^T R_b.
inline bool same_pose(const Pose& a, const Pose& b, const RankOptions& options) {
  const double cosine = 0.5 * ((a.linear().transpose() * b.linear()).trace() - 1.0);
  const double angle = std::acos(std::min(1.0, std::max(-1.0, cosine)));
  return (a.translation() - b.translation()).norm() <= 0.999999 * options.same_distance &&
         angle <= 0.999999 * options.same_angle;
}

inline bool keeps_free(const ScoredGrasp& grasp, const std::optional<Vector3>& center_O) {
  return grasp.free && (grasp.free->outcome == Outcome::stable ||
                        (grasp.free->outcome == Outcome::not_force_closure && center_O));
}

// Grasps that hold a free object in force closure, its centre (if it stood on something) moved by
// less than 20 mm, come first, then the others that keep one, both by the epsilon where it ended;
// then the rest. Those that lose it are in a plan only if none keeps it.
inline bool is_better(const ScoredGrasp& grasp, const ScoredGrasp& other,
                      const std::optional<Vector3>& center_O) {
  const auto place = [&](const ScoredGrasp& of) {
    if (!keeps_free(of, center_O)) return 2;
    const bool near =
        !center_O || (of.free->X_OC && (*of.free->X_OC * *center_O - *center_O).norm() < 0.02);
    return near && of.free->outcome == Outcome::stable ? 0 : 1;
  };
  if (place(grasp) != place(other)) return place(grasp) < place(other);
  return place(grasp) < 2 ? grasp.free->epsilon.lower > other.free->epsilon.lower
                          : grasp.trial.epsilon.lower > other.trial.epsilon.lower;
}

inline void judge_order(const PlanResult& result, const PlanOptions& options,
                        const std::optional<Vector3>& center_O, std::vector<Fault>& faults) {
  if (result.grasps.size() > static_cast<std::size_t>(options.rank.top)) {
    faults.push_back({"rank", "more grasps than were asked for"});
  }
  const bool any_keeps =
      std::any_of(result.grasps.begin(), result.grasps.end(),
                  [&](const ScoredGrasp& grasp) { return keeps_free(grasp, center_O); });
  for (std::size_t i = 0; i < result.grasps.size(); ++i) {
    const Trial& trial = result.grasps[i].trial;
    const std::string name = "grasp " + std::to_string(i);
    if (trial.outcome != Outcome::stable) faults.push_back({"rank", name + " is not stable"});
    if (any_keeps && result.grasps[i].free && !keeps_free(result.grasps[i], center_O)) {
      faults.push_back({"rank", name + " loses a free object, which others keep"});
    }
    if (!result.grasps[i].volume || !(*result.grasps[i].volume > 0.0)) {
      faults.push_back({"rank", name + " has no volume"});
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (is_better(result.grasps[i], result.grasps[k], center_O)) {
        faults.push_back({"rank", name + " is better than grasp " + std::to_string(k)});
      }
      if (same_pose(result.grasps[k].trial.X_OH, trial.X_OH, options.rank)) {
        faults.push_back({"rank", name + " is the same as grasp " + std::to_string(k)});
      }
    }
  }
}

// Every candidate was tried and has one outcome; what was blocked has somebody to blame.
inline void judge_counts(const PlanResult& result, const PlanOptions& options,
                         std::vector<Fault>& faults) {
  EnumArray<Outcome, int> outcomes;
  int unblamed = 0;
  for (const Tried& tried : result.tried) {
    ++outcomes[tried.outcome];
    const bool blocked = tried.outcome == Outcome::hand_blocked ||
                         tried.outcome == Outcome::approach_blocked ||
                         tried.outcome == Outcome::arm_blocked;
    unblamed += blocked && (tried.collision_of.link.empty() || tried.collision_of.by.empty());
  }
  if (outcomes != result.outcomes) faults.push_back({"counts", "outcomes do not add up"});
  if (unblamed > 0) faults.push_back({"counts", "blocked by nobody"});
  // Grasps that a refinement found are behind those of the search.
  int refined = 0;
  for (const StageCount& stage : result.stages) {
    if (stage.what == PlanCount::refined) refined = stage.count;
  }
  const auto counted = std::count_if(result.tried.begin(), result.tried.end(),
                                     [](const Tried& t) { return !is_blocked(t.outcome); });
  if (counted > options.search.trials + refined) {
    faults.push_back({"counts", "more tried than asked for"});
  }
  if (result.untested != 0 || result.status == PlanStatus::cancelled) {
    faults.push_back({"counts", "not complete"});
  }
  if ((result.status == PlanStatus::complete) == result.tried.empty()) {
    faults.push_back({"counts", "status " + std::string(name_of(result.status))});
  }
}

// `center_O`: the centre of mass of an object that stands on something, else nothing.
inline std::vector<Fault> judge_plan(const PlanResult& result, const PlanOptions& options,
                                     const std::optional<Vector3>& center_O) {
  std::vector<Fault> faults;
  judge_order(result, options, center_O, faults);
  judge_counts(result, options, faults);
  return faults;
}

}  // namespace prehend::test
