// A moment after which no more work is to begin.
#pragma once

#include <algorithm>
#include <chrono>
#include <limits>

namespace prehend {

class Deadline {
 public:
  // Never.
  Deadline() = default;
  // `seconds` from now; infinite or more than a year: never.
  static Deadline in(double seconds) {
    constexpr double kLongest = 365.0 * 86400.0;
    Deadline deadline;
    if (!(seconds < kLongest)) return deadline;
    deadline.begin_ = Clock::now();
    deadline.seconds_ = seconds;
    return deadline;
  }

  bool is_set() const { return seconds_ < std::numeric_limits<double>::infinity(); }
  bool has_passed() const { return is_set() && elapsed() >= seconds_; }

  // The moment at which this part of the time that is left now is over.
  Deadline part(double share) const {
    if (!is_set()) return {};
    Deadline earlier = *this;
    const double now = elapsed();
    earlier.seconds_ = std::min(seconds_, now + share * (seconds_ - now));
    return earlier;
  }

 private:
  using Clock = std::chrono::steady_clock;
  double elapsed() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

  Clock::time_point begin_{};
  double seconds_ = std::numeric_limits<double>::infinity();
};

}  // namespace prehend
