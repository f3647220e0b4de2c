// A line on a terminal that says how far a run is.
#pragma once

#include <chrono>

#include "planner/search/run_trials.h"

namespace prehend {

// Draws on stderr when that is a terminal, and is silent otherwise.
class ProgressBar {
 public:
  ProgressBar();
  void show(const TrialProgress& progress);
  // Removes the line.
  void clear() const;

 private:
  using Clock = std::chrono::steady_clock;
  bool on_terminal_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point drawn_{};
};

}  // namespace prehend
