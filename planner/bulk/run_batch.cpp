#include "planner/bulk/run_batch.h"

#include <mutex>
#include <new>
#include <stdexcept>

#include "planner/bulk/part_worker.h"
#include "planner/results/datasets/acronym_file.h"
#include "sim/base/input_error.h"
#include "sim/base/parallel/parallel.h"
#include "sim/base/pool.h"

namespace prehend {
namespace {

constexpr const char* kNoMemory = "not enough memory";

// Of a part that was looked at: how it ended; open where there was no memory for it.
struct PartEnd {
  PartState state = PartState::open;
  std::size_t trials = 0;
  bool made = false;
  std::string reason = {};
};

class BatchRun {
 public:
  BatchRun(const Batch& batch, const BatchInputs& inputs, const BatchFolder& folder,
           const BatchRunOptions& options, const RunContext& context, const BatchListener& listener)
      : batch_(batch),
        inputs_(inputs),
        folder_(folder),
        options_(options),
        context_(context),
        listener_(listener) {}

  BatchCount run() {
    const PartRange range = parts_of(options_.shard, part_count(batch_));
    count_.parts = range.end - range.begin;
    tell();
    for_each_in_parallel(count_.parts, context_.threads, [&](std::size_t i) {
      if (context_.cancellation.requested() || context_.deadline.has_passed()) return;
      const BatchPart part = part_at(batch_, range.begin + i);
      try {
        add(part, carry_out(part));
      } catch (const Cancelled&) {
      }
    });
    return count_;
  }

 private:
  // Errors of the object end the part, not the batch; errors of the folder end the batch.
  PartEnd carry_out(const BatchPart& part) {
    const Pool<PartWorker>::Loan worker(workers_);
    std::string key;
    std::string bytes;
    PartEnd end;
    try {
      key = worker->key(batch_, inputs_, part);
      end.state = folder_.state(key);
      const bool again = options_.retry && end.state == PartState::failed;
      if (end.state == PartState::finished || (end.state == PartState::failed && !again)) {
        if (end.state == PartState::failed) end.reason = folder_.failure(key);
        return end;
      }
      const GraspSet set = worker->run(batch_, inputs_, part, own_context());
      end = {PartState::finished, set.grasps.size(), true};
      bytes = acronym_bytes(set);
    } catch (const InputError& error) {
      end = {PartState::failed, 0, true, error.what()};
    } catch (const std::bad_alloc&) {
      return {.reason = kNoMemory};
    } catch (const std::length_error&) {
      return {.reason = kNoMemory};
    }
    if (end.state == PartState::finished) {
      folder_.write_result(key, bytes);
    } else {
      // A file that cannot be read has no content to be named by.
      if (!key.empty()) folder_.write_failure(key, end.reason);
    }
    return end;
  }

  // A part is planned on one thread: as many parts as threads, without waiting for each other.
  RunContext own_context() const {
    RunContext own;
    own.threads = 1;
    own.cancellation = context_.cancellation;
    return own;
  }

  void add(const BatchPart& part, const PartEnd& end) {
    const std::lock_guard lock(lock_);
    if (end.state == PartState::finished) ++count_.finished;
    if (end.state == PartState::failed) ++count_.failed;
    if (end.state == PartState::open) ++count_.short_of_memory;
    if (end.made) ++count_.made;
    count_.trials += end.trials;
    if (end.state != PartState::finished && listener_.failed) {
      listener_.failed({part_name(batch_, part), end.reason});
    }
    tell();
  }

  void tell() const {
    if (listener_.progress) listener_.progress(count_);
  }

  const Batch& batch_;
  const BatchInputs& inputs_;
  const BatchFolder& folder_;
  const BatchRunOptions& options_;
  const RunContext& context_;
  const BatchListener& listener_;
  Pool<PartWorker> workers_;
  std::mutex lock_;
  BatchCount count_;
};

}  // namespace

BatchCount run_batch(const Batch& batch, const BatchInputs& inputs, const BatchFolder& folder,
                     const BatchRunOptions& options, const RunContext& context,
                     const BatchListener& listener) {
  folder.create();
  return BatchRun(batch, inputs, folder, options, context, listener).run();
}

BatchCount batch_status(const Batch& batch, const BatchInputs& inputs, const BatchFolder& folder,
                        const Shard& shard, const RunContext& context,
                        const std::function<void(const FailedPart&)>& failed) {
  const PartRange range = parts_of(shard, part_count(batch));
  BatchCount count;
  count.parts = range.end - range.begin;
  PartWorker worker;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    context.cancellation.check();
    const BatchPart part = part_at(batch, i);
    FailedPart reason{part_name(batch, part), {}};
    PartState state = PartState::failed;
    try {
      const std::string key = worker.key(batch, inputs, part);
      state = folder.state(key);
      if (state == PartState::failed) reason.reason = folder.failure(key);
    } catch (const InputError& error) {
      reason.reason = error.what();
    }
    if (state == PartState::finished) ++count.finished;
    if (state != PartState::failed) continue;
    ++count.failed;
    if (failed) failed(reason);
  }
  return count;
}

}  // namespace prehend
