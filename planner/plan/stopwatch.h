// Measures the wall-clock time of the stages of a run.
#pragma once

#include <chrono>
#include <vector>

#include "sim/base/run_context.h"

namespace prehend {

// Measures stages that follow one another. It starts when it is made; each lap is the time since
// the lap before it.
class Stopwatch {
 public:
  void lap(Stage stage) {
    const auto now = std::chrono::steady_clock::now();
    laps_.push_back({stage, std::chrono::duration<double>(now - last_).count()});
    last_ = now;
  }
  // Appends laps that were measured elsewhere since the last lap. Time since then that is not in
  // them is not counted.
  void add(const std::vector<StageTime>& laps) {
    laps_.insert(laps_.end(), laps.begin(), laps.end());
    last_ = std::chrono::steady_clock::now();
  }
  const std::vector<StageTime>& laps() const { return laps_; }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  std::vector<StageTime> laps_;
};

}  // namespace prehend
