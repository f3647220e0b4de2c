// Every complaint about a robot file is one line that names the file, the field and the value.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/sim/robot/files/robot_files.h"

namespace prehend {
namespace {

using Json = nlohmann::json;
using test::complaint_about;
using test::small_robot;
using test::write_robot_text;

// The small robot with one field changed (removed when `value` is "REMOVE").
struct BadField {
  std::string label;
  std::string pointer;
  std::string value;
  std::string complaint;
};

std::vector<BadField> bad_fields() {
  return {
      {"MissingName", "/name", "REMOVE", "name: must be given"},
      {"EmptyName", "/name", R"("")", R"(name: must be a text that is not empty (""))"},
      {"UnknownTopField", "/colour", R"("red")",
       "colour: unknown field, known here are name, units, geometries, base, links, chains, dofs, "
       R"(hand, frames, exempt_collisions ("red"))"},
      {"UnknownJointField", "/chains/0/joints/1/thetta", "3",
       "chains[0].joints[1].thetta: unknown field, known here are name, type, theta, d, a, alpha, "
       "origin, axis, zero, after, limits, effort, friction, spring, driver_name; did you mean "
       "theta? (3)"},
      {"UnknownDofField", "/dofs/0/speed", "1",
       "dofs[0].speed: unknown field, known here are name, drives, initial, closing_velocity, "
       "coupling, breakaway_effort, velocity, acceleration, stiffness, damping (1)"},
      {"UnknownLengthUnit", "/units/length", R"("furlong")", "units.length: "},
      {"UnknownAngleUnit", "/units/angle", R"("grad")",
       R"(units.angle: unknown unit, known are rad and deg ("grad"))"},
      {"TextForNumber", "/chains/0/joints/0/a", R"("300")",
       R"(chains[0].joints[0].a: must be a number ("300"))"},
      {"MissingDenavitHartenberg", "/chains/0/joints/0/alpha", "REMOVE",
       "chains[0].joints[0].alpha: must be given"},
      {"UnknownJointType", "/chains/0/joints/0/type", R"("helical")",
       "chains[0].joints[0].type: unknown joint type, known are revolute and prismatic "
       R"(("helical"))"},
      {"LimitsWrongWayRound", "/chains/0/joints/1/limits", "[60, -30]",
       "chains[0].joints[1].limits: the lower limit must be at most the upper one ([60,-30])"},
      {"OneLimit", "/chains/0/joints/1/limits", "[60]",
       "chains[0].joints[1].limits: must be a list of 2 numbers ([60])"},
      {"SameJointName", "/chains/1/joints/0/name", R"("elbow")",
       R"(chains[1].joints[0].name: name used twice ("elbow"))"},
      {"SameLinkName", "/chains/1/links/0/name", R"("foot")",
       R"(chains[1].links[0].name: name used twice ("foot"))"},
      {"NoJoints", "/chains/1/joints", "[]",
       "chains[1].joints: a chain needs at least one joint ([])"},
      {"JointThatNothingDrives", "/dofs/0/drives", R"([{"joint": "shoulder"}])",
       "chains[0].joints[1].name: must be driven by a degree of freedom (elbow)"},
      {"DofThatDrivesNothing", "/dofs/1/drives", "[]",
       "dofs[1].drives: a degree of freedom must drive at least one joint ([])"},
      {"DrivesUnknownJoint", "/dofs/1/drives/0/joint", R"("slyde")",
       R"(dofs[1].drives[0].joint: no joint of this name ("slyde"))"},
      {"DrivenTwice", "/dofs/1/drives/0/joint", R"("elbow")",
       R"(dofs[1].drives[0].joint: joint is driven twice ("elbow"))"},
      {"MixedJointTypes", "/dofs/0/drives/1/joint", R"("slide")",
       "dofs[0].drives[1].joint: a degree of freedom drives joints of one type only "
       R"(("slide"))"},
      {"ZeroRatio", "/dofs/0/drives/1/ratio", "0",
       "dofs[0].drives[1].ratio: its size must be at least 1e-9 and at most 1e9 (0)"},
      {"NoCommonLimits", "/dofs/0/drives/1/offset", "200",
       "dofs[0].drives: no value keeps every driven joint inside its limits ("},
      {"InitialOutside", "/dofs/1/initial", "41",
       "dofs[1].initial: outside the limits 0.000000 to 0.040000 rad or m (41)"},
      {"UnknownCoupling", "/dofs/0/coupling", R"("loose")",
       "dofs[0].coupling: unknown coupling, known are rigid, breakaway, by_finger and "
       "self_centering "
       R"(("loose"))"},
      {"SelfCenteringRevolutes", "/dofs/0/coupling", R"("self_centering")",
       "dofs[0].coupling: needs two prismatic joints on one parent that slide in opposite "
       "directions "
       R"(("self_centering"))"},
      {"NegativeStiffness", "/dofs/1/stiffness", "-1",
       "dofs[1].stiffness: must be at least 0 and at most 1e15 (-1)"},
      {"NegativeDamping", "/dofs/0/damping", "-0.5",
       "dofs[0].damping: must be at least 0 and at most 1e15 (-0.5)"},
      {"TextForStiffness", "/dofs/0/stiffness", R"("high")",
       R"(dofs[0].stiffness: must be a number ("high"))"},
      {"NegativeSpring", "/chains/0/joints/1/spring", R"({"stiffness": -2})",
       "chains[0].joints[1].spring.stiffness: must be at least 0 and at most 1e15 (-2)"},
      {"SpringWithoutStiffness", "/chains/0/joints/1/spring", R"({"rest": 2})",
       "chains[0].joints[1].spring.stiffness: must be given"},
      {"UnknownSpringField", "/chains/0/joints/1/spring", R"({"stiffness": 2, "length": 1})",
       "chains[0].joints[1].spring.length: unknown field, known here are stiffness, rest (1)"},
      {"LinkWithoutGeometry", "/base/geometry", "[]",
       "base.geometry: a link needs at least one triangle ([])"},
      {"UnknownGeometryName", "/base/geometry", R"("bat")",
       R"(base.geometry: no geometry of this name in "geometries" ("bat"))"},
      {"LinkOfAnotherChain", "/chains/1/links/0/joint", R"("elbow")",
       R"(chains[1].links[0].joint: no joint of this name in the link's chain ("elbow"))"},
      {"UnknownShape", "/geometries/bar/0/shape", R"("torus")",
       "geometries.bar[0].shape: unknown shape, known are box, cylinder, sphere, capsule, "
       "prism, loft, hull and triangles "
       R"(("torus"))"},
      {"FlatBox", "/geometries/bar/0/size", "[10, 0, 4]",
       "geometries.bar[0].size: each must be above 0 and at most 1e6 in SI units ([10,0,4])"},
      {"FieldOfAnotherShape", "/geometries/bar/0/radius", "3",
       "geometries.bar[0].radius: unknown field, known here are shape, size, pose (3)"},
      {"CrossedProfile", "/base/geometry",
       R"([{"shape": "prism", "profile": [[0,0],[1,1],[1,0],[0,2]], "sweep": [0, 1]}])",
       "base.geometry[0].profile: "},
      {"SweepWrongWayRound", "/base/geometry",
       R"([{"shape": "prism", "profile": [[0,0],[1,0],[0,1]], "sweep": [1, 0]}])",
       "base.geometry[0].sweep: must be two numbers, the lower one first ([1,0])"},
      {"UnknownPlane", "/base/geometry",
       R"([{"shape": "prism", "plane": "xz", "profile": [[0,0],[1,0],[0,1]], "sweep": [0, 1]}])",
       R"(base.geometry[0].plane: unknown plane, known are xy, yz and zx ("xz"))"},
      {"OneSection", "/base/geometry",
       R"([{"shape": "loft", "sections": [{"at": 0, "profile": [[0,0],[1,0],[0,1]]}]}])",
       "base.geometry[0].sections: must be at least two"},
      {"SectionTheOtherWayRound", "/base/geometry",
       R"([{"shape": "loft", "sections": [{"at": 0, "profile": [[0,0],[1,0],[0,1]]},
                                          {"at": 1, "profile": [[0,0],[0,1],[1,0]]}]}])",
       "base.geometry[0].sections[1].profile: runs the other way round than the first section ("},
      {"UnequalSections", "/base/geometry",
       R"([{"shape": "loft", "sections": [{"at": 0, "profile": [[0,0],[1,0],[0,1]]},
                                          {"at": 1, "profile": [[0,0],[1,0],[1,1],[0,1]]}]}])",
       "base.geometry[0].sections: must have as many corners as the first one"},
      {"FlatHull", "/base/geometry",
       R"([{"shape": "hull", "points": [[0,0,1], [1,0,1], [0,1,1], [1,1,1], [2,3,1]]}])",
       "base.geometry[0].points: must be at least four points that are not in one plane"},
      {"HullOfThreePoints", "/base/geometry",
       R"([{"shape": "hull", "points": [[0,0,1], [1,0,1], [0,1,1]]}])",
       "base.geometry[0].points: must be at least four points that are not in one plane"},
      {"PointOfTwoNumbers", "/base/geometry",
       R"([{"shape": "hull", "points": [[0,0,1], [1,0,1], [0,1,1], [0,0]]}])",
       "base.geometry[0].points[3]: "},
      {"ThinCapsule", "/base/geometry",
       R"([{"shape": "capsule", "radius": 0, "from": [0, 0, 0], "to": [0, 0, 1]}])",
       "base.geometry[0].radius: must be above 0 and at most 1e6 in SI units (0)"},
      {"TooFewSides", "/base/geometry",
       R"([{"shape": "cylinder", "radius": 1, "height": 1, "sides": 2}])",
       "base.geometry[0].sides: must be 3 to 360 (2)"},
      {"MissingMesh", "/base/geometry", R"([{"mesh": "absent.obj"}])", "base.geometry[0].mesh: "},
      {"TwoStepsInOne", "/chains/1/base", R"([{"rotate_x": 1, "rotate_y": 2}])",
       "chains[1].base[0]: must be one translation or one rotation "},
      {"ZeroApproach", "/hand/approach", "[0, 0, 0]",
       "hand.approach: must not be the zero vector ([0,0,0])"},
      {"ClosingAlongApproach", "/hand/closing", "[0, 1, 1]",
       "hand.closing: must be orthogonal to the approach axis ([0,1,1])"},
      {"AcrossUnknownJoint", "/dofs/0/drives/0/across", R"("knee")",
       R"(dofs[0].drives[0].across: no joint of this name ("knee"))"},
      {"AheadOfNoJoint", "/dofs/0/drives/0/ahead", "2",
       "dofs[0].drives[0].ahead: says how far it goes ahead across a joint: add across (2)"},
      {"RatioZeroAcrossNothing", "/dofs/0/drives/0/ratio", "0",
       "dofs[0].drives[0].ratio: its size "},
      {"StrategyOfUnknownDof", "/hand/strategies", R"([{"name": "a", "first": ["thumb"]}])",
       "hand.strategies[0].first[0]: no degree of freedom is called thumb (\"thumb\")"},
      {"StrategyWithoutEffort", "/hand/strategies", R"([{"name": "a", "effort": 0}])",
       "hand.strategies[0].effort: must be above 0 and at most 1 (0)"},
      {"StrategyThatIsNone", "/hand/strategies", R"([{"name": "a"}])",
       "hand.strategies[0]: closes all at once, as every hand does: needs first, waits or effort "},
      {"StrategyTwice", "/hand/strategies",
       R"([{"name": "a", "waits": true}, {"name": "a", "effort": 0.5}])",
       R"(hand.strategies[1].name: name used twice ("a"))"},
      {"NoPreshape", "/hand/preshapes", "[]",
       "hand.preshapes: a hand needs at least one preshape ([])"},
      {"PreshapeOutsideLimits", "/hand/preshapes/0/dofs/grip", "40.5",
       "hand.preshapes[0].dofs.grip: outside the degree of freedom's limits 0.000000 to 0.040000 "
       "rad or m (40.5)"},
      {"PreshapeOfUnknownDof", "/hand/preshapes/0/dofs/thumb", "1",
       "hand.preshapes[0].dofs.thumb: no degree of freedom is called thumb (1)"},
      {"WidthWrongWayRound", "/hand/preshapes/0/width", "[80, 0]",
       "hand.preshapes[0].width: must be two numbers, the lower one first ([80,0])"},
      {"NegativeDepth", "/hand/preshapes/0/depth", "-1",
       "hand.preshapes[0].depth: must be at least 0 and at most 1e6 in SI units (-1)"},
  };
}

