#include "sim/robot/files/graspit_notes.h"

#include <algorithm>

#include "sim/base/input_error.h"

namespace prehend {

std::string note_of(const XmlElement& element, const std::string& text) {
  return on_one_line(element.file().filename().string() + ": " + element.place() + ": " + text);
}

std::string in_note(const std::string& word) {
  constexpr std::size_t kLongestWord = 40;
  const bool cut = word.size() > kLongestWord;
  return on_one_line("'" + word.substr(0, kLongestWord) + (cut ? "...'" : "'"));
}

void note_unknown(const XmlElement& parent, std::span<const std::string_view> known,
                  std::vector<std::string>& notes) {
  constexpr std::size_t kMostUnknown = 20;
  std::size_t unknown = 0;
  for (const XmlElement& element : parent.children()) {
    if (std::find(known.begin(), known.end(), element.name()) != known.end()) continue;
    if (++unknown > kMostUnknown) {
      notes.push_back(note_of(parent, "more elements are not known and left out"));
      return;
    }
    notes.push_back(note_of(element, "not known, left out"));
  }
}

}  // namespace prehend
