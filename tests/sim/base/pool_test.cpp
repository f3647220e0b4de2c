#include "sim/base/pool.h"

#include <atomic>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace prehend {
namespace {

struct Counted {
  Counted() { ++made; }
  std::atomic<int> users = 0;
  static inline std::atomic<int> made = 0;
};

TEST(Pool, LendsNothingTwiceAtOnceAndKeepsWhatComesBack) {
  Counted::made = 0;
  Pool<Counted> pool;
  for (int run = 0; run < 3; ++run) {
    const Pool<Counted>::Loan first(pool);
    const Pool<Counted>::Loan second(pool);
    EXPECT_NE(first.operator->(), second.operator->());
  }
  EXPECT_EQ(Counted::made, 2);
}

TEST(Pool, LendsToManyThreads) {
  Counted::made = 0;
  Pool<Counted> pool;
  std::atomic<int> shared = 0;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&] {
      for (int run = 0; run < 1000; ++run) {
        const Pool<Counted>::Loan loan(pool);
        if (++loan->users > 1) ++shared;
        --loan->users;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(shared, 0);
  EXPECT_LE(Counted::made, 4);
}

}  // namespace
}  // namespace prehend
