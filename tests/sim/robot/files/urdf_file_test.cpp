#include "sim/robot/files/urdf_file.h"

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "sim/base/index.h"
#include "sim/robot/files/robot_file.h"
#include "sim/robot/sound_robot.h"
#include "tests/sim/robot/files/foreign_files.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

using test::box_link;
using test::foreign_complaint;
using test::has_note;
using test::kLimit;
using test::read_text;
using test::urdf;
using test::urdf_joint;
using test::write_text;

constexpr double kRounding = 1e-12;

// A palm with two fingers, one of which mimics the other, and a frame without geometry.
std::string gripper() {
  return urdf(box_link("palm", "0.1 0.02 0.02") + box_link("left") + box_link("right") +
              "<link name=\"frame\"/>\n" +
              urdf_joint("slide_left", "prismatic", "frame", "left",
                         "<origin xyz=\"0.1 0 0\"/><axis xyz=\"0 2 0\"/><limit lower=\"0\" "
                         "upper=\"0.04\" effort=\"20\" velocity=\"0.2\"/><dynamics "
                         "damping=\"0.3\" friction=\"0.1\"/>") +
              urdf_joint("slide_right", "prismatic", "frame", "right",
                         "<origin xyz=\"0.1 0 0\"/><axis xyz=\"0 -1 0\"/><limit lower=\"0\" "
                         "upper=\"0.04\"/><mimic joint=\"slide_left\"/>") +
              urdf_joint("fixed", "fixed", "palm", "frame",
                         "<origin xyz=\"0 0 0.5\" rpy=\"0 0 1.5707963267948966\"/>"));
}

TEST(UrdfFile, JointsDriveTheirMimics) {
  const Robot robot = read_text(gripper()).robots.at(0).robot;
  EXPECT_EQ(robot.name, "made");
  ASSERT_EQ(robot.joints.size(), 2U);
  ASSERT_EQ(robot.dofs.size(), 1U);
  EXPECT_EQ(robot.dofs[0].name, "slide_left");
  EXPECT_EQ(robot.dofs[0].coupling, Coupling::self_centering);
  EXPECT_EQ(robot.dofs[0].max_velocity, 0.2);
  EXPECT_EQ(robot.joints[0].max_effort, 20.0);
  EXPECT_EQ(robot.joints[0].friction.viscous, 0.3);
  EXPECT_EQ(robot.joints[0].friction.coulomb, 0.1);
  EXPECT_EQ(robot.joints[1].max_effort, 0.0);
  EXPECT_FALSE(robot.hand);
  require_sound(robot);
  EXPECT_TRUE(has_note(robot, "frame"));
  EXPECT_TRUE(has_note(robot, "plastic"));
}

// The frame is turned by 90 degrees about z: y of the joint becomes -x of the palm.
TEST(UrdfFile, FixedJointsMoveWhatHangsOnThem) {
  const Robot robot = read_text(gripper()).robots.at(0).robot;
  ASSERT_EQ(robot.links.size(), 3U);
  std::vector<Pose> X_BL;
  link_poses(robot, joint_values(robot, {0.03}), X_BL);
  const Vector3 left = X_BL[1].translation();
  const Vector3 right = X_BL[2].translation();
  EXPECT_LT((left - Vector3(-0.03, 0.1, 0.5)).norm(), kRounding);
  EXPECT_LT((right - Vector3(0.03, 0.1, 0.5)).norm(), kRounding);
}

