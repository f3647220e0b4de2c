#include "planner/show/report/robot_json.h"

#include <cmath>
#include <cstdlib>

#include "planner/show/report/packed_mesh.h"
#include "sim/base/formatted.h"
#include "sim/base/pose.h"

namespace prehend {
namespace {

using Json = nlohmann::ordered_json;

// Links of real robots come with more detail than a picture of the whole shows.
constexpr std::size_t kMostLinkTriangles = 8000;

// Many poses are the identity and most axes are z. Null stands for these.
Json pose_or_null(const Pose& pose) {
  return pose.isApprox(Pose::Identity(), 1e-12) ? Json() : rounded(pose);
}

Json axis_or_null(const Vector3& axis) {
  return axis == Vector3::UnitZ() ? Json() : rounded(axis, 1e9);
}

Json joints_json(const Robot& robot) {
  Json joints = Json::array();
  for (const Joint& joint : robot.joints) {
    // The page computes before * motion(axis, value) * after. A joint may have a zero position:
    // motion(axis, value + zero) is motion(axis, value) * motion(axis, zero), and across(joint, 0)
    // contains the second factor.
    joints.push_back({{"parent", joint.parent},
                      {"type", joint.type == JointType::revolute ? "r" : "p"},
                      {"axis", axis_or_null(joint.axis)},
                      {"before", pose_or_null(joint.X_PJ)},
                      {"after", pose_or_null(across(joint, 0.0))}});
  }
  return joints;
}

Json link_json(const Link& link) {
  return {{"name", link.name},
          {"joint", link.joint},
          {"material", link.material},
          {"mesh", drawn_mesh(link.mesh, kMostLinkTriangles)}};
}

}  // namespace

double rounded(double value, double scale) {
  const double scaled = std::round(value * scale) / scale;
  // The product overflows for very large values, which are kept.
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

double significant(double value) { return std::strtod(formatted("%.6g", value).c_str(), nullptr); }

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
