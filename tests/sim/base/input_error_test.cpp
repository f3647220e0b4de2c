#include "sim/base/input_error.h"

#include <gtest/gtest.h>

namespace prehend {
namespace {

TEST(InputError, SaysItsPartsOnOneLine) {
  const InputError error({"a.json", "hand.joints[2]", "must be a number", "\"x\""});
  EXPECT_STREQ(error.what(), "a.json: hand.joints[2]: must be a number (\"x\")");
  EXPECT_EQ(error.file(), "a.json");
  EXPECT_EQ(error.field(), "hand.joints[2]");
  EXPECT_EQ(error.problem(), "must be a number");
  EXPECT_EQ(error.value(), "\"x\"");
}

TEST(InputError, LeavesOutWhatIsEmpty) {
  EXPECT_STREQ(InputError("no such file").what(), "no such file");
  EXPECT_EQ(InputError("no such file").problem(), "no such file");
  EXPECT_STREQ(InputError({.field = "edges", .problem = "too few", .value = "2"}).what(),
               "edges: too few (2)");
  EXPECT_STREQ(InputError({.file = "a.stl", .problem = "is empty"}).what(), "a.stl: is empty");
}

TEST(InputError, FieldsNestAndFilesStay) {
  const InputError inner({.field = "normal", .problem = "not unit", .value = "0, 0, 2"});
  const InputError outer = inner.under("contacts[3]").under("grasps[1]").in_file("a.json");
  EXPECT_STREQ(outer.what(), "a.json: grasps[1].contacts[3].normal: not unit (0, 0, 2)");
  EXPECT_EQ(outer.in_file("b.json").file(), "a.json");
  const InputError element({.field = "[2]", .problem = "not finite"});
  EXPECT_EQ(element.under("wrenches").field(), "wrenches[2]");
  EXPECT_EQ(InputError("not finite").under("wrenches").field(), "wrenches");
  EXPECT_EQ(inner.under("").field(), "normal");
}

TEST(InputError, IsToldOfTheFieldThatWasAtFault) {
  const InputError inner({.field = "name", .problem = "unknown"});
  EXPECT_STREQ(inner.about("robot.hand", "\"x\"").what(), "robot.hand: unknown (\"x\")");
  const InputError valued({.problem = "must be simple", .value = "4 corners"});
  EXPECT_STREQ(valued.about("profile", "[[0, 0]]").what(), "profile: must be simple (4 corners)");
  const InputError elsewhere =
      valued.in_file("b.json").about("mesh", "\"b.json\"").in_file("a.json");
  EXPECT_EQ(elsewhere.file(), "a.json");
  EXPECT_EQ(elsewhere.field(), "mesh");
  EXPECT_EQ(elsewhere.problem(), "b.json: must be simple (4 corners)");
  EXPECT_EQ(elsewhere.value(), "");
}

TEST(Require, ThrowsUnlessItHolds) {
  EXPECT_NO_THROW(require(true, {.field = "edges", .problem = "too few"}));
  EXPECT_THROW(require(false, {.field = "edges", .problem = "too few"}), InputError);
}

}  // namespace
}  // namespace prehend
