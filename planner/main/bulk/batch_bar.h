// How far a batch is, for people.
#pragma once

#include <chrono>
#include <string>

#include "planner/bulk/run_batch.h"

namespace prehend {

// "12 of 120 parts, 3 failed, 412 trials/s, 4 min left", on stderr: a line that is drawn again and
// again where that is a terminal; with `lines` a line each time. Silent otherwise.
class BatchBar {
 public:
  explicit BatchBar(bool lines);
  void show(const BatchCount& count);
  // Removes the line.
  void clear() const;

  // Since the bar was made [s].
  double seconds() const;

 private:
  using Clock = std::chrono::steady_clock;
  bool lines_;
  bool on_terminal_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point drawn_{};
};

}  // namespace prehend
