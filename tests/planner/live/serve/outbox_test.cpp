#include "planner/live/serve/outbox.h"

#include <gtest/gtest.h>

namespace prehend {
namespace {

constexpr std::size_t kOverhead = sizeof(std::string);

TEST(Outbox, GivesMessagesInOrderAndWakesOnce) {
  int woken = 0;
  Outbox outbox(1000, [&] { ++woken; });
  std::string message;
  EXPECT_FALSE(outbox.take(message));
  outbox.put("a");
  outbox.put("b");
  EXPECT_EQ(woken, 1);
  EXPECT_TRUE(outbox.take(message));
  EXPECT_EQ(message, "a");
  EXPECT_TRUE(outbox.take(message));
  EXPECT_EQ(message, "b");
  EXPECT_EQ(outbox.waiting(), 1 + kOverhead);  // "b" may not be written yet
  EXPECT_FALSE(outbox.take(message));
  EXPECT_EQ(outbox.waiting(), 0U);
  outbox.put("c");
  EXPECT_EQ(woken, 2);
}

TEST(Outbox, OverflowsWithWhatDoesNotFitAndKeepsNothing) {
  int woken = 0;
  Outbox outbox(100 + 2 * kOverhead, [&] { ++woken; });
  std::string message;
  outbox.put(std::string(60, 'a'));
  outbox.put(std::string(40, 'b'));
  EXPECT_FALSE(outbox.overflowed());
  EXPECT_TRUE(outbox.take(message));
  outbox.put("c");  // the first is still being written
  EXPECT_TRUE(outbox.overflowed());
  EXPECT_EQ(woken, 2);
  EXPECT_EQ(outbox.waiting(), 60 + kOverhead);
  EXPECT_FALSE(outbox.take(message));
  outbox.put("d");
  EXPECT_EQ(woken, 2);
  EXPECT_FALSE(outbox.take(message));
}

TEST(Outbox, EmptyMessagesAreBoundedAsWell) {
  Outbox outbox(1000 * kOverhead, [] {});
  for (int i = 0; i < 1000; ++i) outbox.put("");
  EXPECT_FALSE(outbox.overflowed());
  outbox.put("");
  EXPECT_TRUE(outbox.overflowed());
}

TEST(Outbox, ClosedItDropsAllAndWakesNobody) {
  int woken = 0;
  Outbox outbox(100, [&] { ++woken; });
  outbox.put("a");
  outbox.close();
  outbox.put("b");
  std::string message;
  EXPECT_FALSE(outbox.take(message));
  EXPECT_EQ(woken, 1);
  EXPECT_EQ(outbox.waiting(), 0U);
}

}  // namespace
}  // namespace prehend
