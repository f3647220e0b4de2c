// Texts in which one number is an extreme one.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>

namespace prehend::fuzz {

// Zeros of both signs, the smallest numbers, the limits of kinds of quantities and what is beyond,
// what no double holds, and what is no number.
inline constexpr std::array<std::string_view, 21> kExtremeNumbers{
    "0",     "-0",   "5e-324",  "-5e-324", "1e-308", "1e-30", "-1",
    "1e6",   "-1e6", "1000001", "1e9",     "-1e9",   "1e12",  "1e21",
    "-1e21", "1e30", "-1e30",   "1e308",   "1e999",  "NaN",   "Infinity"};

// Calls `use` with the text for each of its numbers (words that are part of a name are none) and
// each extreme in its place. Of longer texts only `most` numbers, spread evenly.
void for_each_extreme(const std::string& text, std::size_t most,
                      const std::function<void(const std::string& changed)>& use);

}  // namespace prehend::fuzz
