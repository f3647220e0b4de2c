// Signed counts and ids as indices of standard containers.
#pragma once

#include <cassert>
#include <cstddef>

namespace prehend {

// `i` (>= 0) as an index. Ids and counts are signed in this project, so that their differences are
// signed, too; standard containers take unsigned indices.
constexpr std::size_t index(int i) {
  assert(i >= 0);
  return static_cast<std::size_t>(i);
}

}  // namespace prehend
