// The cones of a conic program, and their algebra: a nonnegative orthant and second-order cones.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace prehend {

// The cone of a program: the product of a nonnegative orthant and of second-order cones
// {(v0, v1) : v0 >= |v1|}, v0 being the first row of each. The rows of a vector are those of the
// orthant, then those of the second-order cones, one cone after the other.
struct ConeSizes {
  // Number of rows that must each be >= 0.
  int orthant = 0;
  // Number of rows of each second-order cone, >= 1.
  std::vector<int> second_order;

  // Number of rows of all cones together.
  int rows() const;
  // Degree of the logarithmic barrier: 1 for each row of the orthant and for each second-order
  // cone.
  int degree() const;
};

// All vectors below have ConeSizes::rows() rows. Source of the algebra: Vandenberghe, "The CVXOPT
// linear and quadratic cone program solvers", 2010, sections 3 to 5.

// The identity e of the Jordan product: e o v = v for all v.
Eigen::VectorXd cone_identity(const ConeSizes& cone);

// The Jordan product u o v: element by element in the orthant, (u'v, u0 v1 + v0 u1) in a
// second-order cone.
Eigen::VectorXd cone_product(const ConeSizes& cone, const Eigen::VectorXd& u,
                             const Eigen::VectorXd& v);

// Inverse of the Jordan product: the v with u o v = d, for u in the interior of the cone.
Eigen::VectorXd cone_quotient(const ConeSizes& cone, const Eigen::VectorXd& u,
                              const Eigen::VectorXd& d);

// The largest a for which v - a e is in the cone: how far v is inside it, or outside if negative.
// Infinite where the cone has no rows.
double cone_margin(const ConeSizes& cone, const Eigen::VectorXd& v);

// The largest step a >= 0 for which u + a d is in the cone, for u in its interior; may be infinite.
double cone_step(const ConeSizes& cone, const Eigen::VectorXd& u, const Eigen::VectorXd& d);

// Calls visit(first row, rows) for each second-order cone.
template <typename Visit>
void for_each_second_order(const ConeSizes& cone, Visit visit) {
  Eigen::Index first = cone.orthant;
  for (const int rows : cone.second_order) {
    visit(first, static_cast<Eigen::Index>(rows));
    first += rows;
  }
}

// sqrt(v0^2 - |v1|^2) of the rows of one second-order cone, without the cancellation of that
// difference; NaN outside the cone.
double cone_root(const Eigen::Ref<const Eigen::VectorXd>& v);

// The largest magnitude of all entries of a matrix or vector; 0 for one without entries.
template <typename Derived>
double largest_entry(const Eigen::MatrixBase<Derived>& m) {
  return m.size() > 0 ? m.cwiseAbs().maxCoeff() : 0.0;
}

}  // namespace prehend