class BadRobotField : public testing::TestWithParam<BadField> {};

TEST_P(BadRobotField, IsNamed) {
  Json robot = small_robot();
  const Json::json_pointer pointer(GetParam().pointer);
  if (GetParam().value == "REMOVE") {
    robot.at(pointer.parent_pointer()).erase(pointer.back());
  } else {
    robot[pointer] = Json::parse(GetParam().value);
  }
  const std::string complaint = complaint_about(write_robot_text(robot.dump(1)));
  EXPECT_EQ(complaint.rfind(GetParam().complaint, 0), 0U)
      << "expected: " << GetParam().complaint << "\ngot:      " << complaint;
}

INSTANTIATE_TEST_SUITE_P(Fields, BadRobotField, testing::ValuesIn(bad_fields()),
                         [](const auto& one) { return one.param.label; });

TEST(BadRobotFile, SyntaxErrorNamesTheLine) {
  const std::string complaint =
      complaint_about(write_robot_text("{\n \"name\": \"x\",\n \"units\": {,}\n}\n"));
  EXPECT_EQ(complaint.rfind("line 3: ", 0), 0U) << complaint;
}

TEST(BadRobotFile, EndingTooEarlyNamesTheLastLine) {
  const std::string complaint = complaint_about(write_robot_text("{\n \"name\": \"x\",\n"));
  EXPECT_EQ(complaint.rfind("line 3: ", 0), 0U) << complaint;
}

