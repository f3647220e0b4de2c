#include "planner/show/exports/ply.h"

#include <limits>
#include <sstream>

namespace prehend {

std::string ply_text(const Eigen::Matrix3Xd& vertices, const Eigen::Matrix3Xi& triangles) {
  std::ostringstream text;
  // Enough digits to read back the same double.
  text.precision(std::numeric_limits<double>::max_digits10);
  text << "ply\nformat ascii 1.0\nelement vertex " << vertices.cols()
       << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
       << triangles.cols() << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& v : vertices.colwise()) text << v[0] << " " << v[1] << " " << v[2] << "\n";
  for (const auto& t : triangles.colwise()) {
    text << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
  }
  return text.str();
}

}  // namespace prehend
