#include "sim/base/joined.h"

#include <vector>

#include <gtest/gtest.h>

namespace prehend {
namespace {

struct Named {
  std::string name;
};

TEST(Joined, PutsTheSeparatorBetweenPartsOnly) {
  EXPECT_EQ(joined(std::vector<std::string>{}), "");
  EXPECT_EQ(joined(std::vector<std::string>{"a"}), "a");
  EXPECT_EQ(joined(std::vector<std::string>{"a", "", "c"}), "a, , c");
  EXPECT_EQ(joined(std::vector<std::string>{"a", "b"}, "/"), "a/b");
}

TEST(Joined, TakesTheTextOfAPartFromAMemberOrAFunction) {
  EXPECT_EQ(joined(std::vector<Named>{{"a"}, {"b"}}, ", ", &Named::name), "a, b");
  EXPECT_EQ(joined(std::vector<int>{1, 2}, " ", [](int i) { return std::to_string(i); }), "1 2");
}

TEST(Joined, AListGrowsPartByPart) {
  std::string list;
  for (const char* part : {"a", "b", "c"}) add_part(list, part);
  EXPECT_EQ(list, "a, b, c");
}

}  // namespace
}  // namespace prehend