TEST(UrdfFile, MimicsOfMimicsComposeAndNarrowLimits) {
  const auto mimicking = [](const std::string& name, const std::string& child,
                            const std::string& mimic) {
    return urdf_joint(name, "revolute", "base", child, kLimit + mimic);
  };
  const Robot robot =
      read_text(
          urdf(box_link("base") + box_link("a") + box_link("b") + box_link("c") +
               mimicking("c", "c", "<mimic joint=\"b\" multiplier=\"-2\" offset=\"0.5\"/>") +
               mimicking("b", "b", "<mimic joint=\"a\" multiplier=\"0.5\" offset=\"0.25\"/>") +
               mimicking("a", "a", "")))
          .robots.at(0)
          .robot;
  ASSERT_EQ(robot.dofs.size(), 1U);
  EXPECT_EQ(robot.dofs[0].name, "a");
  // c = -2 (0.5 a + 0.25) + 0.5 = -a, so that -1 <= -a <= 2 as well as -1 <= a <= 2.
  EXPECT_NEAR(robot.dofs[0].lower, -1.0, kRounding);
  EXPECT_NEAR(robot.dofs[0].upper, 1.0, kRounding);
  for (const Joint& joint : robot.joints) {
    const double value = joint.ratio * 0.8 + joint.offset;
    const double wanted = joint.name == "a" ? 0.8 : joint.name == "b" ? 0.65 : -0.8;
    EXPECT_NEAR(value, wanted, kRounding) << joint.name;
  }
}

TEST(UrdfFile, BranchesBecomeChains) {
  // base - a - b, b - c - d and b - e.
  std::string text;
  for (const char* name : {"base", "a", "b", "c", "d", "e"}) text += box_link(name);
  text += urdf_joint("jd", "revolute", "c", "d", kLimit);
  text += urdf_joint("ja", "revolute", "base", "a", kLimit);
  text += urdf_joint("jb", "revolute", "a", "b", kLimit);
  text += urdf_joint("jc", "revolute", "b", "c", kLimit);
  text += urdf_joint("je", "revolute", "b", "e", kLimit);
  const Robot robot = read_text(urdf(text)).robots.at(0).robot;
  require_sound(robot);
  ASSERT_EQ(robot.chains.size(), 3U);
  EXPECT_EQ(robot.chains[0].name, "b");
  EXPECT_EQ(robot.chains[1].name, "d");
  EXPECT_EQ(robot.chains[2].name, "e");
  EXPECT_EQ(robot.chains[1].joint_count, 2);
  EXPECT_EQ(robot.joints[index(robot.chains[2].first_joint)].parent, 1);
}

TEST(UrdfFile, ContinuousJointsTurnOnceToEitherSide) {
  const Robot robot = read_text(urdf(box_link("base") + box_link("wheel") +
                                     urdf_joint("turn", "continuous", "base", "wheel")))
                          .robots.at(0)
                          .robot;
  EXPECT_EQ(robot.dofs[0].upper, 2.0 * std::numbers::pi);
  EXPECT_TRUE(has_note(robot, "turn"));
}

TEST(UrdfFile, ShapesHaveTheirSizes) {
  const std::string origin = "<origin xyz=\"1 2 3\" rpy=\"0.3 -0.4 0.5\"/>";
  const auto volume_of = [&](const std::string& shape) {
    const Robot robot = read_text(urdf("<link name=\"base\"><collision>" + origin + "<geometry>" +
                                       shape + "</geometry></collision></link>" + box_link("tip") +
                                       urdf_joint("j", "revolute", "base", "tip", kLimit)))
                            .robots.at(0)
                            .robot;
    return inertial_of_density(robot.links[0].mesh, 1.0);
  };
  const double pi = std::numbers::pi;
  const Inertial box = volume_of("<box size=\"0.1 0.2 0.3\"/>");
  EXPECT_NEAR(box.mass, 0.006, kRounding);
  EXPECT_LT((box.center_of_mass - Vector3(1.0, 2.0, 3.0)).norm(), 1e-9);
  // Polyhedra with corners on the surface: a few percent less than the solid.
  EXPECT_NEAR(volume_of("<sphere radius=\"0.5\"/>").mass / (pi / 6.0), 0.97, 0.03);
  EXPECT_NEAR(volume_of("<cylinder radius=\"0.5\" length=\"2\"/>").mass / (0.5 * pi), 0.98, 0.02);
  EXPECT_NEAR(volume_of("<capsule radius=\"0.5\" length=\"2\"/>").mass / (0.5 * pi + pi / 6.0),
              0.96, 0.04);
}

