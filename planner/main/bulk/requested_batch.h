// The batch that a command line names.
#pragma once

#include <filesystem>

#include "planner/bulk/batch.h"
#include "planner/bulk/batch_folder.h"
#include "planner/bulk/batch_inputs.h"

namespace prehend {

// Read without writing anything.
struct AskedBatch {
  Batch batch;
  BatchFolder folder;
  BatchInputs inputs;

  // `out`: empty: "out/NAME". Throws InputError for a batch that cannot be run, and as BatchFolder.
  AskedBatch(const std::filesystem::path& file, const std::filesystem::path& out);
};

}  // namespace prehend
