// Robots of GraspIt! read from its files, beside link poses, limits and geometry that GraspIt!
// itself reported for them.
#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/robot/files/graspit_robot.h"
#include "tests/support/shared_data.h"

namespace prehend {
namespace {

using Json = nlohmann::json;

Json reference_of(const std::string& name) {
  std::ifstream stream(test::shared("reference/graspit/fk/" + name + ".json"));
  return Json::parse(stream);
}

Robot imported(const std::string& name) {
  return read_graspit_robot(
      XmlFile(test::shared("data/robots/graspit/models/robots/" + name + "/" + name + ".xml")));
}

Pose pose_of(const Json& pose) {
  const Json& q = pose["quat_wxyz"];
  const Json& t = pose["t_mm"];
  const Eigen::Quaterniond rotation(q[0].get<double>(), q[1].get<double>(), q[2].get<double>(),
                                    q[3].get<double>());
  return translation(0.001 * Vector3(t[0].get<double>(), t[1].get<double>(), t[2].get<double>())) *
         Pose(rotation.normalized());
}

// Metres or radians per unit that GraspIt! has for a degree of freedom.
double unit_of_dof(const Robot& robot, int dof) {
  const auto joint = std::find_if(robot.joints.begin(), robot.joints.end(),
                                  [&](const Joint& candidate) { return candidate.dof == dof; });
  return joint->type == JointType::revolute ? 1.0 : 0.001;
}

class GraspitRobots : public testing::TestWithParam<const char*> {};

TEST_P(GraspitRobots, LinksAreWhereGraspItHasThem) {
  PREHEND_NEEDS_SHARED("reference/graspit/fk");
  PREHEND_NEEDS_SHARED("data/robots/graspit");
  const Json reference = reference_of(GetParam());
  const Robot robot = imported(GetParam());
  ASSERT_EQ(robot.dofs.size(), reference["num_dof"]);
  ASSERT_EQ(robot.joints.size(), reference["num_joints"]);
  double farthest = 0.0;
  double most_turned = 0.0;
  for (const Json& posture : reference["poses"]) {
    std::vector<double> dofs;
    for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
      dofs.push_back(posture["dof"][d].get<double>() * unit_of_dof(robot, static_cast<int>(d)));
    }
    std::vector<Pose> X_BL;
    link_poses(robot, joint_values(robot, dofs), X_BL);
    for (const Json& link : posture["links"]) {
      const std::string name = "chain" + link["chain"].dump() + "_link" + link["link"].dump();
      const auto found = std::find_if(robot.links.begin(), robot.links.end(),
                                      [&](const Link& own) { return own.name == name; });
      ASSERT_NE(found, robot.links.end()) << name;
      const Pose& own = X_BL[static_cast<std::size_t>(found - robot.links.begin())];
      const Pose error = own.inverse() * pose_of(link["pose"]);
      farthest = std::max(farthest, error.translation().norm());
      most_turned = std::max(most_turned, Eigen::AngleAxisd(error.linear()).angle());
    }
  }
  EXPECT_LT(farthest, 1e-6);
  EXPECT_LT(most_turned, 1e-6);
}

TEST_P(GraspitRobots, HaveTheLimitsVelocitiesMaterialsAndGeometryOfGraspIt) {
  PREHEND_NEEDS_SHARED("reference/graspit/fk");
  PREHEND_NEEDS_SHARED("data/robots/graspit");
  const Json reference = reference_of(GetParam());
  const Robot robot = imported(GetParam());
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    const double unit = unit_of_dof(robot, static_cast<int>(d));
    const Json& own = reference["dofs"][d];
    EXPECT_NEAR(robot.dofs[d].lower, own["min"].get<double>() * unit, 1e-8);
    EXPECT_NEAR(robot.dofs[d].upper, own["max"].get<double>() * unit, 1e-8);
    EXPECT_NEAR(robot.dofs[d].initial, own["default"].get<double>() * unit, 1e-9);
    EXPECT_NEAR(robot.dofs[d].closing_velocity, own["default_velocity"].get<double>() * unit, 1e-9);
    EXPECT_EQ(robot.dofs[d].coupling, own["type"] == 1 ? Coupling::breakaway : Coupling::rigid);
  }
  std::vector<Json> links = reference["links"];
  links.insert(links.begin(), reference["palm"]);
  ASSERT_EQ(robot.links.size(), links.size());
  for (std::size_t l = 0; l < links.size(); ++l) {
    EXPECT_EQ(robot.links[l].material, links[l]["material"]);
    const Bounds box = bounds(robot.links[l].mesh);
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      EXPECT_NEAR(box.lower[k], 0.001 * links[l]["aabb_min"][axis].get<double>(), 2e-6);
      EXPECT_NEAR(box.upper[k], 0.001 * links[l]["aabb_max"][axis].get<double>(), 2e-6);
    }
  }
}

TEST(GraspitArm, IsSolvedInClosedForm) {
  const std::string file = "data/robots/graspit/models/robots/Puma560/Puma560.xml";
  PREHEND_NEEDS_SHARED(file);
  const Robot arm = read_graspit_robot(XmlFile(test::shared(file)));
  EXPECT_EQ(arm.chains.front().closed_form, ClosedForm::spherical_wrist);
}

INSTANTIATE_TEST_SUITE_P(Models, GraspitRobots,
                         testing::Values("Barrett", "M7tool", "Puma560", "SimpleArm", "XR4000",
                                         "fetch_gripper"),
                         [](const auto& model) { return std::string(model.param); });

}  // namespace
}  // namespace prehend
