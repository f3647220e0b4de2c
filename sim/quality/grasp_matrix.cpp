#include "sim/quality/grasp_matrix.h"

#include <Eigen/SVD>

namespace prehend {
namespace {

Eigen::Index columns_of(ContactModel model) {
  if (model == ContactModel::frictionless) return 1;
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
    matrix.middleCols(columns, count) = contact_map(contact, frame).leftCols(count);
    columns += count;
  }
  return matrix;
}

double smallest_singular_value(const Eigen::MatrixXd& grasp_matrix) {
  if (grasp_matrix.cols() < 6) return 0.0;
  return singular_values(grasp_matrix).minCoeff();
}

double isotropy(const Eigen::MatrixXd& grasp_matrix) {
  if (grasp_matrix.cols() < 6) return 0.0;
  const Eigen::VectorXd values = singular_values(grasp_matrix);
  return values.maxCoeff() > 0.0 ? values.minCoeff() / values.maxCoeff() : 0.0;
}

double manipulability(const Eigen::MatrixXd& jacobian) {
  return jacobian.size() == 0 ? 0.0 : singular_values(jacobian).prod();
}

}  // namespace prehend
