// What a good robot file becomes.
#include "sim/robot/files/robot_file.h"

#include <fstream>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/shape/mesh_checks.h"
#include "tests/sim/robot/files/robot_files.h"
#include "tests/support/turns.h"

namespace prehend {
namespace {

using test::load_robot_json;
using test::small_robot;

constexpr double kUnitRounding = 1e-15;

TEST(RobotFile, ConvertsUnitsToMetresAndRadians) {
  const Robot robot = load_robot_json(small_robot());
  EXPECT_EQ(robot.name, "small");
  EXPECT_NEAR(robot.joints[0].X_JA.translation().x(), 0.3, kUnitRounding);
  EXPECT_NEAR(robot.joints[2].zero, 0.005, kUnitRounding);
  EXPECT_NEAR(robot.joints[0].lower, -90.0 * test::kDegree, kUnitRounding);
  EXPECT_NEAR(robot.joints[2].upper, 0.04, kUnitRounding);
  EXPECT_NEAR(robot.joints[1].offset, 10.0 * test::kDegree, kUnitRounding);
  EXPECT_NEAR(robot.dofs[0].closing_velocity, 90.0 * test::kDegree, kUnitRounding);
  EXPECT_NEAR(robot.dofs[1].closing_velocity, -0.05, kUnitRounding);
  EXPECT_NEAR(bounds(robot.links[0].mesh).size().x(), 0.01, kUnitRounding);
  ASSERT_TRUE(robot.hand.has_value());
  EXPECT_NEAR(robot.hand->origin.z(), 0.003, kUnitRounding);
  EXPECT_NEAR(robot.hand->preshapes[0].max_width, 0.08, kUnitRounding);
}

TEST(RobotFile, DefaultUnitsAreMetresAndRadians) {
  nlohmann::json json = small_robot();
  json.erase("units");
  json.erase("hand");
  json["dofs"][1]["initial"] = 7;
  const Robot robot = load_robot_json(json);
  EXPECT_FALSE(robot.hand.has_value());
  EXPECT_EQ(robot.joints[0].X_JA.translation().x(), 300.0);
  EXPECT_EQ(robot.joints[0].upper, 90.0);
  EXPECT_EQ(robot.dofs[0].closing_velocity, 90.0);
  EXPECT_EQ(robot.dofs[1].initial, 7.0);
}

TEST(RobotFile, AngularVelocityMayHaveItsOwnUnit) {
  nlohmann::json json = small_robot();
  json["units"]["angular_velocity"] = "rad/s";
  json["dofs"][0]["closing_velocity"] = 1.5;
  EXPECT_EQ(load_robot_json(json).dofs[0].closing_velocity, 1.5);
}

// Gains are in SI units whatever the units of the file, and so is the stiffness of springs; their
// rest is a value of the joint.
TEST(RobotFile, ReadsGainsAndSprings) {
  nlohmann::json json = small_robot();
  json["dofs"][0]["stiffness"] = 20;
  json["dofs"][1]["damping"] = 3;
  json["chains"][0]["joints"][0]["spring"] = {{"stiffness", 2}, {"rest", 90}};
  json["chains"][1]["joints"][0]["spring"] = {{"stiffness", 400}, {"rest", -5}};
  const Robot robot = load_robot_json(json);
  EXPECT_EQ(robot.dofs[0].stiffness, 20.0);
  EXPECT_FALSE(robot.dofs[0].damping);
  EXPECT_FALSE(robot.dofs[1].stiffness);
  EXPECT_EQ(robot.dofs[1].damping, 3.0);
  EXPECT_EQ(robot.joints[0].spring.stiffness, 2.0);
  EXPECT_NEAR(robot.joints[0].spring.rest, 90.0 * test::kDegree, kUnitRounding);
  EXPECT_EQ(robot.joints[1].spring.stiffness, 0.0);
  EXPECT_EQ(robot.joints[2].spring.stiffness, 400.0);
  EXPECT_NEAR(robot.joints[2].spring.rest, -0.005, kUnitRounding);
}

TEST(RobotFile, JoinsChainsJointsAndLinks) {
  const Robot robot = load_robot_json(small_robot());
  ASSERT_EQ(robot.chains.size(), 2U);
  EXPECT_EQ(robot.chains[0].joint_count, 2);
  EXPECT_EQ(robot.chains[1].first_joint, 2);
  EXPECT_EQ(robot.joints[0].parent, -1);
  EXPECT_EQ(robot.joints[1].parent, 0);
  EXPECT_EQ(robot.joints[2].parent, -1);
  EXPECT_EQ(robot.joints[2].chain, 1);
  ASSERT_EQ(robot.links.size(), 4U);
  EXPECT_EQ(robot.links[0].joint, -1);
  EXPECT_EQ(robot.links[2].name, "fore");
  EXPECT_EQ(robot.links[2].joint, 1);
  EXPECT_EQ(robot.links[3].material, "rubber");
  const Vector3 along_x = robot.joints[2].X_PJ.linear() * robot.joints[2].axis;
  EXPECT_LT((along_x - Vector3::UnitX()).norm(), kUnitRounding);
}

TEST(RobotFile, LimitsOfADegreeOfFreedomKeepEveryJointInside) {
  // shoulder: -90 <= q <= 90; elbow: -30 <= q / 2 + 10 <= 60, so -80 <= q <= 100.
  const Robot robot = load_robot_json(small_robot());
  EXPECT_NEAR(robot.dofs[0].lower, -80.0 * test::kDegree, kUnitRounding);
  EXPECT_NEAR(robot.dofs[0].upper, 90.0 * test::kDegree, kUnitRounding);
}

TEST(RobotFile, NegativeRatioTurnsLimitsRound) {
  // elbow: -30 <= -q / 2 + 10 <= 60, so -100 <= q <= 80.
  nlohmann::json json = small_robot();
  json["dofs"][0]["drives"][1]["ratio"] = -0.5;
  const Robot robot = load_robot_json(json);
  EXPECT_NEAR(robot.dofs[0].lower, -90.0 * test::kDegree, kUnitRounding);
  EXPECT_NEAR(robot.dofs[0].upper, 80.0 * test::kDegree, kUnitRounding);
}

TEST(RobotFile, InitialValueIsZeroOrTheLimitNearestToZero) {
  nlohmann::json json = small_robot();
  EXPECT_EQ(load_robot_json(json).dofs[0].initial, 0.0);
  json["chains"][0]["joints"][0]["limits"] = {20, 90};
  EXPECT_NEAR(load_robot_json(json).dofs[0].initial, 20.0 * test::kDegree, kUnitRounding);
}

TEST(RobotFile, PreshapeLeavesUnnamedDegreesOfFreedomAtTheirInitialValue) {
  nlohmann::json json = small_robot();
  json["hand"]["preshapes"][0]["dofs"] = {{"bend", 45}};
  const Robot robot = load_robot_json(json);
  const std::vector<double>& dofs = robot.hand->preshapes[0].dofs;
  ASSERT_EQ(dofs.size(), 2U);
  EXPECT_NEAR(dofs[0], 45.0 * test::kDegree, kUnitRounding);
  EXPECT_NEAR(dofs[1], 0.02, kUnitRounding);
}

TEST(RobotFile, DirectionsAreMadeUnit) {
  EXPECT_LT((load_robot_json(small_robot()).hand->approach - Vector3::UnitZ()).norm(),
            kUnitRounding);
}

TEST(RobotFile, SelfCenteringFingersShareOneDegreeOfFreedom) {
  nlohmann::json json = small_robot();
  nlohmann::json second = json["chains"][1];
  second["name"] = "finger_b";
  second["joints"][0]["name"] = "slide_b";
  second["links"][0]["name"] = "tip_b";
  second["links"][0]["joint"] = "slide_b";
  second["base"][1]["rotate_y"] = -90;
  json["chains"].push_back(second);
  json["dofs"][1]["drives"].push_back({{"joint", "slide_b"}});
  json["dofs"][1]["coupling"] = "self_centering";
  EXPECT_EQ(load_robot_json(json).dofs[1].coupling, Coupling::self_centering);
}

TEST(RobotFile, ShapesAreMovedByTheirPoseAndAppended) {
  nlohmann::json json = small_robot();
  json["base"]["geometry"] = nlohmann::json::parse(R"([
    {"shape": "box", "size": [2, 2, 2], "pose": [{"translate": [10, 0, 0]}]},
    {"shape": "cylinder", "radius": 1, "height": 8, "sides": 4,
     "pose": [{"rotate_z": 90}, {"translate": [3, 0, 0]}]},
    {"shape": "sphere", "radius": 2, "pose": [{"translate": [0, 0, -20]}]}])");
  const Bounds box = bounds(load_robot_json(json).links[0].mesh);
  EXPECT_NEAR(box.upper.x(), 0.011, kUnitRounding);
  EXPECT_NEAR(box.upper.y(), 0.004,
              kUnitRounding);  // the cylinder went along y: turned, then moved
  EXPECT_NEAR(box.upper.z(), 0.004, kUnitRounding);
  EXPECT_NEAR(box.lower.z(), -0.022, 2e-4);  // a sphere of triangles
}

struct PlaneCase {
  const char* plane;
  Vector3 size;  // of a 1 x 2 profile swept by 3
};

class PrismPlane : public testing::TestWithParam<PlaneCase> {};

TEST_P(PrismPlane, SweepsTheProfileAlongTheThirdAxisInEitherSense) {
  for (const bool clockwise : {false, true}) {
    nlohmann::json profile = {{0, 0}, {1, 0}, {1, 2}, {0, 2}};
    if (clockwise) profile = {{0, 2}, {1, 2}, {1, 0}, {0, 0}};
    nlohmann::json json = small_robot();
    json["base"]["geometry"] = {
        {{"shape", "prism"}, {"plane", GetParam().plane}, {"profile", profile}, {"sweep", {1, 4}}}};
    const TriangleMesh mesh = load_robot_json(json).links[0].mesh;
    EXPECT_LT((bounds(mesh).size() - 1e-3 * GetParam().size).norm(), kUnitRounding);
    double six_volumes = 0.0;
    for (const Triangle& t : mesh.triangles) {
      const auto at = [&](int k) {
        return mesh.vertices[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])];
      };
      six_volumes += at(0).dot(at(1).cross(at(2)));
    }
    EXPECT_NEAR(six_volumes / 6.0, 6e-9, 1e-20) << "faces must look outward";
  }
}

