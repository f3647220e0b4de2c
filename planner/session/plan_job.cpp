#include "planner/session/plan_job.h"

#include <utility>

namespace prehend {

PlanJob::PlanJob(std::shared_ptr<const CompiledScene> scene, const PlanOptions& options,
                 int threads, PlanListener listener)
    : scene_(std::move(scene)), options_(options) {
  thread_ = std::thread([this, threads, heard = std::move(listener)] { run(threads, heard); });
}

PlanJob::~PlanJob() {
  cancel();
  if (thread_.joinable()) thread_.join();
}

void PlanJob::run(int threads, const PlanListener& listener) {
  try {
    const RunContext context{threads, cancellation_, listener.progress, {}};
    result_ = plan(*scene_, options_, context, listener.found);
  } catch (...) {
    error_ = std::current_exception();
  }
  if (listener.ended) listener.ended();
}

PlanResult PlanJob::take() {
  if (thread_.joinable()) thread_.join();
  if (error_) std::rethrow_exception(error_);
  return std::move(result_);
}

}  // namespace prehend