// R = Rz(yaw) Ry(pitch) Rx(roll).
TEST(UrdfFile, AnglesTurnAboutFixedAxes) {
  const Robot robot =
      read_text(urdf(box_link("base") + box_link("tip") +
                     urdf_joint("j", "revolute", "base", "tip",
                                std::string("<origin rpy=\"0.3 -0.4 0.5\"/>") + kLimit)))
          .robots.at(0)
          .robot;
  const double c = std::cos(-0.4);
  const Matrix3 R = robot.joints[0].X_PJ.linear();
  EXPECT_NEAR(R(2, 0), -std::sin(-0.4), kRounding);
  EXPECT_NEAR(R(2, 1), c * std::sin(0.3), kRounding);
  EXPECT_NEAR(R(1, 0), c * std::sin(0.5), kRounding);
}

TEST(UrdfFile, MeshesAreScaledAndFoundInPackages) {
  const std::filesystem::path folder = test::test_folder();
  write_text(folder / "my_hand/meshes/cube.obj", test::kUnitCubeObj);
  const auto text = [](const std::string& uri, const std::string& more = "") {
    return urdf(
        "<link name=\"base\"><visual><geometry><mesh filename=\"missing.dae\"/>"
        "</geometry></visual><collision><geometry><mesh filename=\"" +
        uri + "\" scale=\"0.1 -0.2 0.3\"/></geometry></collision></link>" + box_link("tip") +
        urdf_joint("j", "revolute", "base", "tip", kLimit) + more);
  };
  const auto base_of = [&](const std::filesystem::path& file, const std::string& uri,
                           const ForeignRobotOptions& options = {}) {
    const auto platform = read_foreign_robot(write_text(file, text(uri)), options);
    return platform->robots.at(0).robot.links.at(0).mesh;
  };
  const std::filesystem::path inside = folder / "my_hand/urdf/hand.urdf";
  for (const char* uri : {"package://my_hand/meshes/cube.obj", "../meshes/cube.obj",
                          "package://renamed/meshes/cube.obj"}) {
    const TriangleMesh mesh = base_of(inside, uri);
    EXPECT_LT((bounds(mesh).size() - Vector3(0.1, 0.2, 0.3)).norm(), 1e-6) << uri;
    // Mirrored, its triangles still face outward.
    EXPECT_NEAR(inertial_of_density(mesh, 1.0).mass, 0.006, 1e-6) << uri;
  }
  const std::filesystem::path elsewhere = test::test_folder().string() + "_else/hand.urdf";
  write_text(folder / "my_hand/meshes/cube.obj", test::kUnitCubeObj);
  const ForeignRobotOptions packages{.packages = {{"my_hand", folder / "my_hand"}}};
  EXPECT_FALSE(base_of(elsewhere, "package://my_hand/meshes/cube.obj", packages).empty());
  try {
    (void)base_of(elsewhere, "package://my_hand/meshes/cube.obj");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("--package my_hand=FOLDER"), std::string::npos)
        << error.what();
  }
}

TEST(UrdfFile, VisualGeometryStandsInForCollisionGeometry) {
  const Robot robot =
      read_text(urdf("<link name=\"base\"><visual><geometry><box size=\"1 1 1\"/></geometry>"
                     "</visual></link>" +
                     box_link("tip") + urdf_joint("j", "revolute", "base", "tip", kLimit)))
          .robots.at(0)
          .robot;
  EXPECT_EQ(robot.links[0].mesh.triangles.size(), 12U);
  EXPECT_TRUE(has_note(robot, "visual geometry is used: base"));
}

TEST(UrdfFile, InertiaIsGivenInTheFrameOfTheLink) {
  const auto base = [](const std::string& moments) {
    return read_text(urdf("<link name=\"base\"><inertial><origin xyz=\"0.1 0 0\" "
                          "rpy=\"0 0 1.5707963267948966\"/><mass value=\"2\"/><inertia " +
                          moments +
                          "/></inertial><collision><geometry><box size=\"1 1 1\"/></geometry>"
                          "</collision></link>" +
                          box_link("tip") + urdf_joint("j", "revolute", "base", "tip", kLimit)))
        .robots.at(0)
        .robot;
  };
  const Robot robot = base("ixx=\"1\" iyy=\"2\" izz=\"2.5\" ixy=\"0\" ixz=\"0\" iyz=\"0\"");
  const Inertial& inertial = robot.links[0].inertial;
  EXPECT_EQ(inertial.mass, 2.0);
  EXPECT_LT((inertial.center_of_mass - Vector3(0.1, 0.0, 0.0)).norm(), kRounding);
  EXPECT_NEAR(inertial.inertia(0, 0), 2.0, kRounding);
  EXPECT_NEAR(inertial.inertia(1, 1), 1.0, kRounding);
  EXPECT_EQ(robot.links[1].inertial.mass, 0.0);
  // No body has these moments: those of the box of 2 kg take their place, 2/12 (1 + 1).
  const Robot other = base("ixx=\"1\" iyy=\"1\" izz=\"9\"");
  EXPECT_NEAR(other.links[0].inertial.inertia(0, 0), 1.0 / 3.0, 1e-9);
  EXPECT_TRUE(has_note(other, "inertia that no body has"));
}

