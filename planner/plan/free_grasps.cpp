#include "planner/plan/free_grasps.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <limits>
#include <mutex>
#include <tuple>
#include <utility>

#include "planner/plan/cut_short.h"
#include "sim/base/index.h"
#include "sim/base/parallel/parallel.h"
#include "sim/motion/dynamic_grasp/scene_world.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/close_dynamic.h"

namespace prehend {
namespace {

constexpr double kFar = 0.02;  // from there on an object is not held firmly [m]

// Fills in ScoredGrasp::free; false where time ran out before.
bool close(const CompiledScene& scene, const std::shared_ptr<const RobotModel>& hand,
           const TrialOptions& options, const RunContext& context, ScoredGrasp& grasp,
           double farthest = std::numeric_limits<double>::infinity()) {
  if (is_over(context)) return false;
  try {
    grasp.free =
        closed_freely(scene, hand, grasp.candidate, grasp.trial, options, context, farthest);
  } catch (const Cancelled&) {
    return false;
  }
  return true;
}

// Whether the object ends in force closure and, where it stood on something, near to there. What is
// only carried, by what it lies on or hangs from, is easily lost, and where an object ends that was
// pushed farther than a finger is wide hangs on its friction with the support.
bool is_firm(const CompiledScene& scene, const ScoredGrasp& grasp) {
  if (!grasp.free || grasp.free->outcome != Outcome::stable) return false;
  return !scene.has_obstacles() || object_moved(scene, *grasp.free) < kFar;
}

// The same; unless the object is held firmly, by the first of these other strategies of the hand
// that does so.
bool close_somehow(const CompiledScene& scene, const std::shared_ptr<const RobotModel>& hand,
                   const std::vector<int>& strategies, const TrialOptions& options,
                   const RunContext& context, ScoredGrasp& grasp) {
  if (!close(scene, hand, options, context, grasp)) return false;
  if (is_firm(scene, grasp) || grasp.candidate.strategy) return true;
  const double farthest = scene.has_obstacles() ? kFar : std::numeric_limits<double>::infinity();
  ScoredGrasp other = grasp;
  for (const int strategy : strategies) {
    other.candidate.strategy = strategy;
    if (!close(scene, hand, options, context, other, farthest)) return true;
    if (!is_firm(scene, other)) continue;
    grasp = std::move(other);
    break;
  }
  return true;
}

class FreeClosing {
 public:
  FreeClosing(const CompiledScene& scene, const PlanOptions& options, const RunContext& context,
              PlanResult& result)
      : scene_(scene),
        options_(options),
        context_(context),
        result_(result),
        hand_(hand_model(scene)),
        wanted_(std::min(options.free_closing, options.rank.top)),
        progress_{Stage::close, 0, wanted_, 0} {}

  void run() {
    if (context_.progress) context_.progress(progress_);
    find_firm();
    if (options_.robustness) close_rest();
    const auto end = result_.grasps.begin() + difference(tried_);
    const bool all = std::all_of(result_.grasps.begin(), end,
                                 [](const ScoredGrasp& grasp) { return grasp.free.has_value(); });
    if (!all || is_over(context_)) result_.status = cut_short(context_);
  }

 private:
  static std::ptrdiff_t difference(std::size_t n) { return static_cast<std::ptrdiff_t>(n); }

  // In groups of as many grasps as are still wanted: what is tried depends on the results of
  // earlier groups only, never on the number of threads.
  void find_firm() {
    const std::size_t wanted = index(wanted_);
    while (firm() < wanted && !is_over(context_)) {
      const std::size_t count = std::min(wanted - firm(), left(wanted_));
      if (count == 0) break;
      const std::vector<int> strategies = helpful_strategies();
      close_next(count, [&](ScoredGrasp& grasp) { try_one(strategies, grasp); });
    }
    sort();
  }

  // Once each, in groups like these, until as many as can be returned keep the object.
  void close_rest() {
    const std::size_t top = index(options_.rank.top);
    while (tried_ < top && !is_over(context_)) {
      const std::size_t count = std::min(top - tried_, left(options_.rank.top));
      if (count == 0) break;
      close_next(count, [&](ScoredGrasp& grasp) {
        close(scene_, hand_, options_.trial, context_, grasp);
      });
      sort();
    }
  }

  template <typename Try>
  void close_next(std::size_t count, const Try& try_it) {
    for_each_in_parallel(count, context_.threads,
                         [&](std::size_t i) { try_it(result_.grasps[tried_ + i]); });
    tried_ += count;
    closed_ += count;
  }

