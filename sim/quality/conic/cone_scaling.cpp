#include "sim/quality/conic/cone_scaling.h"

#include <cmath>
#include <cstddef>

namespace prehend {

// In the orthant W is diagonal with the entries sqrt(s / z), and lambda is sqrt(s z). A point on
// the border of a cone, or outside by rounding, makes an entry zero, infinite or not a number.
ConeScaling::ConeScaling(const ConeSizes& cone, const Eigen::VectorXd& s, const Eigen::VectorXd& z)
    : cone_(cone), lambda_(cone.rows()), point_(cone.rows()) {
  const Eigen::Index n = cone.orthant;
  point_.head(n) = s.head(n).cwiseQuotient(z.head(n)).cwiseSqrt();
  lambda_.head(n) = s.head(n).cwiseProduct(z.head(n)).cwiseSqrt();
  for_each_second_order(
      cone_, [&](Eigen::Index first, Eigen::Index rows) { scale_second_order(s, z, first, rows); });
  valid_ = lambda_.allFinite() && point_.allFinite() && cone_margin(cone_, lambda_) > 0.0;
}

// For second-order cones W is a hyperbolic rotation times a size. s and z are scaled to the unit
// hyperboloid v0^2 - |v1|^2 = 1; the vector w that defines the rotation is the normalised sum of
// s_unit and the reflection (z0, -z1) of z_unit, and the size is the fourth root of the ratio of
// the two determinants v0^2 - |v1|^2.
void ConeScaling::scale_second_order(const Eigen::VectorXd& s, const Eigen::VectorXd& z,
                                     Eigen::Index first, Eigen::Index rows) {
  const double s_root = cone_root(s.segment(first, rows));
  const double z_root = cone_root(z.segment(first, rows));
  const Eigen::VectorXd s_unit = s.segment(first, rows) / s_root;
  const Eigen::VectorXd z_unit = z.segment(first, rows) / z_root;
  const double gamma = std::sqrt((1.0 + s_unit.dot(z_unit)) / 2.0);
  point_.segment(first, rows) = (s_unit - z_unit) / (2.0 * gamma);
  point_[first] = (s_unit[0] + z_unit[0]) / (2.0 * gamma);
  size_.push_back(std::sqrt(s_root / z_root));
  // lambda without the cancellation of W z.
  const double lambda_root = std::sqrt(s_root) * std::sqrt(z_root);
  lambda_[first] = lambda_root * gamma;
  lambda_.segment(first + 1, rows - 1) =
      lambda_root / (s_unit[0] + z_unit[0] + 2.0 * gamma) *
      ((gamma + z_unit[0]) * s_unit.tail(rows - 1) + (gamma + s_unit[0]) * z_unit.tail(rows - 1));
}

// W m, or W^-1 m with `sign` -1. With w = (w0, w1) on the unit hyperboloid, the rotation is
//   [ w0  w1'                   ]
//   [ w1  I + w1 w1' / (1 + w0) ],
// and its inverse has the same form with the sign of w1 changed. It is applied without being made.
Eigen::MatrixXd ConeScaling::product(const Eigen::MatrixXd& m, double sign) const {
  Eigen::MatrixXd result(m.rows(), m.cols());
  const Eigen::Index n = cone_.orthant;
  if (sign > 0.0) {
    result.topRows(n) = point_.head(n).asDiagonal() * m.topRows(n);
  } else {
    result.topRows(n) = point_.head(n).cwiseInverse().asDiagonal() * m.topRows(n);
  }
  std::size_t index = 0;
  for_each_second_order(cone_, [&](Eigen::Index first, Eigen::Index rows) {
    const double size = sign > 0.0 ? size_[index] : 1.0 / size_[index];
    ++index;
    const double w0 = point_[first];
    const auto w1 = point_.segment(first + 1, rows - 1);
    const Eigen::RowVectorXd along = sign * w1.transpose() * m.middleRows(first + 1, rows - 1);
    result.row(first) = size * (w0 * m.row(first) + along);
    result.middleRows(first + 1, rows - 1) =
        size *
        (m.middleRows(first + 1, rows - 1) + sign * w1 * (m.row(first) + along / (1.0 + w0)));
  });
  return result;
}

}  // namespace prehend
