// Plans of grasps, and of the robot's path to one, that run while the session goes on.
#pragma once

#include <functional>
#include <memory>

#include "planner/live/edited_scene.h"
#include "planner/live/grasp_in_hand.h"
#include "planner/live/job.h"
#include "planner/plan/plan.h"

namespace prehend {

// What is told of a running plan or path, from its own thread; each may be empty.
struct PlanListener {
  std::function<void(const Progress&)> progress = {};
  std::function<void(const Candidate&, const Trial&)> found = {};  // of each stable trial
  std::function<void()> ended = {};                                // take() no longer waits long
};

class PlanJob {
 public:
  // Begins at once. `threads`: 0, one per processor.
  PlanJob(std::shared_ptr<const CompiledScene> scene, const PlanOptions& options, int threads,
          const PlanListener& listener);

  // A flag by which the plan ends soon, with what it has.
  const Cancellation& cancellation() const { return job_.cancellation(); }
  // Waits for the result and takes it, once. Throws what plan() has thrown.
  PlanResult take() { return job_.take(); }

  const CompiledScene& scene() const { return *scene_; }
  const PlanOptions& options() const { return options_; }

 private:
  std::shared_ptr<const CompiledScene> scene_;
  PlanOptions options_;
  Job<PlanResult> job_;
};

// The robot's path to a grasp of a scene.
class PathJob {
 public:
  // Begins at once.
  PathJob(EditedScenePtr world, TriedGrasp grasp, const GraspPathOptions& options,
          const PlanListener& listener);

  // A flag by which the search ends soon, without a path.
  const Cancellation& cancellation() const { return job_.cancellation(); }
  // Waits for the result and takes it, once. Throws what play_grasp has thrown, Cancelled as well.
  GraspPlayback take() { return job_.take(); }

 private:
  Job<GraspPlayback> job_;
};

}  // namespace prehend
