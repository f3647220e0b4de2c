// How often a test of random cases repeats.
#pragma once

namespace prehend::test {

// All of them; under the address sanitizer a quarter, the first ones. It slows code down five to
// twenty times, and is after what the code does with memory, which other cases of the same kind do
// again: rare numbers are what the other builds are for.
constexpr int repeats(int all) {
#ifdef __SANITIZE_ADDRESS__
  return (all + 3) / 4;
#else
  return all;
#endif
}

}  // namespace prehend::test
