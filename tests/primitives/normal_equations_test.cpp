// The solution of the equations, against Eigen's.
#include "primitives/normal_equations.h"

#include <gtest/gtest.h>

#include "sim/base/random.h"

namespace prehend {
namespace {

using Equations = NormalEquations<7>;

// Of as many random rows; the upper triangle is left at zero, as in the fits.
Equations random_equations(int rows, Random& random) {
  Equations equations;
  for (int i = 0; i < rows; ++i) {
    Equations::Vector slope;
    for (double& x : slope) x = random.uniform(-1.0, 1.0);
    equations.normal += slope * slope.transpose();
    equations.right -= random.uniform(-1.0, 1.0) * slope;
  }
  equations.normal = Equations::Matrix(equations.normal.triangularView<Eigen::Lower>());
  return equations;
}

Equations::Vector reference(const Equations& equations) {
  Equations::Matrix full = equations.normal.selfadjointView<Eigen::Lower>();
  full.diagonal() *= 1.0 + 1e-4;
  full.diagonal().array() += 1e-12;
  return full.fullPivLu().solve(equations.right);
}

// Also with fewer rows than unknowns, where only the damping determines the change: then the matrix
// has a condition of some 1e5, which leaves 1e-10 of the accuracy.
TEST(NormalEquations, AreSolved) {
  Random random(1);
  for (const int rows : {1, 3, 7, 100}) {
    Equations equations = random_equations(rows, random);
    const Equations::Vector expected = reference(equations);
    EXPECT_LT((equations.damped_change() - expected).norm(), 1e-9 * expected.norm()) << rows;
  }
}

TEST(NormalEquations, AFixedUnknownStays) {
  Random random(2);
  for (int unknown = 0; unknown < 7; ++unknown) {
    Equations equations = random_equations(20, random);
    equations.fix(unknown);
    const Equations::Vector expected = reference(equations);
    const Equations::Vector change = equations.damped_change();
    EXPECT_EQ(change[unknown], 0.0);
    EXPECT_LT((change - expected).norm(), 1e-10 * expected.norm());
  }
}

TEST(NormalEquations, WithoutPointsNothingChanges) {
  Equations equations;
  EXPECT_EQ(equations.damped_change().norm(), 0.0);
}

}  // namespace
}  // namespace prehend
