// Friction at the nodes of an elastic surface that is pressed and then moved sideways.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace prehend {

// Nodes in contact, n of them; each has two tangents, rows 2i and 2i + 1.
struct ShearProblem {
  Eigen::MatrixXd compliance;  // 2n x 2n, symmetric and positive definite [m/N]
  Eigen::VectorXd motion;      // 2n: how far the surface beneath moves at each node [m]
  Eigen::VectorXd limit;       // n: friction times the normal force, >= 0 [N]
};

struct ShearOptions {
  double tolerance = 1e-9;  // of forces, as a part of the sum of the limits
  int max_sweeps = 2000;
};

struct ShearForces {
  Eigen::VectorXd force;       // 2n: on the nodes, against the motion [N]
  std::vector<bool> sticking;  // n
  bool converged = false;      // else the best forces that were found
};

// Coulomb friction of one motion that starts without tangential forces, with normal forces that it
// does not change: nodes that stick have moved back by as much as the surface beneath has moved on,
// the others bear their limit, against their slip. The minimum of a convex function over discs, by
// sweeps over the nodes. Source: Kalker, "Three-dimensional elastic bodies in rolling contact",
// 1990, chapter 4 (the tangential problem).
ShearForces shear(const ShearProblem& problem, const ShearOptions& options = {});

}  // namespace prehend
