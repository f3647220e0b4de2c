#include "planner/main/bulk/batch_bar.h"

#include <cstdio>
#include <unistd.h>

#include "sim/base/formatted.h"

namespace prehend {
namespace {

// "40 s", "12 min", "3.5 h"
std::string duration_text(double seconds) {
  constexpr double kMinute = 60.0;
  constexpr double kHour = 3600.0;
  if (seconds < 2.0 * kMinute) return formatted("%.0f s", seconds);
  if (seconds < 2.0 * kHour) return formatted("%.0f min", seconds / kMinute);
  return formatted("%.1f h", seconds / kHour);
}

std::string count_text(const BatchCount& count, double seconds) {
  std::string words = formatted("%zu of %zu parts", count.finished + count.failed, count.parts);
  if (count.failed > 0) words += formatted(", %zu failed", count.failed);
  if (count.made == 0 || !(seconds > 0.0)) return words;
  words += formatted(", %.0f trials/s", static_cast<double>(count.trials) / seconds);
  if (count.open() == 0) return words;
  const double each = seconds / static_cast<double>(count.made);
  return words + ", " + duration_text(each * static_cast<double>(count.open())) + " left";
}

}  // namespace

BatchBar::BatchBar(bool lines)
    : lines_(lines), on_terminal_(!lines && ::isatty(STDERR_FILENO) != 0) {}

void BatchBar::show(const BatchCount& count) {
  if (!lines_ && !on_terminal_) return;
  constexpr double kSecondsBetween = 0.2;
  const auto now = Clock::now();
  const bool between = std::chrono::duration<double>(now - drawn_).count() < kSecondsBetween;
  if (between && count.open() > 0) return;
  drawn_ = now;
  const std::string words = count_text(count, seconds());
  // Back to the start of the line and erase it (ANSI escape sequence).
  std::fprintf(stderr, lines_ ? "%s\n" : "\r\033[K%s", words.c_str());
  std::fflush(stderr);
}

void BatchBar::clear() const {
  if (!on_terminal_) return;
  std::fprintf(stderr, "\r\033[K");
  std::fflush(stderr);
}

double BatchBar::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

}  // namespace prehend
