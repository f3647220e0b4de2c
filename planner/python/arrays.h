// Conversion between NumPy arrays and the planner's values. Arrays that are made here own their
// memory.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <string>
#include <vector>

#include "sim/base/pose.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend::python {

namespace py = pybind11;

// Whatever NumPy can convert: other number types, other memory layouts, slices.
using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<int, py::array::c_style | py::array::forcecast>;

// What a caller may get wrong about shapes is refused in Python, where arguments have names
// (prehend/_arrays.py). These throw std::invalid_argument for another shape all the same, so that
// nothing is read beyond an array's end.
Pose pose_of(const Doubles& array);                                    // 4 x 4
std::vector<Pose> poses_of(const Doubles& array);                      // N x 4 x 4
Vector3 vector_of(const Doubles& array);                               // 3
std::vector<Vector3> vectors_of(const Doubles& array);                 // N x 3
std::vector<double> numbers_of(const Doubles& array);                  // N
Eigen::MatrixXd matrix_of(const Doubles& array);                       // rows x columns
TriangleMesh mesh_of(const Doubles& vertices, const Integers& faces);  // V x 3, F x 3

// The same as the contents of a mesh file: equal vertices are joined and triangles turned outward.
TriangleMesh cleaned_mesh(const Doubles& vertices, const Integers& faces);

Doubles to_array(const Pose& pose);                    // 4 x 4
Doubles to_array(const std::vector<Pose>& poses);      // N x 4 x 4
Doubles to_array(const Vector3& vector);               // 3
Doubles to_array(const std::vector<Vector3>& rows);    // N x 3
Doubles to_array(const std::vector<double>& numbers);  // N
// Each row has `columns` numbers; N x columns also where there is no row.
Doubles to_array(const std::vector<std::vector<double>>& rows, std::size_t columns);
Doubles to_array(const Eigen::MatrixXd& matrix);  // rows x columns
Integers to_array(const std::vector<int>& numbers);
Integers to_array(const std::vector<Triangle>& triangles);  // F x 3

}  // namespace prehend::python
