#include "sim/robot/files/shape_mesh.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "sim/base/input_error.h"
#include "sim/base/range.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/revolve.h"
#include "sim/shape/weld.h"

namespace prehend {
namespace {

constexpr int kSidesOfCylinder = 24;
constexpr int kSubdivisionsOfSphere = 2;
constexpr int kSidesOfCapsule = 16;
constexpr int kStepsOfCap = 4;  // from the equator to the axis

}  // namespace

TriangleMesh cylinder_mesh(double radius, double height) {
  return make_cylinder(radius, height, kSidesOfCylinder);
}

TriangleMesh sphere_mesh(double radius) { return make_sphere(radius, kSubdivisionsOfSphere); }

TriangleMesh capsule_mesh(double radius, double height) {
  require(radius > 0.0 && height > 0.0, {.field = "size", .problem = "must be greater than 0"});
  require(radius + height <= kFarthest, {.field = "size", .problem = "larger than 1e6 m"});
  std::vector<Eigen::Vector2d> profile;
  for (const double side : {-1.0, 1.0}) {
    for (int step = 0; step <= kStepsOfCap; ++step) {
      const int from_axis = side < 0.0 ? step : kStepsOfCap - step;
      const double angle = 0.5 * std::numbers::pi * from_axis / kStepsOfCap;
      const double x = from_axis == 0 ? 0.0 : radius * std::sin(angle);
      profile.emplace_back(x, side * (0.5 * height + radius * std::cos(angle)));
    }
  }
  return revolve(profile, 2.0 * std::numbers::pi * radius / kSidesOfCapsule).mesh;
}

TriangleMesh ellipsoid_mesh(const Vector3& radii) {
  require((radii.array() > 0.0).all(), {.field = "size", .problem = "must be greater than 0"});
  return scaled(sphere_mesh(1.0), radii);
}

TriangleMesh scaled(TriangleMesh mesh, const Vector3& factors) {
  require((factors.array() != 0.0).all(), {.field = "scale", .problem = "must not be 0"});
  for (Vector3& p : mesh.vertices) p = p.cwiseProduct(factors);
  if (factors.prod() < 0.0) {
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  }
  return mesh;
}

TriangleMesh mesh_or_nothing(const std::filesystem::path& file) {
  try {
    return load_mesh(file).mesh;
  } catch (const InputError& error) {
    if (!error.problem().starts_with("no triangles")) throw;
    return {};
  }
}

}  // namespace prehend
