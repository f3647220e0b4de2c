// What each stage of a run cost.
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace prehend {

struct StageTime {
  std::string stage;
  double seconds = 0.0;
};

// Each lap is the time since the lap before it.
class Stopwatch {
 public:
  void lap(std::string stage) {
    const auto now = std::chrono::steady_clock::now();
    laps_.push_back({std::move(stage), std::chrono::duration<double>(now - last_).count()});
    last_ = now;
  }
  // Laps that somebody else took since the last one; time not in them is left out.
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
