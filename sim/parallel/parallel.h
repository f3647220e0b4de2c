// Loops on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace prehend {

// Calls work(0) ... work(count - 1), in any order, on `threads` threads (0: all processors). An
// exception of one call ends the loop and is thrown on.
void for_each_in_parallel(std::size_t count, int threads,
                          const std::function<void(std::size_t)>& work);

}  // namespace prehend
