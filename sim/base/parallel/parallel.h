// A loop over indices, spread over several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace prehend {

// Calls work(0) ... work(count - 1), in any order, on `threads` threads (0: one per processor), and
// returns when all calls have returned. When a call throws, no further calls are started and one of
// the exceptions is thrown to the caller. Throws std::system_error where a thread cannot be
// started.
void for_each_in_parallel(std::size_t count, int threads,
                          const std::function<void(std::size_t)>& work);

}  // namespace prehend
