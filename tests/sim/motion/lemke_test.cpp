#include "sim/motion/lemke.h"

#include <gtest/gtest.h>

#include "sim/base/random.h"

namespace prehend {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

void expect_solves(const MatrixXd& M, const VectorXd& q, const VectorXd& z, double tolerance) {
  const VectorXd w = M * z + q;
  EXPECT_GE(z.minCoeff(), 0.0);
  EXPECT_LT(z.cwiseMin(w).cwiseAbs().maxCoeff(), tolerance);
}

MatrixXd random_matrix(Random& random, int rows, int columns) {
  MatrixXd matrix(rows, columns);
  for (double& value : matrix.reshaped()) value = random.uniform(-1.0, 1.0);
  return matrix;
}

// A positive definite matrix has exactly one solution: from whichever z >= 0 and w >= 0 with
// z . w = 0 the problem was made, these are what is found.
TEST(Lemke, FindsTheOnlySolutionOfPositiveDefiniteProblems) {
  Random random(11);
  for (int trial = 0; trial < 300; ++trial) {
    const int n = 1 + trial % 30;
    const MatrixXd root = random_matrix(random, n, n);
    const MatrixXd skew = random_matrix(random, n, n);
    const MatrixXd M =
        root * root.transpose() + 0.1 * MatrixXd::Identity(n, n) + skew - skew.transpose();
    VectorXd z = VectorXd::Zero(n);
    VectorXd w = VectorXd::Zero(n);
    for (int i = 0; i < n; ++i)
      (random.uniform(0.0, 1.0) < 0.5 ? z : w)[i] = random.uniform(0.1, 1.0);
    const LcpSolution found = solve_lcp(M, w - M * z);
    ASSERT_EQ(found.outcome, LcpOutcome::solved) << trial;
    EXPECT_LT((found.z - z).cwiseAbs().maxCoeff(), 1e-9) << trial;
  }
}

// Of a matrix that is only semidefinite, with every contact stated three times: all ratio tests are
// ties, and any of the solutions will do.
TEST(Lemke, TiesOfRepeatedContactsEnd) {
  Random random(12);
  for (int trial = 0; trial < 100; ++trial) {
    const int n = 1 + trial % 12;
    const MatrixXd rows = random_matrix(random, n, 4);
    MatrixXd repeated(3 * n, 4);
    repeated << rows, rows, rows;
    const MatrixXd M = repeated * repeated.transpose();
    const VectorXd q = repeated * random_matrix(random, 4, 1);
    const LcpSolution found = solve_lcp(M, q);
    ASSERT_EQ(found.outcome, LcpOutcome::solved) << trial;
    expect_solves(M, q, found.z, 1e-9);
  }
}

TEST(Lemke, AProblemWithoutSolutionEndsOnARay) {
  const MatrixXd M = MatrixXd::Zero(2, 2);  // w = q, of which one is negative
  EXPECT_EQ(solve_lcp(M, Eigen::Vector2d(1.0, -1.0)).outcome, LcpOutcome::ray);
}

TEST(Lemke, WhatIsNotNegativeNeedsNoPivot) {
  const LcpSolution found = solve_lcp(MatrixXd::Identity(3, 3), Eigen::Vector3d(0.0, 1.0, 2.0));
  EXPECT_EQ(found.outcome, LcpOutcome::solved);
  EXPECT_EQ(found.pivots, 0);
  EXPECT_TRUE(found.z.isZero(0.0));
}

TEST(Lemke, PivotsAreLimited) {
  const MatrixXd M = MatrixXd::Identity(5, 5);
  const LcpSolution found = solve_lcp(M, VectorXd::LinSpaced(5, -5.0, -1.0), 2);
  EXPECT_EQ(found.outcome, LcpOutcome::too_long);
  EXPECT_EQ(found.pivots, 2);
}

}  // namespace
}  // namespace prehend