TEST(BadRobotFile, EmptyFile) {
  EXPECT_EQ(complaint_about(write_robot_text("")).rfind("cannot be read: the file is empty", 0),
            0U);
}

TEST(BadRobotFile, FieldGivenTwice) {
  EXPECT_EQ(complaint_about(write_robot_text(R"({"name": "x", "base": {"a": 1, "a": 2}})")),
            "a: must be given once in an object");
}

TEST(BadRobotFile, NumberTooLargeForADouble) {
  const std::string complaint = complaint_about(write_robot_text("{\"name\": 1e999}"));
  EXPECT_NE(complaint.find("1e999"), std::string::npos) << complaint;
}

TEST(BadRobotFile, NotAnObject) {
  EXPECT_EQ(complaint_about(write_robot_text("[1, 2]")), "must be an object ([1,2])");
}

TEST(BadRobotFile, Absent) {
  EXPECT_EQ(complaint_about(std::filesystem::path(testing::TempDir()) / "absent.json"),
            "cannot be read: no such file");
}

TEST(BadRobotFile, Folder) {
  EXPECT_EQ(complaint_about(testing::TempDir()), "cannot be read: is a folder");
}

TEST(BadRobotFile, LongValuesAreCutShort) {
  Json robot = small_robot();
  robot["name"] = std::vector<int>(1000, 7);
  EXPECT_LT(complaint_about(write_robot_text(robot.dump())).size(), 150U);
}

}  // namespace
}  // namespace prehend
