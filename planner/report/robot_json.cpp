#include "planner/report/robot_json.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "planner/picture/simplified_mesh.h"
#include "planner/report/packed_mesh.h"
#include "sim/base/quaternion.h"

namespace prehend {
namespace {

using Json = nlohmann::ordered_json;

// Links of real robots come with more detail than a picture of the whole shows.
constexpr std::size_t kMostLinkTriangles = 8000;

Pose rotation(double angle, const Vector3& axis) { return Pose(Eigen::AngleAxisd(angle, axis)); }

// The fixed transform that follows the motion about or along z: the rest of the joint's
// Denavit-Hartenberg transform, as motions about and along one axis may change places.
Pose after_motion(const Joint& joint) {
  return rotation(joint.theta, Vector3::UnitZ()) * translation(Vector3(joint.a, 0.0, joint.d)) *
         rotation(joint.alpha, Vector3::UnitX());
}

Json pose_or_null(const Pose& pose) {
  return pose.isApprox(Pose::Identity(), 1e-12) ? Json() : rounded(pose);
}

Json joints_json(const Robot& robot) {
  Json joints = Json::array();
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Joint& joint = robot.joints[j];
    const Chain& chain = robot.chains[static_cast<std::size_t>(joint.chain)];
    const bool first = chain.first_joint == static_cast<int>(j);
    joints.push_back({{"parent", first ? chain.parent : joint.parent},
                      {"type", joint.type == JointType::revolute ? "r" : "p"},
                      {"before", first ? pose_or_null(chain.X_PC) : Json()},
                      {"after", pose_or_null(after_motion(joint))}});
  }
  return joints;
}

Json link_json(const Link& link) {
  return {{"name", link.name},
          {"joint", link.joint},
          {"material", link.material},
          {"mesh", packed_mesh(simplified(link.mesh, kMostLinkTriangles))}};
}

}  // namespace

double rounded(double value, double scale) {
  const double scaled = std::round(value * scale) / scale;
  return std::isfinite(scaled) ? scaled : value;
}

Json rounded(const Vector3& v, double scale) {
  return Json::array({rounded(v.x(), scale), rounded(v.y(), scale), rounded(v.z(), scale)});
}

Json rounded(const Pose& pose) {
  const Eigen::Quaterniond q = quaternion_of(pose).normalized();
  const Vector3& p = pose.translation();
  Json json = Json::array();
  for (const double x : {p.x(), p.y(), p.z()}) json.push_back(rounded(x, 1e7));
  for (const double x : {q.x(), q.y(), q.z(), q.w()}) json.push_back(rounded(x, 1e7));
  return json;
}

double significant(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return std::strtod(text, nullptr);
}

Json robot_json(const Robot& robot) {
  Json links = Json::array();
  for (const Link& link : robot.links) links.push_back(link_json(link));
  return {{"name", robot.name}, {"joints", joints_json(robot)}, {"links", links}};
}

Json arm_json(const CompiledArm& arm) {
  const Robot& robot = arm.robot();
  Json links = Json::array();
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    if (!arm.is_hand_link(link_id(l))) links.push_back(link_json(robot.links[l]));
  }
  return {{"name", robot.name},
          {"joints", joints_json(robot)},
          {"links", links},
          {"X", rounded(arm.X_WB)},
          {"hand_joint", arm.hand_part().joint},
          {"X_hand", rounded(arm.hand_part().X_JR)},
          {"first_hand_joint", arm.hand_part().first_joint},
          {"start", joint_values(robot, arm.start)}};
}

}  // namespace prehend
