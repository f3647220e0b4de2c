#include <array>
#include <string>

#include "sim/base/input_error.h"
#include "sim/shape/cloud/files/point_cloud.h"
#include "sim/shape/files/ply_elements.h"

namespace prehend {
namespace {

// PlyProperty::role: the place of a coordinate among these.
constexpr std::array<std::string_view, 6> kPlyCoordinates = {"x", "y", "z", "nx", "ny", "nz"};

// Whether there are normals.
bool set_cloud_roles(PlyElement& vertex) {
  std::array<int, 6> found{};
  for (PlyProperty& property : vertex.properties) {
    for (std::size_t c = 0; c < kPlyCoordinates.size(); ++c) {
      if (property.count || property.name != kPlyCoordinates[c]) continue;
      property.role = static_cast<int>(c);
      ++found[c];
    }
  }
  for (std::size_t c = 0; c < found.size(); ++c) {
    if (found[c] > 1 || (c < 3 && found[c] == 0)) {
      throw InputError("element vertex must have one x, one y and one z, and a normal at most");
    }
  }
  return found[3] + found[4] + found[5] == 3;
}

void read_entry(PlyBody& body, const PlyElement& element, std::array<float, 6>& values) {
  for (const PlyProperty& property : element.properties) {
    if (property.count) {
      const int length = body.next_length(property, element);
      for (int i = 0; i < length; ++i) body.next(property.value, element);
      continue;
    }
    const double value = body.next(property.value, element);
    if (property.role >= 0) values[static_cast<std::size_t>(property.role)] = in_single(value);
  }
}

}  // namespace

PointCloud read_ply_cloud(std::string_view bytes) {
  PlyHeader header = read_ply_header(bytes);
  if (header.element("vertex") == nullptr)
    throw InputError("no points: there is no element vertex");
  PointCloud cloud;
  PlyBody body(bytes, header);
  for (PlyElement& element : header.elements) {
    const bool is_vertex = element.name == "vertex";
    const bool has_normals = is_vertex && set_cloud_roles(element);
    if (is_vertex) require_few(static_cast<std::size_t>(element.count), "points");
    std::array<float, 6> values{};
    for (long long i = 0; i < element.count; ++i) {
      read_entry(body, element, values);
      if (is_vertex) cloud.points.emplace_back(values[0], values[1], values[2]);
      if (has_normals) cloud.normals.emplace_back(values[3], values[4], values[5]);
    }
    if (is_vertex) break;  // what follows is no part of it
  }
  cloud.width = cloud.points.size();
  return cloud;
}

}  // namespace prehend
