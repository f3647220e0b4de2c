#include "planner/plan/together/posed_links.h"

#include "sim/base/index.h"
#include "sim/scene/compiled_scene.h"
#include "sim/shape/proximity.h"
#include "sim/trial/trial.h"

namespace prehend {

std::vector<PosedLink> links_in_grasp(const CompiledScene& scene, const Trial& trial) {
  if (scene.arm && !trial.arm_dofs.empty()) {
    return links_at(scene, arm_joints(*scene.arm, trial.arm_dofs, trial.joints));
  }
  const Pose X_WH = scene.scene.object.X_WO * hand_in_scene(trial);
  std::vector<Pose> X_HL;
  link_poses(scene.scene.hand, trial.joints, X_HL);
  std::vector<PosedLink> links;
  for (std::size_t l = 0; l < scene.links.size(); ++l) {
    links.push_back({&scene.links[l], X_WH * X_HL[l]});
  }
  return links;
}

std::vector<PosedLink> links_at_start(const CompiledScene& scene) {
  if (!scene.arm) return {};
  return links_at(scene, joint_values(scene.arm->robot(), scene.arm->start));
}

std::vector<PosedLink> links_at(const CompiledScene& scene, const std::vector<double>& arm_joints) {
  std::vector<Pose> X_BL;
  arm_link_poses(*scene.arm, arm_joints, X_BL);
  std::vector<PosedLink> links;
  for (std::size_t l = 0; l < scene.arm->links.size(); ++l) {
    links.push_back({&scene.arm->links[l], scene.arm->X_WB * X_BL[l]});
  }
  return links;
}

bool are_apart(const std::vector<PosedLink>& a, const std::vector<PosedLink>& b, double distance) {
  for (const PosedLink& one : a) {
    const Vector3 center_W = one.X_WL * one.link->mesh.ball_center();
    for (const PosedLink& other : b) {
      const double reach = one.link->mesh.ball_radius() + other.link->mesh.ball_radius() + distance;
      if ((other.X_WL * other.link->mesh.ball_center() - center_W).norm() > reach) continue;
      const Pose X_AB = one.X_WL.inverse() * other.X_WL;
      if (bodies_overlap(*one.link, *other.link, X_AB)) return false;
      const Gap gap =
          find_gap(one.link->mesh, other.link->mesh, X_AB, {.cap = distance, .hint = {}});
      if (gap.lower < distance) return false;
    }
  }
  return true;
}

void add_obstacles(const std::vector<PosedLink>& links, const std::string& robot, Scene& scene) {
  for (const PosedLink& posed : links) {
    StaticBody body;
    body.name = robot + "/" + posed.link->name;
    body.mesh = posed.link->mesh.mesh();
    body.X_WB = posed.X_WL;
    body.material = Material::metal;
    scene.obstacles.push_back(std::move(body));
  }
}

}  // namespace prehend