TEST(UrdfFile, FilterGroupsOfDrakeExemptPairs) {
  std::string text = box_link("base") + box_link("a") + box_link("b");
  text += urdf_joint("ja", "revolute", "base", "a", kLimit);
  text += urdf_joint("jb", "revolute", "base", "b", kLimit);
  text +=
      "<drake:collision_filter_group name=\"g\"><drake:member link=\"a\"/><drake:member "
      "link=\"b\"/><drake:ignored_collision_filter_group name=\"g\"/>"
      "</drake:collision_filter_group>";
  const Robot robot = read_text(urdf(text)).robots.at(0).robot;
  EXPECT_EQ(robot.exempt_pairs, (std::vector<std::pair<int, int>>{{1, 2}}));
}

TEST(UrdfFile, SomeBaseIsThere) {
  const Robot robot = read_text(urdf("<link name=\"world\"/>" + box_link("tip") +
                                     urdf_joint("j", "revolute", "world", "tip", kLimit)))
                          .robots.at(0)
                          .robot;
  EXPECT_EQ(robot.links[0].name, "world");
  EXPECT_EQ(robot.links[0].joint, -1);
  EXPECT_TRUE(has_note(robot, "cube of 1 mm"));
}

TEST(UrdfFile, UnreadElementsAreNoted) {
  const Robot robot = read_text(urdf(box_link("base") + box_link("tip") + "<colision/>\n" +
                                     urdf_joint("j", "revolute", "base", "tip", kLimit)))
                          .robots.at(0)
                          .robot;
  EXPECT_TRUE(has_note(robot, "line 4, <colision>: is not read"));
}

TEST(UrdfFile, DetailsDoNotRefuseTheRobot) {
  const std::string flat =
      "<link name=\"a\"><collision><geometry><cylinder radius=\"0.01\" length=\"0\"/></geometry>"
      "</collision><collision><geometry><sphere radius=\"0.01\"/></geometry></collision></link>\n";
  const Robot robot = read_text(urdf(box_link("base") + flat + box_link("b") +
                                     urdf_joint("ja", "revolute", "base", "a",
                                                "<limit lower=\"-inf\" upper=\"1\" effort=\"inf\" "
                                                "velocity=\"2\"/>") +
                                     urdf_joint("jb", "prismatic", "base", "b",
                                                std::string(kLimit) + "<mimic joint=\"ja\"/>")))
                          .robots.at(0)
                          .robot;
  ASSERT_EQ(robot.dofs.size(), 2U);
  EXPECT_NEAR(robot.dofs[0].lower, -2.0 * std::numbers::pi, kRounding);
  EXPECT_EQ(robot.dofs[0].upper, 1.0);
  EXPECT_EQ(robot.joints[0].max_effort, 0.0);
  EXPECT_EQ(robot.dofs[0].max_acceleration, 4.0);
  EXPECT_TRUE(has_note(robot, "infinite limits"));
  EXPECT_TRUE(has_note(robot, "length is 0: the shape is left out"));
  EXPECT_TRUE(has_note(robot, "a joint of another type: left out"));
  EXPECT_TRUE(has_note(robot, "accelerations are not in the file"));
}

