// Triangles as a PLY file (ASCII).
#pragma once

#include <string>

#include <Eigen/Core>

namespace prehend {

// `vertices`: one a column; `triangles`: indices of three, one a column.
std::string ply_text(const Eigen::Matrix3Xd& vertices, const Eigen::Matrix3Xi& triangles);

}  // namespace prehend
