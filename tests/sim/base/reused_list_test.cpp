#include "sim/base/reused_list.h"

#include <gtest/gtest.h>

namespace prehend {
namespace {

TEST(ReusedList, KeepsTheMemoryOfItsElements) {
  ReusedList<std::vector<int>> list;
  EXPECT_TRUE(list.empty());
  list.add().assign(100, 7);
  list.add().assign(3, 8);
  const int* const memory = list.begin()->data();
  list.clear();
  EXPECT_TRUE(list.empty());
  EXPECT_EQ(list.begin(), list.end());
  std::vector<int>& again = list.add();
  again.assign(50, 1);
  EXPECT_EQ(again.data(), memory);
  EXPECT_EQ(list.size(), 1U);
  EXPECT_EQ(list.end() - list.begin(), 1);
}

}  // namespace
}  // namespace prehend
