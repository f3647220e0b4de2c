// Signed counts and ids as indices of standard containers.
#pragma once

#include <cassert>
#include <cstddef>

namespace prehend {

// Converts `i` (>= 0) to the unsigned index type of standard containers. Ids and counts are signed
// in this project, so that their differences are signed, too.
constexpr std::size_t index(int i) {
  assert(i >= 0);
  return static_cast<std::size_t>(i);
}
constexpr std::size_t index(std::ptrdiff_t i) {  // as Eigen counts
  assert(i >= 0);
  return static_cast<std::size_t>(i);
}

}  // namespace prehend
