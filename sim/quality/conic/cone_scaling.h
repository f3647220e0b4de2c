// The Nesterov-Todd scaling of a pair of points inside a cone.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim/quality/conic/cone.h"

namespace prehend {

// The symmetric matrix W, block-diagonal over the cones, that maps the dual point z and the slack s
// to the same scaled point lambda = W z = W^-1 s. An interior point method takes its steps in these
// coordinates, in which primal and dual are treated alike.
//
// Source: Nesterov and Todd 1997; the formulas are those of Vandenberghe, "The CVXOPT linear and
// quadratic cone program solvers", 2010, section 4.
class ConeScaling {
 public:
  // s and z (ConeSizes::rows() rows each) should be in the interior of the cone; where rounding
  // has put them on its border, valid() is false.
  ConeScaling(const ConeSizes& cone, const Eigen::VectorXd& s, const Eigen::VectorXd& z);

  // Whether the scaling is finite and can be used.
  bool valid() const { return valid_; }

  // The scaled point.
  const Eigen::VectorXd& lambda() const { return lambda_; }

  // W m and W^-1 m for a matrix of any number of columns.
  Eigen::MatrixXd apply(const Eigen::MatrixXd& m) const { return product(m, 1.0); }
  Eigen::MatrixXd apply_inverse(const Eigen::MatrixXd& m) const { return product(m, -1.0); }

 private:
  Eigen::MatrixXd product(const Eigen::MatrixXd& m, double sign) const;
  void scale_second_order(const Eigen::VectorXd& s, const Eigen::VectorXd& z, Eigen::Index first,
                          Eigen::Index rows);

  ConeSizes cone_;
  bool valid_ = true;
  Eigen::VectorXd lambda_;
  Eigen::VectorXd point_;     // orthant: the diagonal of W; second-order cones: the unit point w
  std::vector<double> size_;  // of W, for each second-order cone
};

}  // namespace prehend
