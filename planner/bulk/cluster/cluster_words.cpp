#include "planner/bulk/cluster/cluster_words.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "sim/base/input_error.h"

namespace prehend {
namespace {

constexpr std::size_t kMostDigits = 9;

[[noreturn]] void refuse(const std::string& problem, const std::string& words) {
  throw InputError({.problem = problem, .value = words});
}

std::optional<std::int64_t> whole_number(std::string_view digits) {
  if (digits.empty() || digits.size() > kMostDigits) return std::nullopt;
  std::int64_t number = 0;
  for (const char c : digits) {
    if (c < '0' || c > '9') return std::nullopt;
    number = 10 * number + (c - '0');
  }
  return number;
}

// The numbers between colons; nothing where one is none.
std::optional<std::vector<std::int64_t>> numbers_between_colons(std::string_view words) {
  std::vector<std::int64_t> numbers;
  while (true) {
    const std::size_t colon = words.find(':');
    const std::optional<std::int64_t> number = whole_number(words.substr(0, colon));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    if (colon == std::string_view::npos) return numbers;
    words.remove_prefix(colon + 1);
  }
}

// The weights of numbers between colons [s], from the first: what they are depends on how many
// there are, and on whether days stand before them.
std::array<std::int64_t, 3> weights(bool has_days, std::size_t count) {
  if (has_days || count == 3) return {3600, 60, 1};
  return {60, 1, 0};
}

}  // namespace

int slurm_seconds(const std::string& words) {
  constexpr std::int64_t kDay = 86400;
  const std::string problem = "must be a time such as 90 (minutes), 4:00:00 or 2-12 (days-hours)";
  const std::size_t dash = words.find('-');
  const bool has_days = dash != std::string::npos;
  const auto days = has_days ? whole_number(std::string_view(words).substr(0, dash)) : 0;
  const auto numbers =
      numbers_between_colons(std::string_view(words).substr(has_days ? dash + 1 : 0));
  if (!days || !numbers || numbers->size() > 3) refuse(problem, words);
  const std::array<std::int64_t, 3> weight = weights(has_days, numbers->size());
  std::int64_t seconds = *days * kDay;
  for (std::size_t i = 0; i < numbers->size(); ++i) seconds += weight[i] * (*numbers)[i];
  if (seconds <= 0 || seconds > 366 * kDay) refuse(problem + ", at most a year", words);
  return static_cast<int>(seconds);
}

int slurm_megabytes(const std::string& words) {
  constexpr std::int64_t kMost = std::int64_t{1000} * 1024 * 1024;
  const std::string problem = "must be a size such as 4G or 4000M";
  std::string_view digits = words;
  char unit = 'M';
  if (!digits.empty() && std::string_view("KMGT").find(digits.back()) != std::string_view::npos) {
    unit = digits.back();
    digits.remove_suffix(1);
  }
  const std::optional<std::int64_t> number = whole_number(digits);
  if (!number) refuse(problem, words);
  std::int64_t megabytes = *number;
  if (unit == 'K') megabytes = (*number + 1023) / 1024;
  if (unit == 'G') megabytes = *number << 10U;
  if (unit == 'T') megabytes = *number << 20U;
  if (megabytes <= 0 || megabytes > kMost) refuse(problem + ", at most 1000T", words);
  return static_cast<int>(megabytes);
}

}  // namespace prehend
