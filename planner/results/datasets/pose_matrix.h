// Poses as the 4 x 4 matrices of data sets.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim/base/pose.h"
#include "sim/base/range.h"

namespace prehend {

inline constexpr std::size_t kMatrixSize = 16;

// Appends the homogeneous matrix of the pose, row by row.
void append_matrix(const Pose& pose, std::vector<double>& values);

// The pose of a matrix, row by row: none unless it is a rotation within 1e-3 (others print fewer
// digits), a finite translation of at most kLargestNumber and a last row 0 0 0 1. A rotation that
// is one within 1e-9 stays as it is to the bit, others become the nearest one.
std::optional<Pose> pose_of_matrix(std::span<const double, kMatrixSize> values);

// Whether pose_of_matrix leaves it as it is to the bit.
bool is_exactly_rigid(std::span<const double, kMatrixSize> values);

// Whether the length is 1, within 1e-6.
bool is_unit(const Vector3& v);

}  // namespace prehend
