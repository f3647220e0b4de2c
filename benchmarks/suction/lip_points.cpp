#include "benchmarks/suction/lip_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/base/gravity.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/shape/proximity.h"

namespace prehend::bench {
namespace {

// By which points begin inside the object [m].
constexpr double kStartOverlap = 2e-5;

}  // namespace

std::vector<LipPoint> lip_points(const std::vector<HangingCup>& cups,
                                 const std::vector<TriangleMesh>& pieces) {
  constexpr double kLeastCosine = 0.3;  // of a surface that is nearly along the axis
  std::vector<ProximityMesh> meshes;
  for (const TriangleMesh& piece : pieces) meshes.emplace_back(piece);
  std::vector<LipPoint> points;
  for (std::size_t c = 0; c < cups.size(); ++c) {
    const HangingCup& cup = cups[c];
    const Vector3 x = any_orthogonal(cup.axis_O);
    const Vector3 y = cup.axis_O.cross(x);
    const double reach = 4.0 * cup.travel;
    for (int k = 0; k < kLipPoints; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / kLipPoints;
      const Vector3 from = cup.center_O + cup.radius * (std::cos(angle) * x + std::sin(angle) * y) -
                           2.0 * cup.travel * cup.axis_O;
      double nearest = std::numeric_limits<double>::infinity();
      double cosine = 1.0;
      for (const ProximityMesh& mesh : meshes) {
        const RayHit hit = first_hit(mesh, from, cup.axis_O, reach);
        if (hit.triangle < 0 || hit.distance >= nearest) continue;
        nearest = hit.distance;
        const Vector3 normal =
            doubled_area_vector(mesh.mesh(), index(hit.triangle)).stableNormalized();
        cosine = -normal.dot(cup.axis_O);
      }
      if (std::isinf(nearest)) {
        throw InputError({.problem = "a lip is beside the convex pieces of the object"});
      }
      const double way = nearest - (kPointRadius - kStartOverlap) / std::max(kLeastCosine, cosine);
      points.push_back({static_cast<int>(c), from + way * cup.axis_O, cosine});
    }
  }
  return points;
}

double linear_margin(const HangingObject& object, const std::vector<LipPoint>& points) {
  const Vector3 axis = object.cups.front().axis_O;
  const Vector3 x = any_orthogonal(axis);
  const Vector3 y = axis.cross(x);
  Vector3 middle = Vector3::Zero();
  for (const LipPoint& point : points) {
    middle += point.center_O / static_cast<double>(points.size());
  }
  // How far a point goes along the axis, for a motion along it and turns about x and y.
  const auto way = [&](const LipPoint& point) {
    const Vector3 from = point.center_O - middle;
    return Vector3(1.0, from.dot(y), -from.dot(x));
  };
  Matrix3 stiffness = Matrix3::Zero();
  for (const LipPoint& point : points) {
    stiffness +=
        object.cups[index(point.cup)].stiffness / kLipPoints * way(point) * way(point).transpose();
  }
  const Vector3 weight = object.inertial.mass * kStandardGravity * object.down_O;
  const Vector3 torque = (object.inertial.center_of_mass - middle).cross(weight);
  const Vector3 motion =
      stiffness.ldlt().solve(Vector3(axis.dot(weight), x.dot(torque), y.dot(torque)));
  double most = 0.0;  // of the pulls
  for (const LipPoint& point : points) {
    const HangingCup& cup = object.cups[index(point.cup)];
    most = std::max(most, cup.stiffness * way(point).dot(motion) / cup.pull);
  }
  return most > 0.0 ? 1.0 / most : std::numeric_limits<double>::infinity();
}

}  // namespace prehend::bench
