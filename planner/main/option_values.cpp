#include "planner/main/option_values.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <system_error>
#include <utility>

#include "sim/base/input_error.h"

namespace prehend {

double seconds_of(const std::string& words) {
  const std::array<std::pair<std::string_view, double>, 4> units = {
      {{"s", 1.0}, {"ms", 1e-3}, {"min", 60.0}, {"h", 3600.0}}};
  double number = 0.0;
  const auto [end, error] = std::from_chars(words.data(), words.data() + words.size(), number);
  const std::string_view rest(end, static_cast<std::size_t>(words.data() + words.size() - end));
  for (const auto& [unit, seconds] : units) {
    const bool sound = error == std::errc() && rest == unit && number > 0.0;
    if (sound && number * seconds <= 1e9) return number * seconds;
  }
  throw InputError({.field = "--budget",
                    .problem = "must be a time above 0 with its unit, such as 500ms, 2s or 1.5min",
                    .value = words});
}

bool three_numbers(std::string_view words, Vector3& numbers) {
  for (int k = 0; k < 3; ++k) {
    if (k > 0 && !words.starts_with(',')) return false;
    if (k > 0) words.remove_prefix(1);
    const auto [end, error] =
        std::from_chars(words.data(), words.data() + words.size(), numbers[k]);
    if (error != std::errc() || !std::isfinite(numbers[k])) return false;
    words.remove_prefix(static_cast<std::size_t>(end - words.data()));
  }
  return words.empty();
}

std::string complaint_about_seed(const std::string& word) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), seed);
  const bool whole = error == std::errc() && end == word.data() + word.size();
  return whole ? "" : "must be a whole number from 0 to 18446744073709551615 (" + word + ")";
}

}  // namespace prehend