// Signs of limits and multiplier that do not fit each other.
TEST(UrdfFile, LimitsOfAFollowerDoNotCancelTheDrive) {
  const char* limit = "<limit lower=\"0\" upper=\"0.04\" effort=\"1\" velocity=\"1\"/>";
  const Robot robot =
      read_text(urdf(box_link("base") + box_link("a") + box_link("b") +
                     urdf_joint("ja", "prismatic", "base", "a", limit) +
                     urdf_joint("jb", "prismatic", "base", "b",
                                std::string(limit) + "<mimic joint=\"ja\" multiplier=\"-1\"/>")))
          .robots.at(0)
          .robot;
  EXPECT_EQ(robot.dofs[0].lower, 0.0);
  EXPECT_EQ(robot.dofs[0].upper, 0.04);
  EXPECT_EQ(robot.joints[1].lower, -0.04);
  EXPECT_TRUE(has_note(robot, "joint jb: its limits leave"));
}

// Drawn in millimetres, in a file with a blank in its name, beside one without triangles.
TEST(UrdfFile, MeshesOfPartsAreReadAsTheyAreMeant) {
  const std::filesystem::path folder = test::test_folder();
  write_text(folder / "a part.obj", "v 0 0 0\nv 20 0 0\nv 0 20 0\nf 1 2 3\n");
  write_text(folder / "empty.stl", "solid\nendsolid\n");
  const auto mesh = [](const std::string& name) {
    return "<collision><geometry><mesh filename=\"" + name + "\"/></geometry></collision>";
  };
  const std::filesystem::path file =
      write_text(folder / "made.urdf", urdf("<link name=\"base\">" + mesh("a%20part.obj") +
                                            mesh("empty.stl") + "</link>\n" + box_link("a") +
                                            urdf_joint("ja", "revolute", "base", "a", kLimit)));
  const Robot robot = load_robot(file);
  EXPECT_NEAR(bounds(robot.links[0].mesh).upper.x(), 0.02, kRounding);
  EXPECT_TRUE(has_note(robot, "is 20 long without a scale: read in mm"));
  EXPECT_TRUE(has_note(robot, "empty.stl has no triangles: it is left out"));
}

TEST(UrdfFile, TipsOfFingersAreOfRubberWhereNothingIsSaid) {
  const Robot robot = read_text(gripper()).robots.at(0).robot;
  for (const Link& link : robot.links) {
    EXPECT_EQ(link.material, link.name == "palm" ? "plastic" : "rubber") << link.name;
  }
}

// The whole file in mm, as a sidecar says it.
TEST(UrdfFile, LengthsAreScaledTogether) {
  const std::string text =
      urdf(box_link("base", "60 60 60") + box_link("a", "20 20 20", "0 0 10") +
           "<link name=\"b\"><inertial><origin xyz=\"0 0 5\"/><mass value=\"2\"/><inertia "
           "ixx=\"8\" iyy=\"8\" izz=\"8\"/></inertial><collision><geometry><sphere "
           "radius=\"4\"/></geometry></collision></link>\n" +
           urdf_joint("slide", "prismatic", "base", "a",
                      "<origin xyz=\"0 0 30\"/><limit lower=\"-5\" upper=\"40\" effort=\"3\" "
                      "velocity=\"100\"/>") +
           urdf_joint("turn", "revolute", "a", "b", kLimit));
  const std::filesystem::path folder = test::test_folder();
  const std::filesystem::path file = write_text(folder / "made.urdf", text);
  write_text(folder / "made.prehend.json", R"({"scale": 0.001})");
  const Robot robot = load_robot(file);
  EXPECT_NEAR(robot.joints[0].X_PJ.translation().z(), 0.03, kRounding);
  EXPECT_NEAR(robot.dofs[0].lower, -0.005, kRounding);
  EXPECT_NEAR(robot.dofs[0].upper, 0.04, kRounding);
  EXPECT_NEAR(robot.dofs[0].max_velocity, 0.1, kRounding);
  EXPECT_EQ(robot.joints[0].max_effort, 3.0);
  EXPECT_EQ(robot.dofs[1].upper, 2.0);
  EXPECT_NEAR(bounds(robot.links[0].mesh).size().x(), 0.06, kRounding);
  EXPECT_EQ(robot.links[2].inertial.mass, 2.0);
  EXPECT_NEAR(robot.links[2].inertial.center_of_mass.z(), 0.005, kRounding);
  EXPECT_NEAR(robot.links[2].inertial.inertia(0, 0), 8e-6, kRounding);
  EXPECT_TRUE(has_note(robot, "multiplied by 0.001"));
  // What the caller says comes first.
  EXPECT_NEAR(load_robot(file, {.scale = 0.01}).dofs[0].upper, 0.4, kRounding);
}

