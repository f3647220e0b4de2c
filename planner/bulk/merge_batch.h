// Makes a data set of the results of a batch.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "planner/bulk/batch.h"
#include "planner/bulk/batch_folder.h"
#include "planner/bulk/batch_inputs.h"
#include "planner/bulk/run_batch.h"
#include "sim/base/run_context.h"

namespace prehend {

// The formats of data sets, as in MergeOptions::formats.
inline constexpr std::array<std::string_view, 3> kBatchFormats = {"acronym", "graspgen", "csv"};

struct MergeOptions {
  std::vector<std::string> formats{kBatchFormats.begin(), kBatchFormats.end()};
  bool partial = false;       // also while parts are open
  std::size_t pictures = 16;  // a quarter of them of grasps that do not hold
};

// Writes "merged" into the folder, in place of an earlier one:
//   acronym/PART.h5, graspgen/PART.json   a file for each part that has a result (part_name)
//   grasps.csv                            all grasps
//   failures.csv                          parts that failed, with their reasons
//   CARD.md, index.html, pictures/        what the data set is
// The same bytes however the batch was sharded, interrupted and continued. Its memory does not
// depend on the number of grasps. Where parts are open and `partial` is not set, nothing is written
// and the count says how many.
//
// Several may merge the same folder at once (write_folder). `progress` is told of parts that were
// looked at; may be empty. Throws InputError where a result was damaged, what write_file throws,
// and Cancelled: an earlier "merged" then stays.
BatchCount merge_batch(const Batch& batch, const BatchInputs& inputs, const BatchFolder& folder,
                       const MergeOptions& options = {}, const RunContext& context = {},
                       const std::function<void(const BatchCount&)>& progress = {});

}  // namespace prehend
