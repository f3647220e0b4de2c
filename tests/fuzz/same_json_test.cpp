#include "tests/fuzz/same_json.h"

#include <gtest/gtest.h>

namespace prehend::fuzz {
namespace {

TEST(SameButRounded, AllowsTheLastDigitsAndTheSignOfAQuaternion) {
  EXPECT_TRUE(same_but_rounded("[1, 2e30]", "[1.00001, 2.0000000000000001e30]"));
  EXPECT_TRUE(same_but_rounded(R"({"quaternion_wxyz": [0, 1, 0, 0]})",
                               R"({"quaternion_wxyz": [0, -1, 0, 0]})"));
}

TEST(SameButRounded, SeesEverythingElse) {
  EXPECT_FALSE(same_but_rounded("[1, 2]", "[1.00001, 2]"));
  EXPECT_FALSE(same_but_rounded("[1, 2]", "[1, 2, 3]"));
  EXPECT_FALSE(same_but_rounded("[1, 2]", "[-1, -2]"));
  EXPECT_FALSE(same_but_rounded(R"({"a": 1})", R"({"b": 1})"));
  EXPECT_FALSE(same_but_rounded(R"({"a": "x"})", R"({"a": "y"})"));
  EXPECT_FALSE(same_but_rounded(R"({"a": null})", R"({"a": 0})"));
}

}  // namespace
}  // namespace prehend::fuzz
