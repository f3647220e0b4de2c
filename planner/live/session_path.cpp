#include <utility>

#include "planner/live/session.h"
#include "sim/base/input_error.h"
#include "sim/base/random.h"

// How a session finds the robot's way to the grasp in hand.
namespace prehend {

void Session::start_path(std::uint64_t seed, bool lift, const PlanListener& listener) {
  require_no_plan();
  GraspPathOptions options;
  options.reach.kinematics.seed = derived_seed(seed);
  options.transfer.seed = derived_seed(seed);
  if (!lift) options.lift.height = 0.0;
  TriedGrasp grasp = grasp_in_hand();
  path_ = std::make_unique<PlannedPath>(PlannedPath{state_.world, state_.hand, {}});
  path_job_ = std::make_unique<PathJob>(state_.world, std::move(grasp), options, listener);
}

std::optional<Cancellation> Session::path_cancellation() const {
  if (!path_job_) return std::nullopt;
  return path_job_->cancellation();
}

PathEnd Session::finish_path() {
  require(is_finding_path(), {.field = "command", .problem = "no path is looked for"});
  const std::unique_ptr<PathJob> job = std::move(path_job_);
  const std::unique_ptr<PlannedPath> path = std::move(path_);
  try {
    path->playback = job->take();
  } catch (const InputError& error) {
    path->playback.problem = error.what();
  } catch (const Cancelled&) {
    return PathEnd::cancelled;
  }
  path_ = std::make_unique<PlannedPath>(std::move(*path));
  return path_->playback.found ? PathEnd::found : PathEnd::not_found;
}

void Session::give_up_path() {
  path_job_.reset();
  path_.reset();
}

const PlannedPath& Session::path() const {
  const bool is_there = path_ != nullptr && !is_finding_path();
  require(is_there, {.field = "command", .problem = "no path was found yet: path.plan"});
  require(path_->world == state_.world && is_same(path_->hand, state_.hand),
          {.field = "command",
           .problem = "the hand or the scene have changed since the path was asked for"});
  return *path_;
}

PlannedPath Session::path_of(std::size_t result) const {
  const ScoredGrasp& scored = result_at(result);
  require(
      scored.path.has_value(),
      {.field = "grasp", .problem = "was planned without a path", .value = std::to_string(result)});
  const HandPosture hand{hand_in_scene(scored.trial), scored.trial.dofs, scored.trial.joints};
  return {state_.world, hand,
          played_path(state_.world->compiled(), {scored.candidate, scored.trial},
                      {*scored.path, scored.lift})};
}

}  // namespace prehend