TEST(UrdfFile, SaysWhatStandsForAFile) {
  const std::filesystem::path folder = test::test_folder();
  const auto complaint = [&](const std::string& text) {
    return test::refusal_of([&] { load_robot(write_text(folder / "made.urdf", text)); }).problem();
  };
  EXPECT_NE(
      complaint("version https://git-lfs.github.com/spec/v1\noid sha256:0\n").find("lfs pull"),
      std::string::npos);
  EXPECT_NE(complaint("<!DOCTYPE html>\n<html></html>\n").find("a web page"), std::string::npos);
  EXPECT_NE(complaint("\xFF\xFE<").find("UTF-16"), std::string::npos);
  const std::string sound =
      urdf(box_link("base") + box_link("a") + urdf_joint("ja", "revolute", "base", "a", kLimit));
  EXPECT_EQ(load_robot(write_text(folder / "made.urdf", "\xEF\xBB\xBF" + sound)).joints.size(), 1U);
}

struct BadUrdf {
  const char* name;
  std::string text;
  const char* complaint;
};

class UrdfFileErrors : public testing::TestWithParam<BadUrdf> {};

TEST_P(UrdfFileErrors, AreOneLineWithTheirPlace) {
  EXPECT_EQ(foreign_complaint(GetParam().text), GetParam().complaint);
}

std::string two(const std::string& joint) {
  return urdf(box_link("base") + box_link("tip") + joint);
}

