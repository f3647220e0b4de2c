#include "sim/robot/files/robot_text.h"

#include "sim/base/index.h"
#include "sim/base/json/json_pose.h"
#include "sim/base/json/wrapped_json.h"
#include "sim/robot/files/robot_text_parts.h"
#include "sim/robot/sound_robot.h"

namespace prehend {
namespace {

using Json = nlohmann::ordered_json;

Json rotation_json(const Matrix3& rotation) {
  Json rows = Json::array();
  for (Eigen::Index row = 0; row < 3; ++row) {
    rows.push_back(vector_to_json(rotation.row(row).transpose()));
  }
  return rows;
}

Json steps_json(const Pose& pose) {
  Json steps = Json::array();
  if (pose.translation() != Vector3::Zero()) {
    steps.push_back({{"translate", vector_to_json(pose.translation())}});
  }
  if (pose.linear() != Matrix3::Identity()) {
    steps.push_back({{"rotation", rotation_json(pose.linear())}});
  }
  return steps;
}

Json mesh_json(const TriangleMesh& mesh) {
  Json shape{{"shape", "triangles"}, {"vertices", Json::array()}, {"triangles", Json::array()}};
  for (const Vector3& v : mesh.vertices) shape["vertices"].push_back(vector_to_json(v));
  for (const Triangle& t : mesh.triangles) shape["triangles"].push_back(t);
  return Json::array({shape});
}

// Without the joint that it follows.
Json link_json(const Link& link) {
  Json json{{"name", link.name}, {"material", link.material}};
  if (!link.driver_name.empty()) json["driver_name"] = link.driver_name;
  const Inertial& inertial = link.inertial;
  if (inertial.mass > 0.0) {
    json["mass"] = inertial.mass;
    json["center_of_mass"] = vector_to_json(inertial.center_of_mass);
    json["inertia"] = rotation_json(inertial.inertia);
  } else {
    json["mass"] = "unknown";
  }
  if (link.pad) {
    json["pad"] = {{"outward", vector_to_json(link.pad->outward_L)},
                   {"thickness", link.pad->thickness},
                   {"youngs_modulus", link.pad->material.youngs_modulus},
                   {"poissons_ratio", link.pad->material.poissons_ratio}};
  }
  json["geometry"] = mesh_json(link.mesh);
  return json;
}

Json joint_json(const Joint& joint) {
  Json json{{"name", joint.name},
            {"type", joint.type == JointType::revolute ? "revolute" : "prismatic"}};
  if (!joint.driver_name.empty()) json["driver_name"] = joint.driver_name;
  if (!is_identity(joint.X_PJ)) json["origin"] = steps_json(joint.X_PJ);
  json["axis"] = vector_to_json(joint.axis);
  if (joint.zero != 0.0) json["zero"] = joint.zero;
  if (!is_identity(joint.X_JA)) json["after"] = steps_json(joint.X_JA);
  json["limits"] = {joint.lower, joint.upper};
  if (joint.max_effort > 0.0) json["effort"] = joint.max_effort;
  if (joint.friction.coulomb > 0.0) json["friction"]["coulomb"] = joint.friction.coulomb;
  if (joint.friction.viscous > 0.0) json["friction"]["viscous"] = joint.friction.viscous;
  if (joint.spring.stiffness > 0.0) json["spring"] = spring_json(joint.spring);
  return json;
}

Json chain_json(const Robot& robot, const Chain& chain) {
  const int last = chain.first_joint + chain.joint_count - 1;
  Json json{{"name", chain.name}};
  const int parent = robot.joints[index(chain.first_joint)].parent;
  if (parent >= 0) json["parent"] = robot.joints[index(parent)].name;
  json["joints"] = Json::array();
  json["links"] = Json::array();
  for (int j = chain.first_joint; j <= last; ++j) {
    json["joints"].push_back(joint_json(robot.joints[index(j)]));
  }
  for (const Link& link : robot.links) {
    if (link.joint < chain.first_joint || link.joint > last) continue;
    Json of_link = link_json(link);
    of_link["joint"] = robot.joints[index(link.joint)].name;
    json["links"].push_back(of_link);
  }
  if (chain.closed_form == ClosedForm::spherical_wrist) {
    json["inverse_kinematics"] = "spherical_wrist";
  }
  if (chain.closed_form == ClosedForm::ur) json["inverse_kinematics"] = "ur";
  return json;
}

Json dof_json(const Robot& robot, std::size_t dof) {
  const DegreeOfFreedom& motion = robot.dofs[dof];
  Json json{{"name", motion.name}, {"drives", Json::array()}};
  for (const Joint& joint : robot.joints) {
    if (joint.dof != static_cast<int>(dof)) continue;
    Json drive{{"joint", joint.name}};
    if (joint.ratio != 1.0) drive["ratio"] = joint.ratio;
    if (joint.offset != 0.0) drive["offset"] = joint.offset;
    if (joint.across >= 0) drive["across"] = robot.joints[index(joint.across)].name;
    if (joint.ahead != 1.0) drive["ahead"] = joint.ahead;
    json["drives"].push_back(drive);
  }
  json.update(motion_json(motion));
  return json;
}

Json exempt_json(const Robot& robot) {
  Json pairs = Json::array();
  for (const auto& [a, b] : robot.exempt_pairs) {
    pairs.push_back({robot.links[index(a)].name, robot.links[index(b)].name});
  }
  return pairs;
}

Json frames_json(const Robot& robot) {
  Json frames = Json::array();
  for (const RobotFrame& frame : robot.frames) {
    Json json{{"name", frame.name}};
    if (frame.role != FrameRole::none) json["role"] = name_of(frame.role);
    if (frame.joint >= 0) json["joint"] = robot.joints[index(frame.joint)].name;
    if (!is_identity(frame.X_AF)) json["pose"] = steps_json(frame.X_AF);
    frames.push_back(json);
  }
  return frames;
}

Json strategy_json(const Robot& robot, const ClosingStrategy& strategy) {
  Json json{{"name", strategy.name}};
  for (const int dof : strategy.first) json["first"].push_back(robot.dofs[index(dof)].name);
  if (strategy.waits) json["waits"] = true;
  if (strategy.effort < 1.0) json["effort"] = strategy.effort;
  return json;
}

Json cup_json(const Robot& robot, const SuctionCup& cup) {
  return {{"link", robot.links[index(cup.link)].name},
          {"position", vector_to_json(cup.position)},
          {"axis", vector_to_json(cup.axis)},
          {"radius", cup.radius},
          {"lip_stiffness", cup.lip_stiffness},
          {"travel", cup.travel},
          {"pull", cup.pull},
          {"strain", cup.strain}};
}

}  // namespace

Json motion_json(const DegreeOfFreedom& dof) {
  Json json{{"initial", dof.initial}, {"closing_velocity", dof.closing_velocity}};
  if (dof.max_velocity > 0.0) json["velocity"] = dof.max_velocity;
  if (dof.max_acceleration > 0.0) json["acceleration"] = dof.max_acceleration;
  if (dof.coupling == Coupling::breakaway) json["coupling"] = "breakaway";
  if (dof.coupling == Coupling::by_finger) json["coupling"] = "by_finger";
  if (dof.coupling == Coupling::self_centering) json["coupling"] = "self_centering";
  if (dof.breakaway_effort > 0.0) json["breakaway_effort"] = dof.breakaway_effort;
  if (dof.stiffness) json["stiffness"] = *dof.stiffness;
  if (dof.damping) json["damping"] = *dof.damping;
  return json;
}

Json spring_json(const JointSpring& spring) {
  return {{"stiffness", spring.stiffness}, {"rest", spring.rest}};
}

Json hand_json(const Robot& robot) {
  const Hand& hand = robot.hand.value();
  Json json{{"approach", vector_to_json(hand.approach)}};
  if (!hand.cups.empty()) {
    json["origin"] = vector_to_json(hand.origin);
    for (const SuctionCup& cup : hand.cups) json["cups"].push_back(cup_json(robot, cup));
    return json;
  }
  if (!hand.closing.isZero()) json["closing"] = vector_to_json(hand.closing);
  json["origin"] = vector_to_json(hand.origin);
  for (const Preshape& preshape : hand.preshapes) {
    Json dofs = Json::object();
    for (std::size_t d = 0; d < preshape.dofs.size(); ++d) {
      dofs[robot.dofs[d].name] = preshape.dofs[d];
    }
    json["preshapes"].push_back({{"name", preshape.name},
                                 {"dofs", dofs},
                                 {"width", {preshape.min_width, preshape.max_width}},
                                 {"depth", preshape.depth}});
  }
  for (const ClosingStrategy& strategy : hand.strategies) {
    json["strategies"].push_back(strategy_json(robot, strategy));
  }
  return json;
}

std::string robot_text(const Robot& robot) {
  require_sound(robot);
  Json json{{"name", robot.name}, {"base", link_json(robot.links.at(0))}};
  for (std::size_t l = 1; l < robot.links.size(); ++l) {
    if (robot.links[l].joint < 0) json["links"].push_back(link_json(robot.links[l]));
  }
  json["chains"] = Json::array();
  for (const Chain& chain : robot.chains) json["chains"].push_back(chain_json(robot, chain));
  json["dofs"] = Json::array();
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) json["dofs"].push_back(dof_json(robot, d));
  if (robot.hand) json["hand"] = hand_json(robot);
  if (!robot.frames.empty()) json["frames"] = frames_json(robot);
  if (!robot.exempt_pairs.empty()) json["exempt_collisions"] = exempt_json(robot);
  return wrapped_json(json);
}