INSTANTIATE_TEST_SUITE_P(Planes, PrismPlane,
                         testing::Values(PlaneCase{"xy", {1, 2, 3}}, PlaneCase{"yz", {3, 1, 2}},
                                         PlaneCase{"zx", {2, 3, 1}}),
                         [](const auto& one) { return std::string(one.param.plane); });

// A cuboid's corners and points inside it, in any order, are the cuboid, posed like any shape.
TEST(RobotFile, AHullIsTheConvexHullOfItsPoints) {
  Random random(7);
  nlohmann::json points = nlohmann::json::array();
  for (const double x : {-1.0, 2.0}) {
    for (const double y : {0.0, 4.0}) {
      for (const double z : {1.0, 6.0}) {
        points.push_back({x, y, z});
        points.push_back({random.uniform(-1.0, 2.0), random.uniform(0.0, 4.0), 3.0});
      }
    }
  }
  nlohmann::json json = small_robot();
  json["base"]["geometry"] = {
      {{"shape", "hull"}, {"points", points}, {"pose", {{{"translate", {10, 0, 0}}}}}}};
  const TriangleMesh mesh = load_robot_json(json).links[0].mesh;
  EXPECT_EQ(mesh.vertices.size(), 8U);
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_LT((bounds(mesh).lower - Vector3(9e-3, 0.0, 1e-3)).norm(), kUnitRounding);
  EXPECT_LT((bounds(mesh).upper - Vector3(12e-3, 4e-3, 6e-3)).norm(), kUnitRounding);
  EXPECT_FALSE(check_mesh(mesh).inward);
  EXPECT_TRUE(check_mesh(mesh).solid());
}

