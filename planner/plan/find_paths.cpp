#include "planner/plan/find_paths.h"

#include <algorithm>
#include <cstdint>
#include <mutex>
#include <utility>

#include "planner/plan/cut_short.h"
#include "planner/plan/path/second_check.h"
#include "sim/base/index.h"
#include "sim/base/parallel/parallel.h"
#include "sim/base/random.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {
namespace {

class PathSearch {
 public:
  PathSearch(const CompiledScene& scene, const PlanOptions& options, const RunContext& context,
             PlanResult& result)
      : scene_(scene), options_(options), context_(context), result_(result), bodies_(*scene.arm) {}

  // Searches in groups of as many grasps as are still wanted, in the order of their rank. All of a
  // group are searched before the next one begins, so that the same grasps are searched, and the
  // result is the same, on any number of threads. Grasps without a path are left out and counted
  // as Outcome::no_path.
  void run() {
    // result_.grasps is refilled with those that have a path, in the order of their rank.
    all_ = std::move(result_.grasps);
    result_.grasps.clear();
    in_the_way_.resize(all_.size());
    const std::size_t wanted = std::min(index(options_.rank.top), all_.size());
    progress_ = {Stage::paths, 0, static_cast<int>(wanted), 0};
    if (context_.progress) context_.progress(progress_);
    std::size_t next = 0;
    while (next < all_.size() && result_.grasps.size() < wanted && !was_cut_short_) {
      // Depends on results of earlier groups only, never on the number of threads.
      const std::size_t count = std::min(wanted - result_.grasps.size(), all_.size() - next);
      // Bytes instead of vector<bool>, whose elements share words and must not be written by
      // several threads.
      std::vector<std::uint8_t> searched(count, 0);
      for_each_in_parallel(count, context_.threads,
                           [&](std::size_t i) { searched[i] = search(next + i) ? 1 : 0; });
      for (std::size_t i = 0; i < count; ++i) take(next + i, searched[i] != 0);
      next += count;
    }
    count_blockers(result_);
  }

 private:
  // Plans the path of grasp i; false when it was cancelled or not begun in time. The seed derives
  // from the grasp's rank, not from the thread or the order of the calls.
  bool search(std::size_t i) {
    ScoredGrasp& grasp = all_[i];
    GraspPathOptions path = *options_.paths;
    path.transfer.seed = derived_seed(options_.seed, i);
    if (is_over(context_)) return false;
    try {
      // Told of are whole paths, not what each of them tries.
      RunContext own = context_;
      own.progress = {};
      auto found = try_grasp_path(scene_, bodies_, grasp.candidate, grasp.trial, path, own);
      in_the_way_[i] = std::move(found.in_the_way);
      if (found.path) {
        grasp.path = std::move(found.path->motion);
        grasp.lift = found.path->lift;
      }
    } catch (const Cancelled&) {
      return false;
    }
    if (grasp.path && context_.progress) {
      const std::lock_guard lock(progress_lock_);
      ++progress_.done;
      context_.progress(progress_);
    }
    return true;
  }

  // Moves a grasp with a path into the result, or records why it is not there.
  void take(std::size_t i, bool searched) {
    ScoredGrasp& grasp = all_[i];
    if (!searched) {
      was_cut_short_ = true;
      result_.status = cut_short(context_);
    } else if (grasp.path) {
      result_.grasps.push_back(std::move(grasp));
    } else {
      // The trial was counted as stable. Each candidate is counted under one outcome only.
      --result_.outcomes[Outcome::stable];
      ++result_.outcomes[Outcome::no_path];
      Tried& tried = result_.tried[index(grasp.tried)];
      tried.outcome = Outcome::no_path;
      tried.collision_of = std::move(in_the_way_[i]);
    }
  }

  const CompiledScene& scene_;
  const PlanOptions& options_;
  const RunContext& context_;
  PlanResult& result_;
  const SecondCheck bodies_;
  std::vector<ScoredGrasp> all_;
  std::vector<CollisionNames> in_the_way_;  // of each, where it has no path
  bool was_cut_short_ = false;
  std::mutex progress_lock_;
  Progress progress_;
};

}  // namespace

void find_paths(const CompiledScene& scene, const PlanOptions& options, const RunContext& context,
                PlanResult& result) {
  PathSearch(scene, options, context, result).run();
}

}  // namespace prehend
