// What a depth camera sees of boxes on a table, in closed form, and its files.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <png.h>

#include "sim/shape/cloud/depth_view.h"
#include "tests/support/depth_camera.h"

namespace prehend::test {

// A box with edges along the axes of the world, standing on z = 0.
struct StandingBox {
  Vector3 size = {0.05, 0.05, 0.1};
  double x = 0.0;
  double y = 0.0;
};

// Small enough to be written and read in a moment.
constexpr ImageSize kSmallImage{160, 120, 150.0};

// Along the ray p + t d, the least t > 0 at which it enters the box; infinite where it does not.
inline double entry(const StandingBox& box, const Vector3& p, const Vector3& d) {
  const Vector3 lower(box.x - 0.5 * box.size.x(), box.y - 0.5 * box.size.y(), 0.0);
  const Vector3 upper = lower + box.size;
  double first = 0.0;
  double last = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double a = (lower[k] - p[k]) / d[k];
    const double b = (upper[k] - p[k]) / d[k];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first <= last ? first : std::numeric_limits<double>::infinity();
}

// The boxes on the table z = 0, which ends 0.5 m from the origin.
inline DepthView view_of(const std::vector<StandingBox>& boxes, const DepthCamera& camera) {
  DepthView view{camera, {}};
  const Vector3 p = camera.X_WC.translation();
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      // With z = 1 in the camera's frame, so that t is the depth.
      const Vector3 d = camera.X_WC.linear() *
                        Vector3((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
      double t = d.z() < 0.0 ? -p.z() / d.z() : std::numeric_limits<double>::infinity();
      if (!((p + t * d).head<2>().norm() < 0.5)) t = std::numeric_limits<double>::infinity();
      for (const StandingBox& box : boxes) t = std::min(t, entry(box, p, d));
      view.depth.push_back(std::isfinite(t) ? static_cast<float>(t) : 0.0F);
    }
  }
  return view;
}

// The points of the view in the world.
inline std::vector<Vector3> points_of(const DepthView& view) {
  std::vector<Vector3> points;
  const DepthCamera& camera = view.camera;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const double z = view.depth[static_cast<std::size_t>(v * camera.width + u)];
      if (z == 0.0) continue;
      points.push_back(camera.X_WC * Vector3((u - camera.cx) / camera.fx * z,
                                             (v - camera.cy) / camera.fy * z, z));
    }
  }
  return points;
}

// An image of counts of one value a pixel: a 16-bit grey PNG, or another kind.
inline void write_png(const std::filesystem::path& file, int width, int height,
                      const std::vector<std::uint16_t>& counts, int bits = 16,
                      int color = PNG_COLOR_TYPE_GRAY) {
  std::FILE* stream = std::fopen(file.c_str(), "wb");
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, stream);
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), bits,
               color, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  std::vector<png_byte> row;
  const int channels = color == PNG_COLOR_TYPE_RGB ? 3 : 1;
  for (int v = 0; v < height; ++v) {
    row.clear();
    for (int u = 0; u < width; ++u) {
      const std::uint16_t count = counts[static_cast<std::size_t>(v * width + u)];
      for (int c = 0; c < channels; ++c) {
        if (bits == 16) row.push_back(static_cast<png_byte>(count >> 8U));
        row.push_back(static_cast<png_byte>(count & 255U));
      }
    }
    png_write_row(png, row.data());
  }
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  std::fclose(stream);
}

// In counts of a tenth of a millimetre.
inline void write_png(const std::filesystem::path& file, const DepthView& view) {
  std::vector<std::uint16_t> counts;
  for (const float z : view.depth) {
    counts.push_back(static_cast<std::uint16_t>(std::lround(1e4 * static_cast<double>(z))));
  }
  write_png(file, view.camera.width, view.camera.height, counts);
}

// The camera as JSON, for images in counts of a tenth of a millimetre.
inline std::string camera_json(const DepthCamera& camera) {
  const Vector3 p = camera.X_WC.translation();
  const Eigen::Quaterniond q = quaternion_of(camera.X_WC);
  std::string text(1000, '\0');
  const int size = std::snprintf(
      text.data(), text.size(),
      R"({"fx": %.17g, "fy": %.17g, "cx": %.17g, "cy": %.17g, "width": %d, "height": %d, "unit": 0.0001,
 "pose": {"position": [%.17g, %.17g, %.17g], "quaternion_wxyz": [%.17g, %.17g, %.17g, %.17g]}})",
      camera.fx, camera.fy, camera.cx, camera.cy, camera.width, camera.height, p.x(), p.y(), p.z(),
      q.w(), q.x(), q.y(), q.z());
  text.resize(static_cast<std::size_t>(size));
  return text;
}

}  // namespace prehend::test
