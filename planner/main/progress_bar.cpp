#include "planner/main/progress_bar.h"

#include <cstdio>
#include <string>
#include <unistd.h>

namespace prehend {
namespace {

constexpr int kCells = 30;
constexpr double kSecondsBetween = 0.1;

}  // namespace

ProgressBar::ProgressBar() : on_terminal_(::isatty(STDERR_FILENO) != 0) {}

void ProgressBar::show(const TrialProgress& progress) {
  if (!on_terminal_ || progress.total == 0) return;
  const auto now = Clock::now();
  const bool last = progress.done == progress.total;
  if (!last && std::chrono::duration<double>(now - drawn_).count() < kSecondsBetween) return;
  drawn_ = now;
  const double part = static_cast<double>(progress.done) / progress.total;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double left = part > 0.0 ? elapsed * (1.0 - part) / part : 0.0;
  const auto filled = static_cast<std::size_t>(part * kCells);
  const std::string bar = std::string(filled, '#') + std::string(kCells - filled, '.');
  std::fprintf(stderr, "\r[%s] %d of %d tried, %d hold, %.0f s left ", bar.c_str(), progress.done,
               progress.total, progress.stable, left);
  std::fflush(stderr);
}

void ProgressBar::clear() const {
  if (!on_terminal_) return;
  std::fprintf(stderr, "\r\033[K");
  std::fflush(stderr);
}

}  // namespace prehend
