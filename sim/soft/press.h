// The pressure of an elastic surface on a rigid one, without friction.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace prehend {

// Nodes of an elastic surface before a rigid one, n of them. As the two approach each other by d,
// the gap of node i along the normal of the rigid surface there is
//   gap_i - weight_i d + (compliance p)_i,
// with the normal forces p on the nodes.
struct PressProblem {
  Eigen::MatrixXd compliance;  // n x n, symmetric and positive definite [m/N]
  Eigen::VectorXd gap;         // [m]
  Eigen::VectorXd weight;      // > 0: cosine between the approach and the normal
};

// The normal forces at an approach.
struct NodeForces {
  double approach = 0.0;  // [m]
  Eigen::VectorXd force;  // n, >= 0 [N]
  Eigen::VectorXd gap;    // n, >= 0 up to rounding, 0 where there is a force [m]
  double load = 0.0;      // weight . force: what presses the surfaces together [N]
};

// The forces with gap >= 0, force >= 0 and one of them 0 at each node (Signorini's conditions):
// the only ones, as the compliance is positive definite. Solved by pivoting in blocks, and one by
// one where that does not come nearer. Source: Portugal, Judice and Vicente, "A comparison of block
// pivoting and interior-point algorithms for linear least squares problems with nonnegative
// variables", 1994.
NodeForces press_by(const PressProblem& problem, double approach);

// The same with the approach at which the load is `load` > 0 [N], but at most `farthest` [m]:
// then with less load.
NodeForces press_with(const PressProblem& problem, double load, double farthest);

}  // namespace prehend
