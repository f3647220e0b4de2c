// The frames and joints that exports name, against the URDF file of the robot's maker, where it is
// at hand: its forward kinematics are multiplied out here, without any of our readers.
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tinyxml2.h>
#include <yaml-cpp/yaml.h>

#include <gtest/gtest.h>

#include "planner/plan/path/arm_path.h"
#include "planner/show/exports/end_effector.h"
#include "planner/show/exports/moveit_scene.h"
#include "sim/base/index.h"
#include "sim/base/random.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/make_scene.h"
#include "sim/scene/reach/reach.h"
#include "sim/scene/scene_file.h"
#include "tests/support/shared_data.h"

namespace prehend {
namespace {

constexpr const char* kPanda = "data/robots/urdf/franka_description/urdf/panda_arm_hand.urdf";
// Right angles of the file have 11 digits after the point.
constexpr double kDigits = 1e-6;

Vector3 three(const char* text) {
  Vector3 v = Vector3::Zero();
  if (text != nullptr) std::istringstream(text) >> v.x() >> v.y() >> v.z();
  return v;
}

// What a URDF file says of each link: its parent, and how it stands on it.
class UrdfFrames {
 public:
  explicit UrdfFrames(const std::string& file) {
    EXPECT_EQ(document_.LoadFile(file.c_str()), tinyxml2::XML_SUCCESS);
    const auto* robot = document_.FirstChildElement("robot");
    for (const auto* joint = robot->FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint")) {
      joints_[joint->FirstChildElement("child")->Attribute("link")] = joint;
    }
  }

  // The pose of a link in the root's frame with the joints at these values.
  Pose pose(const std::string& link, const std::map<std::string, double>& values) const {
    const auto found = joints_.find(link);
    if (found == joints_.end()) return Pose::Identity();
    const tinyxml2::XMLElement& joint = *found->second;
    Pose X = pose(joint.FirstChildElement("parent")->Attribute("link"), values);
    if (const auto* origin = joint.FirstChildElement("origin")) {
      const Vector3 rpy = three(origin->Attribute("rpy"));
      X = X * translation(three(origin->Attribute("xyz"))) *
          Eigen::AngleAxisd(rpy.z(), Vector3::UnitZ()) *
          Eigen::AngleAxisd(rpy.y(), Vector3::UnitY()) *
          Eigen::AngleAxisd(rpy.x(), Vector3::UnitX());
    }
    const std::string type = joint.Attribute("type");
    if (type == "fixed") return X;
    const Vector3 axis = three(joint.FirstChildElement("axis")->Attribute("xyz"));
    const double value = values.at(joint.Attribute("name"));
    if (type == "revolute") return X * Eigen::AngleAxisd(value, axis.normalized());
    return X * translation(value * axis);
  }