INSTANTIATE_TEST_SUITE_P(
    Files, UrdfFileErrors,
    testing::Values(
        BadUrdf{"NotClosed", "<robot name=\"made\">\n<link name=\"a\">\n</robot>",
                "line 2: a tag is closed that is not open, or stays open"},
        BadUrdf{"Entities", "<!DOCTYPE r [<!ENTITY a \"aa\">]>\n<robot name=\"&a;\"/>",
                "line 1: entities must not be defined here"},
        BadUrdf{"OtherRoot", "<COLLADA/>",
                "line 1, <COLLADA>: no robot that can be read; known are URDF (<robot>), MJCF "
                "(<mujoco>), SDF (<sdf>), OpenRAVE (<Robot>, <KinBody>), GraspIt! robots (<robot> "
                "with <palm>) and worlds (<world>)"},
        BadUrdf{"Empty", urdf(""), "there is no link"},
        BadUrdf{"NothingMoves", urdf(box_link("base")), "no joint moves (made)"},
        BadUrdf{"MissingLink", two(urdf_joint("j", "revolute", "base", "tpi", kLimit)),
                "line 4, <child>: no link of this name (tpi)"},
        BadUrdf{"NoParent", two("<joint name=\"j\" type=\"fixed\"><child link=\"tip\"/></joint>"),
                "line 4, <joint>: <parent> is missing inside"},
        BadUrdf{
            "TwoRoots",
            two("<link name=\"other\"/>\n" + urdf_joint("j", "revolute", "base", "tip", kLimit)),
            "line 4, <link>: hangs on no joint, nor does base: a robot has one root (other)"},
        BadUrdf{"TwoParents",
                urdf(box_link("base") + box_link("a") + box_link("b") +
                     urdf_joint("ja", "revolute", "base", "a", kLimit) +
                     urdf_joint("jb", "revolute", "base", "b", kLimit) +
                     urdf_joint("jc", "revolute", "a", "b", kLimit)),
                "line 7, <joint>: link b hangs on joint jb already (jc)"},
        BadUrdf{"Circle",
                urdf(box_link("base") + box_link("a") + box_link("b") + box_link("tip") +
                     urdf_joint("ja", "revolute", "a", "b", kLimit) +
                     urdf_joint("jb", "revolute", "b", "a", kLimit) +
                     urdf_joint("jc", "revolute", "base", "tip", kLimit)),
                "line 3, <link>: its joints form a circle: each link must hang on one joint, but "
                "for one (a)"},
        BadUrdf{"AllACircle",
                two(urdf_joint("ja", "revolute", "base", "tip", kLimit) +
                    urdf_joint("jb", "revolute", "tip", "base", kLimit)),
                "line 2, <link>: its joints form a circle: each link must hang on one joint, but "
                "for one (base)"},
        BadUrdf{"Floating", two(urdf_joint("j", "floating", "base", "tip")),
                "line 4, <joint>: joints of type floating cannot be planned with; write them as "
                "revolute and prismatic joints (j)"},
        BadUrdf{"UnknownType", two(urdf_joint("j", "hinge", "base", "tip")),
                "line 4, <joint>: unknown joint type, known are revolute, continuous, prismatic "
                "and fixed (hinge)"},
        BadUrdf{"NoLimit", two(urdf_joint("j", "revolute", "base", "tip")),
                "line 4, <joint>: <limit> is missing inside (j)"},
        BadUrdf{
            "SwappedLimits",
            two(urdf_joint("j", "revolute", "base", "tip", "<limit lower=\"1\" upper=\"-1\"/>")),
            "line 4, <limit>: the lower limit must be at most the upper one (j)"},
        BadUrdf{
            "Nan",
            two(urdf_joint("j", "revolute", "base", "tip", "<limit lower=\"nan\" upper=\"1\"/>")),
            "line 4, <limit>: attribute lower must be a number, at most 1e30 in size (nan)"},
        BadUrdf{"NoAxis",
                two(urdf_joint("j", "revolute", "base", "tip",
                               std::string("<axis xyz=\"0 0 0\"/>") + kLimit)),
                "line 4, <axis>: must not be 0 (0 0 0)"},
        BadUrdf{
            "MimicsItself",
            two(urdf_joint("j", "revolute", "base", "tip",
                           std::string(kLimit) + "<mimic joint=\"j\"/>")),
            "line 4, <joint>: mimics itself: it must follow a joint that does not follow it (j)"},
        BadUrdf{"MimicsNobody",
                two(urdf_joint("j", "revolute", "base", "tip",
                               std::string(kLimit) + "<mimic joint=\"k\"/>")),
                "line 4, <mimic>: no joint of this name (k)"},
        BadUrdf{
            "MimicCircle",
            urdf(box_link("base") + box_link("a") + box_link("b") +
                 urdf_joint("ja", "revolute", "base", "a",
                            std::string(kLimit) + "<mimic joint=\"jb\" multiplier=\"3\"/>") +
                 urdf_joint("jb", "revolute", "base", "b",
                            std::string(kLimit) + "<mimic joint=\"ja\"/>")),
            "line 5, <joint>: mimics itself: it must follow a joint that does not follow it (ja)"},
        BadUrdf{"MissingMesh",
                urdf("<link name=\"base\"><collision><geometry>\n<mesh filename=\"no.stl\"/>"
                     "</geometry></collision></link>"),
                "line 3, <mesh>: no such file: it must be there, relative to this one (no.stl)"},
        BadUrdf{"UnknownShape",
                urdf("<link name=\"base\"><collision><geometry>\n<cone radius=\"1\"/>"
                     "</geometry></collision></link>"),
                "line 3, <cone>: unknown shape, known are mesh, box, cylinder, sphere, capsule "
                "and ellipsoid"},
        BadUrdf{"SameName", urdf(box_link("base") + box_link("base")),
                "line 3, <link>: name used twice (base)"},
        BadUrdf{"FarAway",
                two(urdf_joint("j", "revolute", "base", "tip",
                               std::string("<origin xyz=\"1e9 0 0\"/>") + kLimit)),
                "line 4, <origin>: is farther away than 1e6 m (1e9 0 0)"},
        BadUrdf{"NegativeMass",
                urdf("<link name=\"base\"><inertial><mass value=\"-1\"/></inertial></link>"),
                "line 2, <mass>: must not be negative (-1)"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace prehend
