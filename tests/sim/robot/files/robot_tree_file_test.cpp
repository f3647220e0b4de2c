// Robot files with chains on chains, joints written by axis and origin, masses, efforts and
// friction.
#include <numbers>

#include <gtest/gtest.h>

#include "sim/base/material.h"
#include "sim/robot/files/robot_file.h"
#include "tests/sim/robot/files/robot_files.h"
#include "tests/support/turns.h"

namespace prehend {
namespace {

using test::complaint_about;
using test::load_robot_json;
using test::small_robot;
using test::write_robot_text;

constexpr double kTreeRounding = 1e-12;

// The sliding finger stands on the joint `shoulder`, in the middle of the arm.
nlohmann::json branching_robot() {
  nlohmann::json json = small_robot();
  json["chains"][1]["parent"] = "shoulder";
  return json;
}

TEST(RobotTreeFile, AChainStandsOnAJointOfAnEarlierOne) {
  const Robot robot = load_robot_json(branching_robot());
  ASSERT_EQ(robot.joints.size(), 3U);
  EXPECT_EQ(robot.joints[1].parent, 0);
  EXPECT_EQ(robot.joints[2].parent, 0);
  std::vector<Pose> X_BJ;
  joint_poses(robot, {0.5, 0.2, 0.03}, X_BJ);
  const Pose expected = X_BJ[0] * translation({0.0, 0.0, 0.01}) *
                        Eigen::AngleAxisd(std::numbers::pi / 2.0, Vector3::UnitY()) *
                        translation({0.0, 0.0, 0.035});
  EXPECT_LT((X_BJ[2].matrix() - expected.matrix()).norm(), kTreeRounding);
}

TEST(RobotTreeFile, ChainsStandOnChainsThatStandOnChains) {
  nlohmann::json json = branching_robot();
  nlohmann::json third = json["chains"][1];
  third["name"] = "nail";
  third["parent"] = "slide";
  third["joints"][0]["name"] = "nail_slide";
  third["links"][0]["name"] = "nail";
  third["links"][0]["joint"] = "nail_slide";
  json["chains"].push_back(third);
  json["dofs"][1]["drives"].push_back({{"joint", "nail_slide"}});
  const Robot robot = load_robot_json(json);
  EXPECT_EQ(joints_to(robot, 3), (std::vector<int>{0, 2, 3}));
}

TEST(RobotTreeFile, AJointHasAnAxisAndAnOrigin) {
  nlohmann::json json = small_robot();
  json["chains"][1]["joints"][0] = nlohmann::json::parse(R"(
    {"name": "slide", "type": "prismatic", "axis": [0, 3, 4], "limits": [0, 40],
     "origin": [{"translate": [5, 0, 0]}, {"rotate_z": 90}]})");
  const Robot robot = load_robot_json(json);
  const Joint& joint = robot.joints[2];
  EXPECT_LT((joint.axis - Vector3(0.0, 0.6, 0.8)).norm(), kTreeRounding);
  EXPECT_EQ(joint.zero, 0.0);
  const Pose expected =
      translation({0.0, 0.0, 0.01}) * Eigen::AngleAxisd(90.0 * test::kDegree, Vector3::UnitY()) *
      translation({0.005, 0.0, 0.0}) * Eigen::AngleAxisd(90.0 * test::kDegree, Vector3::UnitZ());
  EXPECT_LT((joint.X_PJ.matrix() - expected.matrix()).norm(), kTreeRounding);
  std::vector<Pose> X_BJ;
  joint_poses(robot, {0.0, 0.0, 0.02}, X_BJ);
  const Pose moved = expected * translation(0.02 * Vector3(0.0, 0.6, 0.8));
  EXPECT_LT((X_BJ[2].matrix() - moved.matrix()).norm(), kTreeRounding);
}

TEST(RobotTreeFile, AJointMaySayItsEffortAndFriction) {
  nlohmann::json json = small_robot();
  json["chains"][0]["joints"][0]["effort"] = 2.5;
  json["chains"][0]["joints"][1]["friction"] = {{"coulomb", 0.1}, {"viscous", 0.02}};
  const Robot robot = load_robot_json(json);
  EXPECT_EQ(robot.joints[0].max_effort, 2.5);  // whatever the units of length and angle
  EXPECT_EQ(robot.joints[0].friction.viscous, 0.0);
  EXPECT_EQ(robot.joints[1].max_effort, 0.0);
  EXPECT_EQ(robot.joints[1].friction.coulomb, 0.1);
  EXPECT_EQ(robot.joints[1].friction.viscous, 0.02);
}

// The links are bars of 10 x 4 x 4 mm.
constexpr double kVolume = 160e-9;  // m^3

TEST(LinkMass, ComesFromTheMeshAndTheMaterial) {
  nlohmann::json json = small_robot();
  json["chains"][0]["links"][1]["mass"] = "mesh";
  json["chains"][1]["links"][0]["density"] = 5000;
  const Robot robot = load_robot_json(json);
  EXPECT_NEAR(robot.links[0].inertial.mass, 2700.0 * kVolume, kTreeRounding) << "metal";
  EXPECT_NEAR(robot.links[1].inertial.mass, 700.0 * kVolume, kTreeRounding) << "wood";
  EXPECT_NEAR(robot.links[2].inertial.mass, 700.0 * kVolume, kTreeRounding) << "wood";
  EXPECT_NEAR(robot.links[3].inertial.mass, 5000.0 * kVolume, kTreeRounding);
  const double moment = robot.links[3].inertial.mass * (16e-6 + 16e-6) / 12.0;
  EXPECT_NEAR(robot.links[3].inertial.inertia(0, 0), moment, 1e-9 * moment);
}

TEST(LinkMass, IsStatedInTheUnitsOfTheFile) {
  nlohmann::json json = small_robot();
  json["units"]["mass"] = "g";
  nlohmann::json& link = json["chains"][0]["links"][0];
  link["mass"] = 200;
  link["center_of_mass"] = {1, 2, 3};
  link["inertia"] = {100, 200, 250, 5, 6, 7};
  json["base"]["mass"] = 50;
  const Robot robot = load_robot_json(json);
  const Inertial& inertial = robot.links[1].inertial;
  EXPECT_NEAR(inertial.mass, 0.2, kTreeRounding);
  EXPECT_LT((inertial.center_of_mass - Vector3(0.001, 0.002, 0.003)).norm(), kTreeRounding);
  Matrix3 expected;
  expected << 100, 5, 6, 5, 200, 7, 6, 7, 250;  // g mm^2
  EXPECT_LT((inertial.inertia - 1e-9 * expected).norm(), 1e-18);
  // The rest comes from the mesh.
  EXPECT_NEAR(robot.links[0].inertial.mass, 0.05, kTreeRounding);
  EXPECT_NEAR(robot.links[0].inertial.inertia(0, 0), 0.05 * 32e-6 / 12.0, 1e-15);
}

TEST(LinkMass, InertiaMayBeThreeRows) {
  nlohmann::json json = small_robot();
  json["base"]["mass"] = 1;
  json["base"]["center_of_mass"] = {0, 0, 0};
  json["base"]["inertia"] = nlohmann::json::parse("[[3, 1, 0], [1, 4, 0], [0, 0, 5]]");
  const Matrix3 inertia = load_robot_json(json).links[0].inertial.inertia;
  EXPECT_NEAR(inertia(0, 1), 1e-6, kTreeRounding);
  EXPECT_NEAR(inertia(2, 2), 5e-6, kTreeRounding);
}

TEST(LinkMass, OfAFlatLinkIsNothingUnlessItIsStated) {
  nlohmann::json json = small_robot();
  json["base"]["geometry"] = nlohmann::json::parse(
      R"([{"shape": "triangles", "vertices": [[0,0,0],[1,0,0],[0,1,0]], "triangles": [[0,1,2]]}])");
  EXPECT_EQ(load_robot_json(json).links[0].inertial.mass, 0.0);
  json["base"]["mass"] = 2;
  EXPECT_EQ(load_robot_json(json).links[0].inertial.mass, 2.0);
  json["base"]["mass"] = "mesh";
  EXPECT_EQ(complaint_about(write_robot_text(json.dump())).rfind("base.geometry: flat, it has", 0),
            0U);
}

struct BadEntry {
  const char* name;
  const char* pointer;
  const char* value;
  const char* complaint;  // its beginning
};

class BadTreeField : public testing::TestWithParam<BadEntry> {};

TEST_P(BadTreeField, IsNamed) {
  nlohmann::json json = branching_robot();
  json[nlohmann::json::json_pointer(GetParam().pointer)] = nlohmann::json::parse(GetParam().value);
  const std::string complaint = complaint_about(write_robot_text(json.dump()));
  EXPECT_EQ(complaint.rfind(GetParam().complaint, 0), 0U) << complaint;
}

INSTANTIATE_TEST_SUITE_P(
    RobotTreeFile, BadTreeField,
    testing::Values(
        BadEntry{
            "UnknownParent", "/chains/1/parent", R"("knee")",
            R"(chains[1].parent: must be the name of a joint in a chain before this one ("knee"))"},
        BadEntry{"ParentOfALaterChain", "/chains/0/parent", R"("slide")",
                 "chains[0].parent: must be the name of a joint in a chain before this one"},
        BadEntry{"OwnJointAsParent", "/chains/1/parent", R"("slide")",
                 "chains[1].parent: must be the name of a joint in a chain before this one"},
        BadEntry{"BothWays", "/chains/0/joints/0/axis", "[0, 0, 1]",
                 "chains[0].joints[0].theta: a joint has theta, d, a and alpha, or an origin and "
                 "an axis, not both (0)"},
        BadEntry{"OriginWithoutAxis", "/chains/0/joints/0",
                 R"({"name": "shoulder", "type": "revolute", "origin": [], "limits": [0, 1]})",
                 "chains[0].joints[0].axis: must be given"},
        BadEntry{"ZeroAxis", "/chains/0/joints/0",
                 R"({"name": "shoulder", "type": "revolute", "axis": [0,0,0], "limits": [0, 1]})",
                 "chains[0].joints[0].axis: must not be the zero vector ([0,0,0])"},
        BadEntry{"NoEffort", "/chains/0/joints/0/effort", "0",
                 "chains[0].joints[0].effort: must be above 0 and at most 1e9 (0)"},
        BadEntry{"NegativeFriction", "/chains/0/joints/0/friction", R"({"viscous": -1})",
                 "chains[0].joints[0].friction.viscous: must be at least 0 and at most 1e15 (-1)"},
        BadEntry{"UnknownFriction", "/chains/0/joints/0/friction", R"({"static": 1})",
                 "chains[0].joints[0].friction.static: unknown field"},
        BadEntry{"UnknownMassUnit", "/units/mass", R"("t")",
                 R"(units.mass: unknown unit, known are kg and g ("t"))"},
        BadEntry{"UnknownMaterial", "/base/material", R"("cheese")",
                 "base.material: unknown material, known are glass, metal, plastic, wood and "
                 "rubber"},
        BadEntry{"NoMass", "/base/mass", "0", "base.mass: must be above 0 and at most 1e9 (0)"},
        BadEntry{"MassInWords", "/base/mass", R"("heavy")",
                 R"(base.mass: must be a number, "mesh" or "unknown")"},
        BadEntry{"NoDensity", "/base/density", "-1",
                 "base.density: must be above 0 and at most 1e6 (-1)"},
        BadEntry{"CenterWithoutMass", "/base/center_of_mass", "[0, 0, 0]",
                 R"(base.center_of_mass: needs "mass" as a number with it)"}));

TEST(LinkMass, ComplainsOfWhatDoesNotGoTogether) {
  const auto complaint = [](const char* fields) {
    nlohmann::json json = small_robot();
    json["base"].update(nlohmann::json::parse(fields));
    return complaint_about(write_robot_text(json.dump()));
  };
  EXPECT_EQ(complaint(R"({"mass": 1, "density": 1000})"),
            "base.density: a link has a mass or a density, not both (1000)");
  EXPECT_EQ(complaint(R"({"mass": 1, "inertia": [1, 1, 1, 0, 0, 0]})")
                .rfind("base.inertia: needs \"center_of_mass\" with it", 0),
            0U);
  EXPECT_EQ(complaint(R"({"mass": 1, "center_of_mass": [0,0,0], "inertia": [1, 1, 3, 0, 0, 0]})")
                .rfind("base.inertia: no body has such an inertia", 0),
            0U);
  EXPECT_EQ(complaint(R"({"mass": 1, "center_of_mass": [0,0,0], "inertia": [1, 1]})")
                .rfind("base.inertia: must be three rows of three numbers, or six numbers", 0),
            0U);
}

// Meshes leave out what cannot be seen, as the shaft of the Puma's flange [m].
constexpr double kHidden = 0.02;

TEST(LinkMass, OfEveryLibraryLinkIsKnown) {
  for (const std::string& name : library_robot_names()) {
    for (const Link& link : find_robot(name).links) {
      EXPECT_GT(link.inertial.mass, 0.0) << name << " " << link.name;
      EXPECT_EQ(inertia_defect(link.inertial.inertia), "") << name << " " << link.name;
      const Bounds box = bounds(link.mesh);
      const Vector3& center = link.inertial.center_of_mass;
      EXPECT_TRUE((center.array() > box.lower.array() - kHidden).all()) << name << " " << link.name;
      EXPECT_TRUE((center.array() < box.upper.array() + kHidden).all()) << name << " " << link.name;
    }
  }
}

TEST(Materials, HaveTheDensitiesOfTheManual) {
  EXPECT_EQ(density_of(Material::glass), 2500.0);
  EXPECT_EQ(density_of(Material::metal), 2700.0);
  EXPECT_EQ(density_of(Material::plastic), 1050.0);
  EXPECT_EQ(density_of(Material::wood), 700.0);
  EXPECT_EQ(density_of(Material::rubber), 1100.0);
}

}  // namespace
}  // namespace prehend
