#include "benchmarks/views/place_on_table.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/shape/convex_hull.h"
#include "sim/shape/mass_properties.h"

namespace prehend::bench {
namespace {

// Whether the centre of mass is above the inside of what touches a table below, whose normal is
// `up`, by so much of the body's extent that a push does not tip it.
bool stands(const TriangleMesh& hull, const Vector3& center, const Vector3& up) {
  double lowest = 1e9;
  for (const Vector3& p : hull.vertices) lowest = std::min(lowest, up.dot(p));
  const double extent = bounds(hull).diagonal();
  std::vector<Vector3> feet;
  for (const Vector3& p : hull.vertices) {
    if (up.dot(p) - lowest < 0.01 * extent) feet.push_back(p - center);
  }
  // The centre is inside when in each direction some foot is farther out.
  const Vector3 x = any_orthogonal(up);
  const Vector3 y = up.cross(x);
  for (int k = 0; k < 72; ++k) {
    const Vector3 out = std::cos(k * 0.0872664626) * x + std::sin(k * 0.0872664626) * y;
    const bool held = std::any_of(feet.begin(), feet.end(), [&](const Vector3& foot) {
      return foot.dot(out) > 0.03 * extent;
    });
    if (!held) return false;
  }
  return true;
}

Pose standing(const TriangleMesh& mesh, const Matrix3& turn) {
  Pose X_WO = pose_from(turn, Vector3::Zero());
  const Bounds box = bounds(transformed(mesh, X_WO));
  X_WO.translation() = -Vector3(box.center().x(), box.center().y(), box.lower.z());
  return X_WO;
}

}  // namespace

Pose pose_on_table(const TriangleMesh& mesh) {
  const TriangleMesh hull = convex_hull(mesh.vertices);
  const Vector3 center = mass_properties(hull).center_of_mass;
  if (stands(hull, center, Vector3::UnitZ())) return standing(mesh, Matrix3::Identity());
  Vector3 best = Vector3::UnitZ();
  double best_height = 1e9;
  for (std::size_t t = 0; t < hull.triangles.size(); ++t) {
    const Vector3 normal = doubled_area_vector(hull, t).normalized();
    if (!stands(hull, center, -normal)) continue;
    const double height = normal.dot(corners_of(hull, static_cast<int>(t))[0] - center);
    if (height < best_height - 1e-9) {
      best_height = height;
      best = -normal;
    }
  }
  return standing(mesh,
                  Eigen::Quaterniond::FromTwoVectors(best, Vector3::UnitZ()).toRotationMatrix());
}

}  // namespace prehend::bench
