// Clouds of points as their files have them: PCD and PLY.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "sim/base/pose.h"

namespace prehend {

using PointList = std::vector<Eigen::Vector3f>;

// Points in the frame F and the unit of their file.
struct PointCloud {
  PointList points;   // one that is not finite is no reading
  PointList normals;  // as many, or none; not necessarily unit
  // Where the file has them row by row, as the pixels of an image: points = width x height. Else a
  // height of 1.
  std::size_t width = 0;
  std::size_t height = 1;
  std::optional<Pose> X_FV = {};  // where the camera stood, if the file says so
};

// All views and clouds of an input together have at most so many pixels and points.
inline constexpr std::size_t kMostReadings = 10'000'000;

// Throws InputError where so many pixels or points are too many; `what` they are.
void require_few(std::size_t count, std::string_view what);

// Numbers beyond the range of float as infinity: to convert them is undefined.
float in_single(double value);

// PLY, text and binary: of the element vertex x, y and z and, if there are all three, nx, ny and
// nz, of any type. Other properties and elements are passed over. Throws InputError, with the line
// number in text files.
PointCloud read_ply_cloud(std::string_view bytes);

// PCD 0.5 to 0.7 (the Point Cloud Library's "The PCD file format"): ascii, binary and
// binary_compressed, with fields in any order, of any type and size. Read are x, y and z and, if
// there are all three, normal_x, normal_y and normal_z. Throws InputError, with the line number in
// the header and in ascii.
PointCloud read_pcd(std::string_view bytes);

}  // namespace prehend