TEST(RobotFile, AHullHasAtMostTenThousandPoints) {
  Random random(8);
  nlohmann::json points = nlohmann::json::array();
  while (points.size() < 10'000) {
    const Vector3 p = random.direction();
    points.push_back({p.x(), p.y(), p.z()});
  }
  nlohmann::json json = small_robot();
  json["base"]["geometry"] = {{{"shape", "hull"}, {"points", points}}};
  EXPECT_GT(load_robot_json(json).links[0].mesh.triangles.size(), 19'000U);
  json["base"]["geometry"][0]["points"].push_back({0, 0, 0});
  EXPECT_THROW(load_robot_json(json), InputError);
}

TEST(RobotFile, MeshFilesAreFoundBesideTheRobotFile) {
  const std::filesystem::path mesh = std::filesystem::path(testing::TempDir()) / "tetrahedron.obj";
  std::ofstream(mesh) << "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\n"
                         "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  nlohmann::json json = small_robot();
  json["base"]["geometry"] = {{{"mesh", "tetrahedron.obj"}, {"unit", "cm"}}};
  EXPECT_NEAR(bounds(load_robot_json(json).links[0].mesh).upper.x(), 0.02, 1e-9);
  json["base"]["geometry"] = {{{"mesh", "tetrahedron.obj"}}};  // the file's own unit
  EXPECT_NEAR(bounds(load_robot_json(json).links[0].mesh).upper.x(), 0.002, 1e-9);
}

}  // namespace
}  // namespace prehend
