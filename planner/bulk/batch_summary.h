// What a batch became, in words and figures: its data card and its page.
#pragma once

#include <string>
#include <vector>

#include "planner/bulk/batch.h"
#include "planner/bulk/batch_tally.h"
#include "planner/bulk/run_batch.h"

namespace prehend {

struct BatchSummary {
  std::string name;
  std::string version;
  std::string licence;  // of the meshes; empty: not stated
  BatchTally tally;
  std::size_t parts = 0;
  std::size_t open = 0;  // parts without a result that did not fail: of a partial merge
  std::size_t failed_parts = 0;
  std::vector<FailedPart> failed;  // the first of them, kMostListed
  std::vector<std::string> formats;
  // "KEY: VALUES" of what was multiplied, for people.
  std::vector<std::string> axes;
  std::vector<std::string> settings;  // as JSON texts
  std::vector<std::string> pictures;  // titles, of "pictures/01.png" and so on
};

inline constexpr std::size_t kMostListed = 100;

// Markdown that says what the data set is, how many grasps it has, how it was made and what its
// files hold. The same bytes for the same summary.
std::string data_card(const BatchSummary& summary);

// A page with distributions and the pictures beside it.
std::string batch_page(const BatchSummary& summary);

}  // namespace prehend
