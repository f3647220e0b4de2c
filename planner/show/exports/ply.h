// Triangles as a PLY file (ASCII).
#pragma once

#include <string>

#include <Eigen/Core>

namespace prehend {

// The file as text. `vertices`: 3 x V, one vertex a column; `triangles`: 3 x T, the indices of one
// triangle's vertices a column.
std::string ply_text(const Eigen::Matrix3Xd& vertices, const Eigen::Matrix3Xi& triangles);

}  // namespace prehend
