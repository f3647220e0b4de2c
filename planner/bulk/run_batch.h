// Runs a batch, or a part of it, into its folder.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "planner/bulk/batch.h"
#include "planner/bulk/batch_folder.h"
#include "planner/bulk/batch_inputs.h"
#include "planner/bulk/batch_part.h"
#include "sim/base/run_context.h"

namespace prehend {

// How far a batch, or a shard of it, is.
struct BatchCount {
  std::size_t parts = 0;     // all of them
  std::size_t finished = 0;  // with a result
  std::size_t failed = 0;
  std::size_t made = 0;             // of those finished or failed, in this run
  std::size_t trials = 0;           // made in this run
  std::size_t short_of_memory = 0;  // open parts that this run began and had no memory for

  std::size_t open() const { return parts - finished - failed; }
};

// What a part that failed is called, and its reason in one line.
struct FailedPart {
  std::string name;
  std::string reason;
};

struct BatchListener {
  // Both are never called by two threads at once, and may be empty.
  std::function<void(const BatchCount&)> progress = {};
  std::function<void(const FailedPart&)> failed = {};
};

struct BatchRunOptions {
  Shard shard;
  bool retry = false;  // parts that failed are tried again
};

// Plans all open parts of the shard, one on each thread, and writes their results to the folder,
// each as soon as it is there. What is already there is left out; a part whose mesh cannot be used
// is entered as failed, and the others go on; one that there is no memory for stays open. Any
// number of processes may work on one folder.
//
// Cancelled or at the deadline of the context, it returns what was done until then: begun parts are
// given up, and open again. Throws what write_file throws where a result cannot be written.
BatchCount run_batch(const Batch& batch, const BatchInputs& inputs, const BatchFolder& folder,
                     const BatchRunOptions& options = {}, const RunContext& context = {},
                     const BatchListener& listener = {});

// What is in the folder of the shard's parts; reads the meshes for that. `failed` is told of each
// part that failed, in the order of the parts.
BatchCount batch_status(const Batch& batch, const BatchInputs& inputs, const BatchFolder& folder,
                        const Shard& shard = {}, const RunContext& context = {},
                        const std::function<void(const FailedPart&)>& failed = {});

}  // namespace prehend