 private:
  tinyxml2::XMLDocument document_;
  std::map<std::string, const tinyxml2::XMLElement*> joints_;
};

Scene panda_scene(const std::string& platform) {
  Scene scene;
  scene.name = "panda";
  scene.object = nothing_to_grasp();
  scene.carrier = find_carrier(platform);
  scene.hand = scene.carrier->platform.robots[index(scene.carrier->hand)].robot;
  return scene;
}

void expect_same(const Pose& a, const Pose& b, const std::string& what) {
  EXPECT_LT((a.translation() - b.translation()).norm(), kDigits) << what;
  EXPECT_LT((a.linear() - b.linear()).norm(), kDigits) << what;
}

// The library's own arm, and the same from the file: names and poses are those of the file.
TEST(RealFrames, OfThePandaAreThoseOfItsUrdf) {
  PREHEND_NEEDS_SHARED(kPanda);
  const UrdfFrames urdf(test::shared(kPanda).string());
  for (const std::string& platform : {std::string("panda"), test::shared(kPanda).string()}) {
    SCOPED_TRACE(platform);
    const CompiledScene scene = compile(panda_scene(platform));
    const EndEffector frames = end_effector(scene.scene);
    EXPECT_EQ(frames.base.name, "panda_hand");
    EXPECT_EQ(frames.parent.name, "panda_link8");
    const Robot& robot = scene.arm->robot();
    const PlatformPart& part = scene.arm->hand_part();
    const std::vector<std::string> names = driver_names(robot);
    Random random(9);
    for (int n = 0; n < 50; ++n) {
      std::vector<double> dofs;
      for (const DegreeOfFreedom& dof : robot.dofs) {
        dofs.push_back(random.uniform(dof.lower, dof.upper));
      }
      const std::vector<double> joints = joint_values(robot, dofs);
      std::map<std::string, double> values;
      for (std::size_t j = 0; j < joints.size(); ++j) values[names[j]] = joints[j];
      std::vector<Pose> X_BJ;
      joint_poses(robot, joints, X_BJ);
      const Pose X_WH = X_BJ[index(part.joint)] * part.X_JR;
      expect_same(X_WH * frames.base.X_HF, urdf.pose("panda_hand", values), "base");
      expect_same(X_WH * frames.parent.X_HF, urdf.pose("panda_link8", values), "flange");
      // A finger is where the same joint of the file has it.
      std::vector<Pose> X_BL;
      link_poses(robot, joints, X_BL);
      for (std::size_t j = 0; j < joints.size(); ++j) {
        if (names[j] != "panda_finger_joint1") continue;
        const Vector3 moved = X_BJ[j].translation();
        EXPECT_LT((moved - urdf.pose("panda_leftfinger", values).translation()).norm(), kDigits);
      }
    }
  }
}

// The entries of the planning scene's matrix of allowed collisions are links of the file.
TEST(RealFrames, LinksAreCalledAsInTheUrdfOfThePanda) {
  PREHEND_NEEDS_SHARED(kPanda);
  tinyxml2::XMLDocument urdf;
  ASSERT_EQ(urdf.LoadFile(test::shared(kPanda).string().c_str()), tinyxml2::XML_SUCCESS);
  std::set<std::string> known = {"nothing"};
  for (const auto* link = urdf.RootElement()->FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link")) {
    known.insert(link->Attribute("name"));
  }
  for (const std::string& platform : {std::string("panda"), test::shared(kPanda).string()}) {
    SCOPED_TRACE(platform);
    Scene scene = panda_scene(platform);
    scene.object.name = "nothing";
    const YAML::Node yaml = YAML::Load(moveit_scene_yaml(compile(scene)));
    const YAML::Node entries = yaml["allowed_collision_matrix"]["entry_names"];
    std::set<std::string> names;
    for (const YAML::Node& entry : entries) names.insert(entry.as<std::string>());
    EXPECT_EQ(names.size(), entries.size());
    for (const char* link : {"nothing", "panda_hand", "panda_leftfinger", "panda_rightfinger"}) {
      EXPECT_TRUE(names.contains(link)) << link;
    }
    for (const std::string& name : names) EXPECT_TRUE(known.contains(name)) << name;
  }
}

// The tool centre point is 103.4 mm in front of panda_hand.
TEST(RealFrames, APathEndsWithTheToolWhereItWasAsked) {
  PREHEND_NEEDS_SHARED(kPanda);
  const UrdfFrames urdf(test::shared(kPanda).string());
  const CompiledScene scene = compile(panda_scene("panda"));
  const EndEffector frames = end_effector(scene.scene);
  ASSERT_TRUE(frames.tool);
  EXPECT_EQ(frames.tool->name, "panda_hand_tcp");
  const Pose X_WT = translation({0.4, 0.2, 0.4}) * Pose(Eigen::AngleAxisd(3.0, Vector3::UnitX()));
  const Pose X_WH = X_WT * frames.tool->X_HF.inverse();
  const std::vector<DofValues> goals =
      postures_at(*scene.arm, scene.scene.object.X_WO.inverse() * X_WH, {});
  const ArmPath path = plan_arm_path(scene, goals);
  ASSERT_EQ(path.end, ArmPathEnd::found);
  const std::vector<std::string> names = driver_names(scene.arm->robot());
  std::map<std::string, double> values;
  for (std::size_t j = 0; j < names.size(); ++j) values[names[j]] = path.motion.positions.back()[j];
  expect_same(urdf.pose("panda_hand", values) * translation({0.0, 0.0, 0.1034}), X_WT, "tool");
}

}  // namespace
}  // namespace prehend
