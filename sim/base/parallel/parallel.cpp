// The loop runs in its own oneTBB arena, which limits its threads. oneTBB is used in this file
// only.
#include "sim/base/parallel/parallel.h"

#include <cerrno>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

namespace prehend {

namespace {

// oneTBB has a bare std::runtime_error for a thread that the system refuses, for lack of memory or
// of numbers of processes.
[[noreturn]] void throw_for_thread(const std::runtime_error& error) {
  if (std::string_view(error.what()).starts_with("pthread_create")) {
    throw std::system_error(EAGAIN, std::generic_category(), "a thread cannot be started");
  }
  throw;
}

}  // namespace

void for_each_in_parallel(std::size_t count, int threads,
                          const std::function<void(std::size_t)>& work) {
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  try {
    arena.execute([&] {
      // Chunks of one index: calls can differ in duration by a factor of a hundred (trials of
      // grasps do), and larger chunks would leave threads idle at the end.
      tbb::parallel_for(
          tbb::blocked_range<std::size_t>(0, count, 1),
          [&](const tbb::blocked_range<std::size_t>& range) {
            for (std::size_t i = range.begin(); i != range.end(); ++i) work(i);
          },
          tbb::simple_partitioner());
    });
  } catch (const std::runtime_error& error) {
    throw_for_thread(error);
  }
}

}  // namespace prehend
