#include "planner/live/serve/line_splitter.h"

#include <algorithm>
#include <utility>

namespace prehend {

void LineSplitter::add(std::string_view piece, const Use& use) {
  while (!piece.empty()) {
    const std::size_t end = piece.find('\n');
    const std::string_view part = piece.substr(0, end);
    // One byte more than a line may have, since it may be the '\r' of its end.
    const std::size_t room = longest_ + 1 - std::min(line_.size(), longest_ + 1);
    if (!skips_) line_.append(part.substr(0, room));
    if (!skips_ && part.size() > room && !cut_line(use)) return;
    if (end == std::string_view::npos) return;
    piece.remove_prefix(end + 1);
    if (!end_line(use)) return;
  }
}

bool LineSplitter::end_line(const Use& use) {
  if (std::exchange(skips_, false)) return true;
  if (line_.ends_with('\r')) line_.pop_back();
  if (line_.empty()) return true;
  if (line_.size() > longest_) {
    const bool goes_on = cut_line(use);
    skips_ = false;
    return goes_on;
  }
  return use(std::exchange(line_, {}), true);
}

bool LineSplitter::cut_line(const Use& use) {
  skips_ = true;
  // Moved out, so that its memory is given back.
  const std::string line = std::exchange(line_, {});
  return use(line.substr(0, kBeginning), false);
}

}  // namespace prehend
