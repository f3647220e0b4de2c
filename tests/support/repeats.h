// How often a test of random cases repeats.
#pragma once

namespace prehend::test {

// gcc and clang say so in different ways.
#ifdef __has_feature
inline constexpr bool kSanitized = __has_feature(address_sanitizer);
#elif defined(__SANITIZE_ADDRESS__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

// All of them; under the address sanitizer a quarter, the first ones. It slows code down five to
// twenty times, and is after what the code does with memory, which other cases of the same kind do
// again: rare numbers are what the other builds are for.
constexpr int repeats(int all) { return kSanitized ? (all + 3) / 4 : all; }

}  // namespace prehend::test
