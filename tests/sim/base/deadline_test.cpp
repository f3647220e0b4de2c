// Deadlines far in the past and in the future: the time that passes here does not matter.
#include "sim/base/deadline.h"

#include <gtest/gtest.h>

namespace prehend {
namespace {

TEST(Deadline, IsNeverUnlessItIsSet) {
  EXPECT_FALSE(Deadline().is_set());
  EXPECT_FALSE(Deadline().has_passed());
  EXPECT_FALSE(Deadline().part(0.0).has_passed());
  EXPECT_FALSE(Deadline::in(std::numeric_limits<double>::infinity()).is_set());
  EXPECT_FALSE(Deadline::in(1e30).is_set());
}

TEST(Deadline, PassesOnceItsTimeIsOver) {
  EXPECT_TRUE(Deadline::in(0.0).has_passed());
  EXPECT_TRUE(Deadline::in(-1.0).has_passed());
  const Deadline tomorrow = Deadline::in(86400.0);
  EXPECT_TRUE(tomorrow.is_set());
  EXPECT_FALSE(tomorrow.has_passed());
}

TEST(Deadline, APartIsOverEarlier) {
  const Deadline tomorrow = Deadline::in(86400.0);
  EXPECT_FALSE(tomorrow.part(0.5).has_passed());
  EXPECT_TRUE(tomorrow.part(0.0).has_passed());
  // Of what is left, which is nothing where the time is over.
  EXPECT_TRUE(Deadline::in(-1.0).part(0.5).has_passed());
  EXPECT_FALSE(tomorrow.part(1.0).has_passed());
}

}  // namespace
}  // namespace prehend
