// Values of options that are more than a word or a number.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/base/pose.h"

namespace prehend {

// What an option may be, as CLI11 wants it.
template <typename Texts>
std::vector<std::string> texts(const Texts& values) {
  return {values.begin(), values.end()};
}

// Seconds of a time such as "2s", "500ms", "1.5min" or "1h". Throws InputError of --budget for any
// other word, such as a number without a unit, and for times that are not above 0.
double seconds_of(const std::string& words);

// Reads "x,y,z", three finite numbers; false for any other words.
bool three_numbers(std::string_view words, Vector3& numbers);

// What is wrong with a seed; empty where it is one. CLI11 takes "-1" for the largest number, and
// numbers beyond it for that as well.
std::string complaint_about_seed(const std::string& word);

}  // namespace prehend
