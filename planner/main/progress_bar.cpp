#include "planner/main/progress_bar.h"

#include <cstdio>
#include <string>
#include <unistd.h>

namespace prehend {
namespace {

constexpr int kCells = 30;
constexpr double kSecondsBetween = 0.1;

// "trials 120 of 800, 31 hold"
std::string words_of(const Progress& progress) {
  std::string words = std::string(name_of(progress.stage)) + " " + std::to_string(progress.done) +
                      " of " + std::to_string(progress.total);
  if (progress.stage == Stage::trials) words += ", " + std::to_string(progress.stable) + " hold";
  return words;
}

}  // namespace

ProgressBar::ProgressBar(bool lines)
    : lines_(lines), on_terminal_(!lines && ::isatty(STDERR_FILENO) != 0) {}

void ProgressBar::show(const Progress& progress) {
  if (!lines_ && !on_terminal_) return;
  const auto now = Clock::now();
  const bool first = progress.stage != stage_ || progress.done == 0;
  // Start and end of a stage are always shown, what lies between at intervals of kSecondsBetween.
  const bool last = progress.done == progress.total;
  if (first) start_ = now;
  stage_ = progress.stage;
  if (!first && !last && std::chrono::duration<double>(now - drawn_).count() < kSecondsBetween) {
    return;
  }
  drawn_ = now;
  const std::string words = words_of(progress);
  if (lines_) {
    std::fprintf(stderr, "%s\n", words.c_str());
  } else if (progress.total > 0) {
    const double part = static_cast<double>(progress.done) / progress.total;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const auto filled = static_cast<std::size_t>(part * kCells);
    const std::string bar = std::string(filled, '#') + std::string(kCells - filled, '.');
    // Back to the start of the line and erase it (ANSI escape sequence).
    std::fprintf(stderr, "\r\033[K[%s] %s", bar.c_str(), words.c_str());
    // Estimated from the mean time of the pieces that are done.
    if (part > 0.0) std::fprintf(stderr, ", %.0f s left ", elapsed * (1.0 - part) / part);
  }
  std::fflush(stderr);
}

void ProgressBar::clear() const {
  if (!on_terminal_) return;
  std::fprintf(stderr, "\r\033[K");
  std::fflush(stderr);
}

}  // namespace prehend
