#include "sim/robot/files/mjcf_fitting.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "sim/base/input_error.h"
#include "sim/robot/inertial.h"

namespace prehend {
namespace {

// Where the mesh has its moments: x about the largest, z about the least.
struct PrincipalFrame {
  Pose X_MP = Pose::Identity();
  Vector3 half_sizes = Vector3::Zero();  // of the box with the same moments; 0: the mesh is flat
};

PrincipalFrame principal_frame(const TriangleMesh& mesh) {
  Inertial inertial = inertial_of_density(mesh, 1.0);
  const bool is_flat = !(inertial.mass > 0.0);
  if (is_flat) inertial = inertial_of_mass(mesh, 1.0);
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(inertial.inertia);
  Matrix3 R = solver.eigenvectors().rowwise().reverse();
  if (R.determinant() < 0.0) R.col(0) = -R.col(0);
  const Vector3 moments = solver.eigenvalues().reverse();
  PrincipalFrame frame{pose_from(R, inertial.center_of_mass)};
  if (is_flat) return frame;
  for (int i = 0; i < 3; ++i) {
    const double others = moments.sum() - 2.0 * moments[i];
    frame.half_sizes[i] = 0.5 * std::sqrt(std::max(0.0, 6.0 * others / inertial.mass));
  }
  return frame;
}

// The sizes that hold all points, given in the geom's frame.
std::vector<double> holding(const std::vector<Vector3>& points, const std::string& type,
                            const Vector3& half) {
  if (type == "box" || type == "ellipsoid") return {half.x(), half.y(), half.z()};
  double radius = 0.0;
  double height = 0.0;
  for (const Vector3& p : points) {
    radius = std::max(radius, type == "sphere" ? p.norm() : p.head<2>().norm());
    height = std::max(height, std::abs(p.z()));
  }
  if (type == "sphere") return {radius};
  if (type == "cylinder") return {radius, height};
  // The ends of a capsule are balls: they hold what is near its axis farther out.
  double middle = 0.0;
  for (const Vector3& p : points) {
    const double cap = std::sqrt(std::max(0.0, radius * radius - p.head<2>().squaredNorm()));
    middle = std::max(middle, std::abs(p.z()) - cap);
  }
  return {radius, middle};
}

std::vector<double> like_box(const std::string& type, const Vector3& half) {
  const double across = 0.5 * (half.x() + half.y());
  if (type == "sphere") return {half.mean()};
  if (type == "capsule") return {across, std::max(0.0, half.z() - 0.5 * across)};
  if (type == "cylinder") return {across, half.z()};
  return {half.x(), half.y(), half.z()};
}

}  // namespace

FittedGeom fitted_geom(const TriangleMesh& mesh, const std::string& type, bool to_bounds) {
  const std::vector<std::string> known = {"sphere", "capsule", "cylinder", "ellipsoid", "box"};
  if (std::find(known.begin(), known.end(), type) == known.end()) {
    throw InputError({.problem = "fitted to meshes are spheres, capsules, cylinders, ellipsoids "
                                 "and boxes only",
                      .value = type});
  }
  const PrincipalFrame frame = principal_frame(mesh);
  FittedGeom fitted{.size = {}, .X_MG = frame.X_MP};
  if (!to_bounds && frame.half_sizes.norm() > 0.0) {
    fitted.size = like_box(type, frame.half_sizes);
    return fitted;
  }
  std::vector<Vector3> points;
  const Pose X_PM = frame.X_MP.inverse();
  for (const Vector3& p : mesh.vertices) points.emplace_back(X_PM * p);
  Vector3 low = points.front();
  Vector3 high = points.front();
  for (const Vector3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vector3 center = 0.5 * (low + high);
  for (Vector3& p : points) p -= center;
  fitted.X_MG = frame.X_MP * translation(center);
  fitted.size = holding(points, type, 0.5 * (high - low));
  return fitted;
}

}  // namespace prehend
