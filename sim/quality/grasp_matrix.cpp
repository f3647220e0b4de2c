#include "sim/quality/grasp_matrix.h"

#include <algorithm>
#include <cmath>

#include <Eigen/SVD>

#include "sim/base/input_error.h"
#include "sim/quality/ranges.h"
#include "sim/quality/suction_cup.h"

namespace prehend {
namespace {

// The columns of a contact map are in the order normal force, tangential forces, torque about the
// normal. What a model transmits is therefore always its first columns.
Eigen::Index columns_of(ContactModel model) {
  if (model == ContactModel::frictionless) return 1;
  if (model == ContactModel::suction) return 6;
  return model == ContactModel::point ? 3 : 4;
}

Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix) {
  return Eigen::JacobiSVD<Eigen::MatrixXd>(matrix).singularValues();
}

}  // namespace

Eigen::MatrixXd grasp_matrix(std::span<const Contact> contacts, const WrenchFrame& frame) {
  check_contacts(contacts, frame);
  Eigen::Index columns = 0;
  for (const Contact& contact : contacts) columns += columns_of(contact.model);
  Eigen::MatrixXd matrix(6, columns);
  columns = 0;
  for (const Contact& contact : contacts) {
    const Eigen::Index count = columns_of(contact.model);
    // A cup also transmits torques about the tangents.
    const Eigen::Index mapped = std::min<Eigen::Index>(count, 4);
    matrix.middleCols(columns, mapped) = contact_map(contact, frame).leftCols(mapped);
    if (count > mapped) matrix.middleCols(columns + mapped, 2) = tilt_map(contact, frame);
    columns += count;
  }
  return matrix;
}

// With fewer than six columns the rank is below six, so the sixth singular value is 0. The
// decomposition would list only as many values as there are columns.
double smallest_singular_value(const Eigen::MatrixXd& grasp_matrix) {
  if (grasp_matrix.cols() < 6) return 0.0;
  return singular_values(grasp_matrix).minCoeff();
}

double isotropy(const Eigen::MatrixXd& grasp_matrix) {
  if (grasp_matrix.cols() < 6) return 0.0;
  const Eigen::VectorXd values = singular_values(grasp_matrix);
  return values.maxCoeff() > 0.0 ? values.minCoeff() / values.maxCoeff() : 0.0;
}

// sqrt(det(J J')) is the product of the singular values of J, and so is sqrt(det(J' J)) where J has
// more rows than columns. Computed this way the products J J', which would square the condition
// number, are not needed.
double manipulability(const Eigen::MatrixXd& jacobian) {
  if (jacobian.size() == 0) return 0.0;
  require(jacobian.allFinite() && jacobian.cwiseAbs().maxCoeff() <= kLargestJacobian,
          {.field = "jacobian", .problem = "entries must be within 1e6 of 0"});
  const double product = singular_values(jacobian).prod();
  require(std::isfinite(product), {.field = "manipulability", .problem = "no double is as large"});
  return product;
}

}  // namespace prehend
