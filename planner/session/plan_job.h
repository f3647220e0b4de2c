// A plan that runs while the session goes on.
#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <thread>

#include "planner/search/plan.h"

namespace prehend {

// What is told of a running plan, from its own thread; each may be empty.
struct PlanListener {
  std::function<void(const Progress&)> progress = {};
  std::function<void(const Candidate&, const Trial&)> found = {};  // of each stable trial
  std::function<void()> ended = {};                                // take() no longer waits long
};

class PlanJob {
 public:
  // Begins at once. `threads`: 0, one per processor.
  PlanJob(std::shared_ptr<const CompiledScene> scene, const PlanOptions& options, int threads,
          PlanListener listener);
  // Cancels, and waits for the end.
  ~PlanJob();
  PlanJob(const PlanJob&) = delete;
  PlanJob& operator=(const PlanJob&) = delete;

  // The plan ends soon, with what it has; from any thread.
  void cancel() const { cancellation_.request(); }
  // A flag that does the same.
  const Cancellation& cancellation() const { return cancellation_; }

  // Waits for the result and takes it, once. Throws what plan() has thrown.
  PlanResult take();

  const CompiledScene& scene() const { return *scene_; }
  const PlanOptions& options() const { return options_; }

 private:
  void run(int threads, const PlanListener& listener);

  std::shared_ptr<const CompiledScene> scene_;
  PlanOptions options_;
  Cancellation cancellation_;
  PlanResult result_;
  std::exception_ptr error_;
  std::thread thread_;  // last: it uses the others
};

}  // namespace prehend
