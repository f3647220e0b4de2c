#include "planner/live/protocol/session_json.h"

#include <algorithm>

#include "sim/base/index.h"
#include "sim/base/json/json_pose.h"

namespace prehend {
namespace {

ProtocolJson object_of(const EditedScene& world) {
  const Scene& scene = world.scene();
  if (scene.object.mesh.empty()) return nullptr;
  return {{"name", scene.object.name},
          {"material", name_of(scene.object.material)},
          {"mass", scene.object.mass},
          {"X_world_object", pose_to_json(scene.object.X_WO)},
          {"triangles", scene.object.mesh.triangles.size()},
          {"surface", world.surfaces().object}};
}

ProtocolJson obstacles_of(const EditedScene& world) {
  ProtocolJson list = ProtocolJson::array();
  for (std::size_t b = 0; b < world.scene().obstacles.size(); ++b) {
    const StaticBody& body = world.scene().obstacles[b];
    list.push_back({{"name", body.name},
                    {"material", name_of(body.material)},
                    {"X_world_body", pose_to_json(body.X_WB)},
                    {"surface", world.surfaces().obstacles[b]}});
  }
  return list;
}

ProtocolJson pins_of(const SessionState& state) {
  ProtocolJson list = ProtocolJson::array();
  for (const PinnedGrasp& pinned : state.pins) {
    list.push_back({{"name", pinned.name},
                    {"hand", pinned.hand},
                    {"epsilon", pinned.epsilon},
                    {"X_object_hand", pose_to_json(pinned.posture.X_OH)},
                    {"dofs", pinned.posture.dofs},
                    {"joints", pinned.posture.joints}});
  }
  return list;
}

// Of the object with each material that the hand has, in the order of the materials.
ProtocolJson friction_of(const Scene& scene) {
  ProtocolJson list = ProtocolJson::array();
  if (scene.object.mesh.empty()) return list;
  for (const Material material : kAll<Material>) {
    const bool is_there = std::ranges::any_of(
        scene.hand.links, [&](const Link& link) { return link.material == name_of(material); });
    if (!is_there) continue;
    list.push_back({{"material", name_of(material)},
                    {"static", scene.friction.between(material, scene.object.material)}});
  }
  return list;
}

ProtocolJson judge_of(const JudgeOptions& judge) {
  ProtocolJson json{{"norm", name_of(judge.norm)}, {"edges", judge.edges}, {"fixed", nullptr}};
  if (!judge.fixed) return json;
  json["fixed"] = ProtocolJson::object();
  for (int k = 0; k < 3; ++k) {
    const int coordinate = judge.fixed->coordinates[index(k)];
    json["fixed"][std::string(kWrenchCoordinates[index(coordinate)])] = judge.fixed->values[k];
  }
  return json;
}

// That time runs, and how; where things are is told by time.state.
ProtocolJson time_of(const Session& session) {
  if (!session.is_moving()) return nullptr;
  const TimeOptions& options = session.time().options();
  return {{"gravity", options.gravity}, {"step", options.step}};
}

}  // namespace

ProtocolJson text_or_null(const std::string& text) {
  return text.empty() ? ProtocolJson() : ProtocolJson(text);
}

ProtocolJson hand_json(const Session& session) {
  const Robot& hand = session.state().world->scene().hand;
  const HandPosture& posture = session.state().hand;
  ProtocolJson dofs = ProtocolJson::array();
  for (std::size_t d = 0; d < hand.dofs.size(); ++d) {
    dofs.push_back({{"name", hand.dofs[d].name},
                    {"value", posture.dofs[d]},
                    {"lower", hand.dofs[d].lower},
                    {"upper", hand.dofs[d].upper}});
  }
  ProtocolJson preshapes = ProtocolJson::array();
  for (const Preshape& preshape : hand.hand->preshapes) preshapes.push_back(preshape.name);
  return {{"name", hand.name},
          {"X_world_hand", pose_to_json(session.X_WH())},
          {"X_object_hand", pose_to_json(posture.X_OH)},
          {"dofs", dofs},
          {"joints", posture.joints},
          {"preshapes", preshapes}};
}

ProtocolJson arm_json(const Session& session) {
  const CompiledArm* arm = session.arm();
  const std::optional<ArmPosture>& posture = session.state().arm;
  if (arm == nullptr || !posture) return nullptr;
  ProtocolJson joints = ProtocolJson::array();
  for (const int d : arm->dofs) {
    const DegreeOfFreedom& dof = arm->robot().dofs[index(d)];
    joints.push_back({{"name", dof.name},
                      {"value", posture->dofs[index(d)]},
                      {"lower", dof.lower},
                      {"upper", dof.upper}});
  }
  return {{"joints", joints},
          {"reached", posture->reached()},
          {"problem", text_or_null(posture->problem)}};
}

ProtocolJson state_json(const Session& session) {
  const SessionState& state = session.state();
  const Scene& scene = state.world->scene();
  ProtocolJson json;
  json["revision"] = session.revision();
  json["scene"] = scene.name;
  json["problem"] = text_or_null(state.world->problem());
  json["object"] = object_of(*state.world);
  json["obstacles"] = obstacles_of(*state.world);
  json["platform"] = scene.carrier ? ProtocolJson(scene.carrier->platform.name) : ProtocolJson();
  json["robots"] = state.world->surfaces().robots;
  json["hand"] = hand_json(session);
  json["arm"] = arm_json(session);
  json["outcome"] = state.outcome ? ProtocolJson(name_of(*state.outcome)) : ProtocolJson();
  json["switches"] = {{"stop_at_contact", state.switches.stop_at_contact},
                      {"soft_fingers", state.switches.soft_fingers}};
  json["friction"] = friction_of(scene);
  json["judge"] = judge_of(state.judge);
  json["time"] = time_of(session);
  json["planning"] = session.is_planning();
  json["finding_path"] = session.is_finding_path();
  json["results"] = state.results ? state.results->grasps.size() : std::size_t{0};
  json["pins"] = pins_of(state);
  json["undo"] = session.undo_count();
  json["redo"] = session.redo_count();
  return json;
}

ProtocolJson motion_json(const Session& session, const HandMotion& motion) {
  return {{"end", name_of(motion.end)},
          {"share", motion.share},
          {"link", text_or_null(motion.link)},
          {"by", text_or_null(motion.by)},
          {"hand", hand_json(session)}};
}

ProtocolJson contacts_json(const Session& session, const std::vector<GraspContact>& contacts) {
  const EditedScene& world = *session.state().world;
  ProtocolJson list = ProtocolJson::array();
  for (const GraspContact& contact : contacts) {
    list.push_back({{"link", world.scene().hand.links[index(contact.link)].name},
                    {"position_object", vector_to_json(contact.point.position)},
                    {"normal_object", vector_to_json(contact.point.normal)},
                    {"position_world", vector_to_json(world.X_WO() * contact.point.position)},
                    {"normal_world", vector_to_json(world.X_WO().linear() * contact.point.normal)},
                    {"model", name_of(contact.point.model)},
                    {"friction", contact.point.friction},
                    {"torsion", contact.point.torsion},
                    {"gap", contact.gap}});
  }
  return list;
}

ProtocolJson scaled_wrench_json(const Wrench& wrench) {
  return {{"force_object", vector_to_json(wrench.head<3>())},
          {"scaled_torque_object", vector_to_json(wrench.tail<3>())}};
}

ProtocolJson found_json(const Trial& trial) {
  return {{"outcome", name_of(trial.outcome)},
          {"epsilon", trial.outcome == Outcome::stable ? trial.epsilon.lower : 0.0},
          {"X_object_hand", pose_to_json(hand_in_scene(trial))},
          {"dofs", trial.dofs},
          {"joints", trial.joints}};
}

}  // namespace prehend
