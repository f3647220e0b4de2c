// Output of a run's progress.
#pragma once

#include <chrono>

#include "sim/base/run_context.h"

namespace prehend {

// On stderr: a line that is drawn again and again where that is a terminal; with `lines`, for logs
// and other programs, a line each time like "trials 120 of 800, 31 hold". Silent otherwise. At most
// ten times a second, but for the start and the end of each stage.
class ProgressBar {
 public:
  explicit ProgressBar(bool lines);
  void show(const Progress& progress);
  // Removes the line.
  void clear() const;

 private:
  using Clock = std::chrono::steady_clock;
  bool lines_;
  bool on_terminal_;
  Stage stage_ = Stage::load;
  Clock::time_point start_ = Clock::now();  // of the stage
  Clock::time_point drawn_{};
};

}  // namespace prehend
