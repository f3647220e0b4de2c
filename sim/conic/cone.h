// The cones of a conic program, and their algebra: a nonnegative orthant and second-order cones.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace prehend {

// The product of the orthant of `orthant` numbers >= 0 and of second-order cones {v : v0 >= |v1|},
// v0 the first of its `second_order[i]` >= 1 rows. The rows of a vector follow one another so.
struct ConeSizes {
  int orthant = 0;
  std::vector<int> second_order;

  int rows() const;
  int degree() const;  // of the barrier: one for a row of the orthant, one for a second-order cone
};

// All vectors below have ConeSizes::rows() rows. Source of the algebra: Vandenberghe, "The CVXOPT
// linear and quadratic cone program solvers", 2010, sections 3 to 5.

// The vector e with e o v = v.
Eigen::VectorXd cone_identity(const ConeSizes& cone);

// The Jordan product u o v: products in the orthant, (u'v, u0 v1 + v0 u1) in a second-order cone.
Eigen::VectorXd cone_product(const ConeSizes& cone, const Eigen::VectorXd& u,
                             const Eigen::VectorXd& v);

// The v with u o v = d, for u inside the cone.
Eigen::VectorXd cone_quotient(const ConeSizes& cone, const Eigen::VectorXd& u,
                              const Eigen::VectorXd& d);

// The largest a for which v - a e is in the cone: not negative for a v of the cone. Infinite where
// the cone has no rows.
double cone_margin(const ConeSizes& cone, const Eigen::VectorXd& v);

// The largest a >= 0 for which u + a d is in the cone, for u inside it; may be infinite.
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

// sqrt(v0^2 - |v1|^2) without its cancellation; not a number outside the cone.
double cone_root(const Eigen::Ref<const Eigen::VectorXd>& v);

}  // namespace prehend
