#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/base/input_error.h"
#include "sim/base/json/json_field.h"
#include "sim/shape/cloud/files/cloud_views.h"
#include "sim/shape/cloud/files/depth_png.h"
#include "sim/shape/cloud/files/point_cloud.h"
#include "sim/shape/cloud/files/views_file.h"
#include "tests/fuzz/mesh_promises.h"
#include "tests/fuzz/untrusted_files.h"

namespace prehend::fuzz {
namespace {

void check_view(const DepthView& view) {
  const DepthCamera& camera = view.camera;
  promised(camera.width > 0 && camera.height > 0, "an image has pixels");
  const std::size_t pixels =
      static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
  promised(pixels <= kMostReadings, "an image has no more pixels than are read");
  promised(view.depth.size() == pixels, "each pixel has a depth");
  promised(camera.fx > 0.0 && camera.fy > 0.0 &&
               std::isfinite(camera.fx + camera.fy + camera.cx + camera.cy),
           "a camera is a camera");
  promised(finite(camera.X_WC), "the pose of a camera is finite");
  promised(std::all_of(view.depth.begin(), view.depth.end(),
                       [](float z) { return std::isfinite(z) && z >= 0.0F; }),
           "no depth is negative or infinite");
}

// A reader of bytes does not know their file.
template <typename Read>
void read_cloud(std::string_view name, const Read& read) {
  try {
    const PointCloud cloud = read();
    promised(cloud.points.size() <= kMostReadings, "no more points than are read");
    promised(cloud.normals.empty() || cloud.normals.size() == cloud.points.size(),
             "each point has a normal, or none has");
    promised(cloud.width * cloud.height == cloud.points.size(), "a grid holds all points");
    std::vector<std::string> notes;
    for (const DepthView& view : views_of_cloud(cloud, {}, notes)) check_view(view);
  } catch (const InputError& error) {
    throw error.in_file(pretended_path(name, "cloud"));
  }
}

}  // namespace

void read_pcd_file(std::string_view name, const std::string& bytes) {
  read_cloud(name, [&] { return read_pcd(bytes); });
}

void read_ply_cloud_file(std::string_view name, const std::string& bytes) {
  read_cloud(name, [&] { return read_ply_cloud(bytes); });
}

void read_depth_png_file(std::string_view name, const std::string& bytes) {
  try {
    const DepthImage image = read_depth_png(bytes);
    promised(image.width > 0 && image.height > 0, "an image has pixels");
    promised(image.counts.size() ==
                 static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
             "each pixel has a count");
  } catch (const InputError& error) {
    throw error.in_file(pretended_path(name, "png"));
  }
}

void read_views_file(std::string_view name, const std::string& bytes) {
  const JsonFile file(pretended_path(name, "json"), bytes);
  for (const DepthView& view : read_views(file.root()).views) check_view(view);
}

}  // namespace prehend::fuzz
