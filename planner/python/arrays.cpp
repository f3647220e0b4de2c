#include "planner/python/arrays.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "sim/shape/make_mesh.h"

namespace prehend::python {
namespace {

// Doubles and Integers are contiguous in C order (arrays.h), so that the functions below may read
// data() row by row.

// A negative size in `shape` stands for any number.
void expect_shape(const py::array& array, const std::vector<py::ssize_t>& shape) {
  bool fits = array.ndim() == static_cast<py::ssize_t>(shape.size());
  for (std::size_t d = 0; fits && d < shape.size(); ++d) {
    fits = shape[d] < 0 || array.shape(static_cast<py::ssize_t>(d)) == shape[d];
  }
  if (!fits) throw std::invalid_argument("an array of another shape");
}

// NumPy's rows lie one after the other, Eigen's columns.
using RowMajor4 = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

Pose pose_at(const double* data) {
  Pose pose = Pose::Identity();
  const Eigen::Map<const RowMajor4> matrix(data);
  pose.linear() = matrix.topLeftCorner<3, 3>();
  pose.translation() = matrix.topRightCorner<3, 1>();
  return pose;
}

void write(const Pose& pose, double* data) {
  Eigen::Map<RowMajor4> matrix(data);
  matrix = pose.matrix();
}

template <class Array, class Row>
Array rows_of_three(const std::vector<Row>& rows) {
  // With an explicit shape, so that an empty list is 0 x 3 as well.
  Array array({static_cast<py::ssize_t>(rows.size()), py::ssize_t{3}});
  auto* next = array.mutable_data();
  for (const Row& row : rows) next = std::copy(row.begin(), row.end(), next);
  return array;
}

}  // namespace

Pose pose_of(const Doubles& array) {
  expect_shape(array, {4, 4});
  return pose_at(array.data());
}

std::vector<Pose> poses_of(const Doubles& array) {
  expect_shape(array, {-1, 4, 4});
  std::vector<Pose> poses;
  for (py::ssize_t i = 0; i < array.shape(0); ++i) poses.push_back(pose_at(array.data(i, 0, 0)));
  return poses;
}

Vector3 vector_of(const Doubles& array) {
  expect_shape(array, {3});
  return {array.at(0), array.at(1), array.at(2)};
}

std::vector<Vector3> vectors_of(const Doubles& array) {
  expect_shape(array, {-1, 3});
  std::vector<Vector3> vectors;
  vectors.reserve(static_cast<std::size_t>(array.shape(0)));
  for (py::ssize_t i = 0; i < array.shape(0); ++i) {
    const double* row = array.data(i, 0);
    vectors.emplace_back(row[0], row[1], row[2]);
  }
  return vectors;
}

std::vector<double> numbers_of(const Doubles& array) {
  expect_shape(array, {-1});
  return {array.data(), array.data() + array.size()};
}

Eigen::MatrixXd matrix_of(const Doubles& array) {
  expect_shape(array, {-1, -1});
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  // The conversion to a column-major matrix copies the numbers.
  return Eigen::Map<const RowMajor>(array.data(), array.shape(0), array.shape(1));
}

TriangleMesh mesh_of(const Doubles& vertices, const Integers& faces) {
  expect_shape(faces, {-1, 3});
  TriangleMesh mesh{vectors_of(vertices), {}};
  mesh.triangles.reserve(static_cast<std::size_t>(faces.shape(0)));
  for (py::ssize_t i = 0; i < faces.shape(0); ++i) {
    const int* row = faces.data(i, 0);
    mesh.triangles.push_back({row[0], row[1], row[2]});
  }
  return mesh;
}

TriangleMesh cleaned_mesh(const Doubles& vertices, const Integers& faces) {
  TriangleMesh raw = mesh_of(vertices, faces);
  return make_mesh(std::move(raw.vertices), std::move(raw.triangles));
}

Doubles to_array(const Pose& pose) {
  Doubles array({4, 4});
  write(pose, array.mutable_data());
  return array;
}

Doubles to_array(const std::vector<Pose>& poses) {
  Doubles array({static_cast<py::ssize_t>(poses.size()), py::ssize_t{4}, py::ssize_t{4}});
  double* next = array.mutable_data();
  for (const Pose& pose : poses) {
    write(pose, next);
    next += 16;
  }
  return array;
}

Doubles to_array(const Vector3& vector) { return Doubles(3, vector.data()); }

Doubles to_array(const std::vector<Vector3>& rows) { return rows_of_three<Doubles>(rows); }

Doubles to_array(const std::vector<double>& numbers) {
  return Doubles(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

Doubles to_array(const std::vector<std::vector<double>>& rows, std::size_t columns) {
  Doubles array({static_cast<py::ssize_t>(rows.size()), static_cast<py::ssize_t>(columns)});
  double* next = array.mutable_data();
  for (const std::vector<double>& row : rows) {
    // A bug, not a mistake of the caller: rows are made in C++.
    if (row.size() != columns) throw std::logic_error("rows of different lengths");
    next = std::copy(row.begin(), row.end(), next);
  }
  return array;
}

Doubles to_array(const Eigen::MatrixXd& matrix) {
  Doubles array({matrix.rows(), matrix.cols()});
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::Map<RowMajor>(array.mutable_data(), matrix.rows(), matrix.cols()) = matrix;
  return array;
}

Integers to_array(const std::vector<int>& numbers) {
  return Integers(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

Integers to_array(const std::vector<Triangle>& triangles) {
  return rows_of_three<Integers>(triangles);
}

}  // namespace prehend::python
