#include "planner/live/serve/token.h"

#include <set>

#include <gtest/gtest.h>

namespace prehend {
namespace {

TEST(Token, Is128BitsInHexadecimalDigitsAndNeverTheSame) {
  std::set<std::string> tokens;
  std::set<char> digits;
  for (int i = 0; i < 1000; ++i) {
    const std::string token = random_token();
    ASSERT_EQ(token.size(), 32U);
    digits.insert(token.begin(), token.end());
    EXPECT_TRUE(tokens.insert(token).second);
  }
  EXPECT_EQ(std::string(digits.begin(), digits.end()), "0123456789abcdef");
}

TEST(Token, OnlyTheSameTextIsTheSame) {
  EXPECT_TRUE(same_secret("", ""));
  EXPECT_TRUE(same_secret("abc", "abc"));
  EXPECT_FALSE(same_secret("abc", "abd"));
  EXPECT_FALSE(same_secret("abc", "xbc"));
  EXPECT_FALSE(same_secret("abc", "ab"));
  EXPECT_FALSE(same_secret("", "a"));
  EXPECT_FALSE(same_secret("\x80", std::string_view("\0", 1)));
}

}  // namespace
}  // namespace prehend