std::vector<RobotTextFile> platform_text(const Platform& platform,
                                         const std::filesystem::path& name) {
  if (platform.robots.size() == 1) {
    return {{name.filename(), robot_text(platform.robots.front().robot)}};
  }
  std::vector<RobotTextFile> files;
  Json robots = Json::array();
  for (const MountedRobot& mounted : platform.robots) {
    const std::string file = name.stem().string() + "_" + mounted.name + ".json";
    files.push_back({file, robot_text(mounted.robot)});
    Json json{{"name", mounted.name}, {"robot", file}};
    if (mounted.parent >= 0) {
      const MountedRobot& parent = platform.robots[index(mounted.parent)];
      json["on"] = {{"robot", parent.name},
                    {"chain", parent.robot.chains[index(mounted.chain)].name}};
      if (!is_identity(mounted.X_MR)) json["on"]["pose"] = steps_json(mounted.X_MR);
    }
    if (mounted.mount) json["mount"] = link_json(*mounted.mount);
    robots.push_back(json);
  }
  Json json{{"name", platform.name}, {"robots", robots}};
  for (const auto& [a, b] : platform.exempt_pairs) json["exempt_collisions"].push_back({a, b});
  files.push_back({name.filename(), wrapped_json(json)});
  return files;
}

}  // namespace prehend
