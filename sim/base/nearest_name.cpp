#include "sim/base/nearest_name.h"

#include <algorithm>

namespace prehend {
namespace {

// Words beyond this are no misspelt names, and would take long to compare.
constexpr std::size_t kLongestWord = 100;

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  // Rows of the table of the distances between the beginnings of both; the last two are kept.
  std::vector<int> before_last(b.size() + 1);
  std::vector<int> last(b.size() + 1);
  std::vector<int> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      const bool exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (exchanged) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::string nearest_name(std::string_view word, const std::vector<std::string>& names) {
  if (word.size() > kLongestWord) return "";
  int least = std::max(1, static_cast<int>(word.size() / 3)) + 1;
  std::string nearest;
  for (const std::string& name : names) {
    if (name.size() > kLongestWord) continue;
    const int distance = edit_distance(word, name);
    if (distance >= least) continue;
    least = distance;
    nearest = name;
  }
  return nearest;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& names) {
  const std::string nearest = nearest_name(word, names);
  return nearest.empty() ? "" : "did you mean " + nearest + "? ";
}

}  // namespace prehend
