// Work that goes on, on a thread of its own, while a session does something else.
#pragma once

#include <exception>
#include <functional>
#include <thread>
#include <utility>

#include "sim/base/run_context.h"

namespace prehend {

template <typename Result>
class Job {
 public:
  // Begins at once. `work` gets the flag that cancels it; `ended` (may be empty) is called when
  // take() no longer waits long. Both are called from the job's thread.
  Job(std::function<Result(const Cancellation&)> work, std::function<void()> ended)
      : thread_([this, work = std::move(work), ended = std::move(ended)] { run(work, ended); }) {}
  // Cancels, and waits for the end.
  ~Job() {
    cancellation_.request();
    if (thread_.joinable()) thread_.join();
  }
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  // Its request() ends the work soon; from any thread.
  const Cancellation& cancellation() const { return cancellation_; }

  // Waits for the result and takes it, once. Throws what the work has thrown.
  Result take() {
    if (thread_.joinable()) thread_.join();
    if (error_) std::rethrow_exception(error_);
    return std::move(result_);
  }

 private:
  void run(const std::function<Result(const Cancellation&)>& work,
           const std::function<void()>& ended) {
    try {
      result_ = work(cancellation_);
    } catch (...) {
      error_ = std::current_exception();
    }
    if (ended) ended();
  }

  Cancellation cancellation_;
  Result result_;
  std::exception_ptr error_;
  std::thread thread_;  // last: it uses the others
};

}  // namespace prehend
