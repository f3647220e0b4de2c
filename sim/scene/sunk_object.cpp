#include "sim/scene/sunk_object.h"

#include <algorithm>

#include "sim/base/formatted.h"
#include "sim/base/joined.h"
#include "sim/shape/mesh_checks.h"

namespace prehend {
namespace {

constexpr double kMostSunk = 3e-3;     // what is taken for a slip of the model [m]
constexpr double kDeepestBase = 0.05;  // of a robot [m]
constexpr double kClearance = 1e-4;    // left above what it stands on [m]
constexpr double kFirstRise = 5e-5;    // [m]
constexpr double kResolution = 1e-5;   // [m]

Bounds bounds_in_world(const TriangleMesh& mesh, const Pose& X_WM) {
  Bounds box;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Vector3 p_W = X_WM * mesh.vertices[v];
    box.lower = v == 0 ? p_W : Vector3(box.lower.cwiseMin(p_W));
    box.upper = v == 0 ? p_W : Vector3(box.upper.cwiseMax(p_W));
  }
  return box;
}

bool meet(const Bounds& a, const Bounds& b) {
  return (a.lower.array() <= b.upper.array()).all() && (b.lower.array() <= a.upper.array()).all();
}

CollisionBody body_of(const std::string& name, const TriangleMesh& mesh) {
  return make_collision_body(name, mesh, check_mesh(mesh).solid());
}

// In the frame of the object. The search trees take time: most scenes need none.
std::vector<PlacedBody> obstacles_near(const Scene& scene) {
  Bounds reached = bounds_in_world(scene.object.mesh, scene.object.X_WO);
  reached.upper.z() += kMostSunk + kClearance;
  std::vector<PlacedBody> near;
  for (const StaticBody& body : scene.obstacles) {
    if (!meet(reached, bounds_in_world(body.mesh, body.X_WB))) continue;
    near.push_back({body_of(body.name, body.mesh), scene.object.X_WO.inverse() * body.X_WB});
  }
  return near;
}

bool is_free(const CollisionBody& object, const std::vector<PlacedBody>& obstacles,
             const Vector3& rise_O) {
  return std::none_of(obstacles.begin(), obstacles.end(), [&](const PlacedBody& body) {
    return bodies_overlap(object, body, translation(-rise_O) * body.X_RB);
  });
}

}  // namespace

std::optional<double> rise_to_be_free(const CollisionBody& object,
                                      const std::vector<PlacedBody>& obstacles, const Vector3& up_O,
                                      double most) {
  const auto free_at = [&](double rise) { return is_free(object, obstacles, rise * up_O); };
  double blocked = 0.0;
  double free = kFirstRise;
  while (!free_at(free)) {
    if (free >= most) return std::nullopt;
    blocked = free;
    free = std::min(2.0 * free, most);
  }
  if (blocked == 0.0) return free;
  while (free - blocked > kResolution) {
    const double middle = 0.5 * (blocked + free);
    (free_at(middle) ? free : blocked) = middle;
  }
  return free;
}

bool stands_in(const CollisionBody& link, const PlacedBody& obstacle, const Vector3& up_L) {
  return bodies_overlap(link, obstacle, obstacle.X_RB) &&
         rise_to_be_free(link, {obstacle}, up_L, kDeepestBase);
}

void note_standing_base(Scene& scene) {
  if (!scene.carrier) return;
  const MountedRobot& base = scene.carrier->platform.robots.front();
  const Pose X_WL = scene.carrier->X_WB * base.X_MR;
  const Vector3 up_L = X_WL.linear().transpose() * Vector3::UnitZ();
  for (const Link& link : base.robot.links) {
    if (link.joint >= 0) continue;
    const Bounds box = bounds_in_world(link.mesh, X_WL);
    for (const StaticBody& body : scene.obstacles) {
      if (!meet(box, bounds_in_world(body.mesh, body.X_WB))) continue;
      const PlacedBody placed{body_of(body.name, body.mesh), X_WL.inverse() * body.X_WB};
      if (!stands_in(body_of(link.name, link.mesh), placed, up_L)) continue;
      scene.notes.push_back(link.name + " stands in " + body.name +
                            ": they are not checked against each other");
    }
  }
}

void raise_sunk_object(Scene& scene) {
  const std::vector<PlacedBody> near = obstacles_near(scene);
  if (near.empty()) return;
  const CollisionBody object = body_of(scene.object.name, scene.object.mesh);
  std::string met;
  for (const PlacedBody& body : near) {
    if (bodies_overlap(object, body, body.X_RB)) add_part(met, body.name);
  }
  if (met.empty()) return;
  const Vector3 up_O = scene.object.X_WO.linear().transpose() * Vector3::UnitZ();
  const std::optional<double> rise = rise_to_be_free(object, near, up_O, kMostSunk);
  if (!rise) return;
  scene.object.X_WO = translation({0.0, 0.0, *rise + kClearance}) * scene.object.X_WO;
  scene.notes.push_back(formatted("%s is sunk into %s by %.2f mm: it is raised by %.2f mm",
                                  scene.object.name.c_str(), met.c_str(), 1000.0 * *rise,
                                  1000.0 * (*rise + kClearance)));
}

}  // namespace prehend
