#include "planner/results/datasets/pose_matrix.h"

#include <cmath>
#include <limits>

#include <Eigen/SVD>

#include "sim/base/json/json_field.h"
#include "sim/base/range.h"

namespace prehend {
namespace {

constexpr double kExact = 1e-9;
constexpr double kNearly = 1e-3;

// By how much the matrix is no rotation: NaN or infinity where it is not finite.
double distance_to_rotation(const Matrix3& matrix) {
  if (!(matrix.determinant() > 0.0)) return std::numeric_limits<double>::infinity();
  return (matrix.transpose() * matrix - Matrix3::Identity()).cwiseAbs().maxCoeff();
}

Matrix3 nearest_rotation(const Matrix3& matrix) {
  const Eigen::JacobiSVD<Matrix3> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

// The matrix, and by how much it is no rigid transform: infinity where it cannot be meant as one.
struct Measured {
  Eigen::Matrix4d matrix;
  double off = std::numeric_limits<double>::infinity();
};

Measured measured(std::span<const double, kMatrixSize> values) {
  Measured result;
  Eigen::Matrix4d& matrix = result.matrix;
  for (Eigen::Index row = 0; row < 4; ++row) {
    for (Eigen::Index column = 0; column < 4; ++column) {
      matrix(row, column) = values[static_cast<std::size_t>(4 * row + column)];
    }
  }
  if (!matrix.allFinite() || matrix.cwiseAbs().maxCoeff() > kLargestNumber) return result;
  if (matrix.row(3) != Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0)) return result;
  result.off = distance_to_rotation(matrix.topLeftCorner<3, 3>());
  return result;
}

}  // namespace

void append_matrix(const Pose& pose, std::vector<double>& values) {
  for (Eigen::Index row = 0; row < 4; ++row) {
    for (Eigen::Index column = 0; column < 4; ++column) {
      values.push_back(pose.matrix()(row, column));
    }
  }
}

std::optional<Pose> pose_of_matrix(std::span<const double, kMatrixSize> values) {
  const Measured given = measured(values);
  if (!(given.off <= kNearly)) return {};
  Pose pose;
  pose.matrix() = given.matrix;
  if (given.off > kExact) pose.linear() = nearest_rotation(given.matrix.topLeftCorner<3, 3>());
  return pose;
}

bool is_exactly_rigid(std::span<const double, kMatrixSize> values) {
  return measured(values).off <= kExact;
}

bool is_unit(const Vector3& v) {
  constexpr double kTolerance = 1e-6;
  return std::abs(v.norm() - 1.0) <= kTolerance;
}

}  // namespace prehend