  // How many grasps may still be tried for as many as are wanted.
  std::size_t left(int wanted) const {
    const auto most = static_cast<std::size_t>(options_.rank.pool * wanted);
    return std::min(most - std::min(most, closed_), result_.grasps.size() - tried_);
  }

  bool keeps(const ScoredGrasp& grasp) const {
    return grasp.free && keeps_object(scene_, *grasp.free);
  }

  std::size_t firm() const {
    return static_cast<std::size_t>(
        std::count_if(result_.grasps.begin(), result_.grasps.begin() + difference(tried_),
                      [&](const ScoredGrasp& grasp) { return is_firm(scene_, grasp); }));
  }

  // All, until as many grasps as are wanted were not held firmly by any; then those that helped.
  std::vector<int> helpful_strategies() const {
    const bool all = tried_ - firm() < index(wanted_);
    std::vector<int> strategies;
    const auto count = static_cast<int>(scene_.scene.hand.hand->strategies.size());
    for (int k = 0; k < count; ++k) {
      const bool helped =
          std::any_of(result_.grasps.begin(), result_.grasps.begin() + difference(tried_),
                      [&](const ScoredGrasp& grasp) {
                        return grasp.candidate.strategy == k && is_firm(scene_, grasp);
                      });
      if (all || helped) strategies.push_back(k);
    }
    return strategies;
  }

  void try_one(const std::vector<int>& strategies, ScoredGrasp& grasp) {
    if (!close_somehow(scene_, hand_, strategies, options_.trial, context_, grasp)) return;
    if (!context_.progress || !is_firm(scene_, grasp)) return;
    const std::lock_guard lock(progress_lock_);
    ++progress_.done;
    context_.progress(progress_);
  }

  // Of those that were tried, leaves out those that lose the object.
  void sort() {
    std::vector<ScoredGrasp>& grasps = result_.grasps;
    const auto end = grasps.begin() + difference(tried_);
    const auto keeps_it = [&](const ScoredGrasp& grasp) { return keeps(grasp); };
    if (std::none_of(grasps.begin(), end, keeps_it)) return;
    const auto lost = std::stable_partition(
        grasps.begin(), end, [&](const ScoredGrasp& grasp) { return !grasp.free || keeps(grasp); });
    std::for_each(lost, end, [&](const ScoredGrasp& grasp) { count_as_lost(grasp); });
    if (options_.rank.by == RankBy::epsilon) {
      const auto place = [&](const ScoredGrasp& grasp) {
        return std::tuple(grasp.trial.preferred, is_firm(scene_, grasp),
                          grasp.free ? grasp.free->epsilon.lower : -1.0);
      };
      std::stable_sort(grasps.begin(), lost, [&](const ScoredGrasp& a, const ScoredGrasp& b) {
        return place(a) > place(b);
      });
    }
    tried_ -= static_cast<std::size_t>(end - lost);
    grasps.erase(lost, end);
  }

  // The trial was counted as stable. Each candidate is counted under one outcome only.
  void count_as_lost(const ScoredGrasp& grasp) {
    Tried& tried = result_.tried[index(grasp.tried)];
    --result_.outcomes[tried.outcome];
    tried.outcome = grasp.free->outcome;
    ++result_.outcomes[tried.outcome];
  }

  const CompiledScene& scene_;
  const PlanOptions& options_;
  const RunContext& context_;
  PlanResult& result_;
  std::shared_ptr<const RobotModel> hand_;
  int wanted_;              // firm ones
  std::size_t tried_ = 0;   // of the grasps, the first
  std::size_t closed_ = 0;  // in all, with those that are left out
  std::mutex progress_lock_;
  Progress progress_;
};

}  // namespace

void free_grasps(const CompiledScene& scene, const PlanOptions& options, const RunContext& context,
                 PlanResult& result) {
  FreeClosing(scene, options, context, result).run();
}

void close_freely(const CompiledScene& scene, const TrialOptions& options,
                  const RunContext& context, PlanResult& result) {
  const std::shared_ptr<const RobotModel> hand = hand_model(scene);
  std::atomic<bool> all = true;
  for_each_in_parallel(result.grasps.size(), context.threads, [&](std::size_t i) {
    ScoredGrasp& grasp = result.grasps[i];
    if (grasp.trial.contacts.empty()) return;
    if (!close(scene, hand, options, context, grasp)) all = false;
  });
  if (!all) result.status = cut_short(context);
}

}  // namespace prehend
