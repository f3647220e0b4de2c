#include "sim/scene/stand_on.h"

#include <algorithm>
#include <limits>

#include "sim/scene/collision_body.h"
#include "sim/shape/mesh_checks.h"
#include "sim/shape/proximity.h"

namespace prehend {
namespace {

constexpr double kGap = 1e-4;  // that a body keeps from what it stands on [m]
// Steps are short only beside a wall that is hardly farther away than kGap. A body that slides down
// one for so many of them counts as falling past.
constexpr int kMostSteps = 10000;

CollisionBody solid_body(const TriangleMesh& mesh) {
  return make_collision_body("", mesh, check_mesh(mesh).solid());
}

double lowest(const TriangleMesh& mesh, const Pose& X_WM) {
  double z = std::numeric_limits<double>::infinity();
  for (const Vector3& p : mesh.vertices) z = std::min(z, (X_WM * p).z());
  return z;
}

double highest(const TriangleMesh& mesh, const Pose& X_WM) {
  double z = -std::numeric_limits<double>::infinity();
  for (const Vector3& p : mesh.vertices) z = std::max(z, (X_WM * p).z());
  return z;
}

// Conservative advancement: no step is longer than the gap. Nothing where it falls past the
// support.
std::optional<Pose> lowered(const CollisionBody& body, Pose X_WB, const CollisionBody& support,
                            const Pose& X_WS) {
  const double bottom = lowest(support.mesh.mesh(), X_WS);
  for (int step = 0; step < kMostSteps && highest(body.mesh.mesh(), X_WB) > bottom; ++step) {
    const Gap gap = find_gap(support.mesh, body.mesh, X_WS.inverse() * X_WB,
                             {.relative_error = 1e-2, .hint = {}});
    if (gap.upper <= 1.1 * kGap) return X_WB;
    X_WB = translation(Vector3(0.0, 0.0, -std::max(gap.lower - kGap, 1e-3 * kGap))) * X_WB;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Pose> lowered_onto(const TriangleMesh& body, const Pose& X_WB,
                                 const TriangleMesh& support, const Pose& X_WS) {
  const CollisionBody falling = solid_body(body);
  const CollisionBody standing = solid_body(support);
  if (!bodies_overlap(standing, falling, X_WS.inverse() * X_WB)) {
    if (const auto pose = lowered(falling, X_WB, standing, X_WS)) return pose;
  }
  const double rise = highest(support, X_WS) - lowest(body, X_WB) + 2.0 * kGap;
  return lowered(falling, translation(Vector3(0.0, 0.0, rise)) * X_WB, standing, X_WS);
}

}  // namespace prehend
