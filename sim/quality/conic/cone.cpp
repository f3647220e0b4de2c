#include "sim/quality/conic/cone.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

// Each operation is done by cones: element by element for the rows of the orthant, and with the
// Jordan algebra of (v0, v1) for each second-order cone (Vandenberghe 2010, sections 3 to 5). The
// rows of the orthant come first, so that they are one segment of every vector. v0^2 - |v1|^2 plays
// the part of a determinant: it is positive in the interior of the cone and 0 on its border.
namespace prehend {

int ConeSizes::rows() const {
  return std::accumulate(second_order.begin(), second_order.end(), orthant);
}

int ConeSizes::degree() const { return orthant + static_cast<int>(second_order.size()); }

Eigen::VectorXd cone_identity(const ConeSizes& cone) {
  Eigen::VectorXd e = Eigen::VectorXd::Zero(cone.rows());
  e.head(cone.orthant).setOnes();
  for_each_second_order(cone, [&](Eigen::Index first, Eigen::Index) { e[first] = 1.0; });
  return e;
}

Eigen::VectorXd cone_product(const ConeSizes& cone, const Eigen::VectorXd& u,
                             const Eigen::VectorXd& v) {
  Eigen::VectorXd product = u.cwiseProduct(v);
  for_each_second_order(cone, [&](Eigen::Index first, Eigen::Index rows) {
    product[first] = u.segment(first, rows).dot(v.segment(first, rows));
    product.segment(first + 1, rows - 1) =
        u[first] * v.segment(first + 1, rows - 1) + v[first] * u.segment(first + 1, rows - 1);
  });
  return product;
}

// In a second-order cone u o v = d reads u0 v0 + u1'v1 = d0 and u0 v1 + v0 u1 = d1. With v1 from
// the second equation, the first becomes v0 (u0^2 - |u1|^2) = u0 d0 - u1'd1.
Eigen::VectorXd cone_quotient(const ConeSizes& cone, const Eigen::VectorXd& u,
                              const Eigen::VectorXd& d) {
  Eigen::VectorXd quotient = d.cwiseQuotient(u);
  for_each_second_order(cone, [&](Eigen::Index first, Eigen::Index rows) {
    const auto u1 = u.segment(first + 1, rows - 1);
    const auto d1 = d.segment(first + 1, rows - 1);
    const double root = cone_root(u.segment(first, rows));
    const double v0 = (u[first] * d[first] - u1.dot(d1)) / root / root;
    quotient[first] = v0;
    quotient.segment(first + 1, rows - 1) = (d1 - v0 * u1) / u[first];
  });
  return quotient;
}

// v - a e is in a second-order cone while v0 - a >= |v1|, and in the orthant while no entry is
// below a.
double cone_margin(const ConeSizes& cone, const Eigen::VectorXd& v) {
  double margin = std::numeric_limits<double>::infinity();
  if (cone.orthant > 0) margin = v.head(cone.orthant).minCoeff();
  for_each_second_order(cone, [&](Eigen::Index first, Eigen::Index rows) {
    margin = std::min(margin, v[first] - v.segment(first + 1, rows - 1).norm());
  });
  return margin;
}

// In a second-order cone the step is found in coordinates in which u is the identity e (a
// hyperbolic rotation and scaling that maps the cone to itself), and d becomes rho. e + a rho is in
// the cone while 1 + a rho0 >= a |rho1|, that is up to a = 1 / (|rho1| - rho0). `shrink` is the
// largest of the inverse steps of all cones; the step is infinite where none is positive.
double cone_step(const ConeSizes& cone, const Eigen::VectorXd& u, const Eigen::VectorXd& d) {
  double shrink = 0.0;
  for (Eigen::Index i = 0; i < cone.orthant; ++i) shrink = std::max(shrink, -d[i] / u[i]);
  for_each_second_order(cone, [&](Eigen::Index first, Eigen::Index rows) {
    const double root = cone_root(u.segment(first, rows));
    const double u0 = u[first] / root;
    const auto u1 = u.segment(first + 1, rows - 1);
    const auto d1 = d.segment(first + 1, rows - 1);
    const double rho0 = u0 * d[first] - u1.dot(d1) / root;
    const double along = (rho0 + d[first]) / (u0 + 1.0) / root;
    shrink = std::max(shrink, ((d1 - along * u1).norm() - rho0) / root);
  });
  return shrink > 0.0 ? 1.0 / shrink : std::numeric_limits<double>::infinity();
}

// From the factors v0 - |v1| and v0 + |v1|: near the border of the cone v0^2 and |v1|^2 are nearly
// equal, and the difference of these rounded squares would have few correct digits.
double cone_root(const Eigen::Ref<const Eigen::VectorXd>& v) {
  const double radius = v.tail(v.size() - 1).norm();
  return std::sqrt(v[0] - radius) * std::sqrt(v[0] + radius);
}

}  // namespace prehend
