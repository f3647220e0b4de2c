#include "planner/live/plan_job.h"

#include <utility>

namespace prehend {

PlanJob::PlanJob(std::shared_ptr<const CompiledScene> scene, const PlanOptions& options,
                 int threads, const PlanListener& listener)
    : scene_(std::move(scene)),
      options_(options),
      job_(
          [scene = scene_, options, threads, listener](const Cancellation& cancellation) {
            const RunContext context{threads, cancellation, listener.progress, {}};
            return plan(*scene, options, context, listener.found);
          },
          listener.ended) {}

PathJob::PathJob(EditedScenePtr world, TriedGrasp grasp, const GraspPathOptions& options,
                 const PlanListener& listener)
    : job_(
          [world = std::move(world), grasp = std::move(grasp), options,
           listener](const Cancellation& cancellation) {
            const RunContext context{.cancellation = cancellation, .progress = listener.progress};
            return play_grasp(world->compiled(), grasp, options, context);
          },
          listener.ended) {}

}  // namespace prehend
