#include "sim/quality/support.h"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "tests/support/grasp_families.h"

namespace prehend::test {
namespace {

Wrench random_normal(Random& random) {
  Wrench direction;
  for (double& entry : direction) entry = random.uniform(-1.0, 1.0);
  return direction;
}

TEST(ColumnSupport, IsTheBestColumn) {
  Random random(3);
  for (int columns = 1; columns < 40; ++columns) {
    Wrenches wrenches(6, columns);
    for (Eigen::Index j = 0; j < columns; ++j) wrenches.col(j) = random_normal(random);
    const ColumnSupport set(wrenches);
    for (int i = 0; i < 20; ++i) {
      const Wrench direction = random_normal(random);
      Eigen::Index best = 0;
      (direction.transpose() * wrenches).maxCoeff(&best);
      EXPECT_EQ(set.support(direction), wrenches.col(best)) << columns << " columns";
    }
  }
}

TEST(ColumnSupport, TiesGoToTheFirstColumn) {
  Wrenches wrenches = Wrenches::Zero(6, 20);
  wrenches.row(0).setOnes();
  for (int j = 0; j < 20; ++j) wrenches(1, j) = j;
  EXPECT_EQ(ColumnSupport(wrenches).support(Wrench::Unit(0)), wrenches.col(0));
  EXPECT_EQ(ColumnSupport(wrenches).support(Wrench::Unit(1)), wrenches.col(19));
}

TEST(ColumnSupport, RejectsNothingAndNonsense) {
  EXPECT_THROW(ColumnSupport(Wrenches(6, 0)), InputError);
  Wrenches wrenches = Wrenches::Zero(6, 3);
  wrenches(4, 2) = std::numeric_limits<double>::quiet_NaN();
  try {
    const ColumnSupport set(wrenches);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "wrenches[2]: not finite");
  }
}

}  // namespace
}  // namespace prehend::test
