#include "sim/scene/compiled_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/geometry/mesh_checks.h"

namespace prehend {
namespace {

std::vector<double> gaps_at(const CompiledScene& scene, const Preshape& preshape) {
  const Robot& hand = scene.scene.hand;
  std::vector<Pose> X_HL;
  link_poses(hand, joint_values(hand, preshape.dofs), X_HL);
  std::vector<double> gaps;
  for (const LinkPair& pair : scene.self_pairs) {
    const CompiledLink& a = scene.links[index(pair.a)];
    const CompiledLink& b = scene.links[index(pair.b)];
    const Pose X_AB = X_HL[index(pair.a)].inverse() * X_HL[index(pair.b)];
    gaps.push_back(find_gap(a.mesh, b.mesh, X_AB).lower);
    if (gaps.back() <= 0.0) {
      throw InputError(hand.name + ": preshape " + preshape.name + ": links " + a.name + " and " +
                       b.name + " collide");
    }
  }
  return gaps;
}

void check_object_is_free(const CompiledScene& scene) {
  const auto any_inside = [](const ProximityMesh& mesh, const std::vector<Vector3>& points,
                             const Pose& X) {
    return std::any_of(points.begin(), points.end(),
                       [&](const Vector3& p) { return is_inside(mesh, X * p); });
  };
  for (const CompiledObstacle& obstacle : scene.obstacles) {
    const Pose X_BO = obstacle.X_OB.inverse();
    if (surfaces_cross(scene.object, obstacle.mesh, obstacle.X_OB) ||
        (obstacle.is_solid && any_inside(obstacle.mesh, scene.object_probes, X_BO)) ||
        (scene.object_is_solid && any_inside(scene.object, obstacle.probes, obstacle.X_OB))) {
      throw InputError(scene.scene.name + ": object: " + scene.scene.object.name +
                       " overlaps the obstacle " + obstacle.name);
    }
  }
}

std::vector<FixedBody> fixed_bodies(const CompiledScene& scene) {
  const Pose X_BO = scene.scene.carrier->X_WB.inverse() * scene.scene.object.X_WO;
  std::vector<FixedBody> fixed = {
      {scene.scene.object.name, scene.object, X_BO, scene.object_probes, scene.object_is_solid}};
  for (const CompiledObstacle& obstacle : scene.obstacles) {
    fixed.push_back(
        {obstacle.name, obstacle.mesh, X_BO * obstacle.X_OB, obstacle.probes, obstacle.is_solid});
  }
  return fixed;
}

}  // namespace

CompiledScene compile(Scene scene) {
  if (!scene.hand.hand) throw InputError(scene.hand.name + ": hand: the robot is not a hand");
  const double radius = max_distance(scene.object.mesh, scene.object.center_of_mass);
  if (!(radius > 0.0) || !std::isfinite(radius)) {
    throw InputError(scene.object.name + ": the object has no extent");
  }
  CompiledScene compiled{.scene = scene, .object = ProximityMesh(scene.object.mesh)};
  compiled.links = compile_links(scene, scene.hand);
  const Pose X_OW = scene.object.X_WO.inverse();
  for (const StaticBody& body : scene.obstacles) {
    compiled.obstacles.push_back({body.name, ProximityMesh(body.mesh), X_OW * body.X_WB,
                                  component_vertices(body.mesh), check_mesh(body.mesh).solid()});
  }
  compiled.self_pairs = separate_pairs(compiled.links);
  for (const Preshape& preshape : scene.hand.hand->preshapes) {
    compiled.preshape_gaps.push_back(gaps_at(compiled, preshape));
  }
  compiled.wrench_frame = {scene.object.center_of_mass, 1.0 / radius};
  compiled.object_probes = component_vertices(scene.object.mesh);
  compiled.object_is_solid = check_mesh(scene.object.mesh).solid();
  check_object_is_free(compiled);
  if (scene.carrier) compiled.arm = compile_arm(scene, fixed_bodies(compiled));
  return compiled;
}

}  // namespace prehend
