#include "sim/robot/files/mjcf_file.h"

#include <cmath>
#include <numbers>

#include "sim/base/index.h"
#include "tests/sim/robot/files/foreign_files.h"

namespace prehend {
namespace {

using test::foreign_complaint;
using test::has_note;
using test::read_text;
using test::test_folder;
using test::write_text;

constexpr double kExact = 1e-12;
constexpr double kRightAngle = 0.5 * std::numbers::pi;

std::string mjcf(const std::string& inside) {
  return "<mujoco model=\"made\">\n" + inside + "</mujoco>\n";
}

// A palm and what hangs on it.
std::string on_palm(const std::string& inside, const std::string& beside = "") {
  return mjcf(beside +
              "<worldbody><body name=\"palm\" pos=\"0 0 1\"><geom type=\"box\" size=\"0.05 0.05 "
              "0.05\"/>" +
              inside + "</body></worldbody>\n");
}

const char* const kTip = "<geom size=\"0.01\"/>";

Robot robot_of(const std::string& text) { return read_text(text).robots.at(0).robot; }

std::vector<Pose> poses(const Robot& robot, const std::vector<double>& dofs) {
  std::vector<Pose> X_BL;
  link_poses(robot, joint_values(robot, dofs), X_BL);
  return X_BL;
}

TEST(MjcfFile, BodiesBecomeLinksInTheFrameOfTheBase) {
  const Robot robot = robot_of(on_palm(
      std::string(
          "<body name=\"tip\" pos=\"0.1 0 0\" euler=\"0 0 90\"><joint name=\"j\" "
          "axis=\"0 0 2\" range=\"-90 90\" damping=\"0.2\" frictionloss=\"0.1\" stiffness=\"4\" "
          "springref=\"-90\"/>") +
      kTip + "</body>"));
  EXPECT_EQ(robot.name, "made");
  ASSERT_EQ(robot.links.size(), 2U);
  EXPECT_EQ(robot.links[0].name, "palm");
  EXPECT_LT((bounds(robot.links[0].mesh).size() - Vector3(0.1, 0.1, 0.1)).norm(), kExact);
  EXPECT_NEAR(robot.joints[0].upper, kRightAngle, kExact);
  EXPECT_EQ(robot.joints[0].friction.viscous, 0.2);
  EXPECT_EQ(robot.joints[0].friction.coulomb, 0.1);
  EXPECT_EQ(robot.joints[0].spring.stiffness, 4.0);
  EXPECT_NEAR(robot.joints[0].spring.rest, -kRightAngle, kExact);
  const Pose X = poses(robot, {0.3})[1];
  EXPECT_LT((X.translation() - Vector3(0.1, 0.0, 0.0)).norm(), kExact);
  const Matrix3 wanted = Eigen::AngleAxisd(kRightAngle + 0.3, Vector3::UnitZ()).toRotationMatrix();
  EXPECT_LT((X.linear() - wanted).norm(), kExact);
}

// Body frame after joints j_1, j_2 about the points p_1, p_2: the product of
// T(p_i) R(a_i, q_i) T(-p_i), after the frame of the body at rest.
TEST(MjcfFile, SeveralJointsOfABodyTurnAboutTheirPoints) {
  const Robot robot = robot_of(on_palm(
      std::string("<body name=\"tip\" pos=\"0.1 0.2 0.3\"><joint name=\"a\" axis=\"1 0 0\" "
                  "pos=\"0 0.1 0\" range=\"-90 90\"/><joint name=\"b\" axis=\"0 1 0\" pos=\"0.3 0 "
                  "0\" range=\"-90 90\"/><joint name=\"c\" type=\"slide\" axis=\"0 0 1\" "
                  "range=\"-1 1\"/>") +
      kTip + "</body>"));
  ASSERT_EQ(robot.joints.size(), 3U);
  const Vector3 p1(0.0, 0.1, 0.0);
  const Vector3 p2(0.3, 0.0, 0.0);
  const Pose wanted = translation({0.1, 0.2, 0.3}) * translation(p1) *
                      Eigen::AngleAxisd(0.4, Vector3::UnitX()) * translation(-p1) *
                      translation(p2) * Eigen::AngleAxisd(-0.7, Vector3::UnitY()) *
                      translation(-p2) * translation({0.0, 0.0, 0.25});
  const Pose X = poses(robot, {0.4, -0.7, 0.25}).back();
  EXPECT_LT((X.matrix() - wanted.matrix()).norm(), kExact);
}

TEST(MjcfFile, ValuesCountFromTheReference) {
  const Robot robot = robot_of(on_palm(
      std::string("<body name=\"tip\"><joint name=\"a\" axis=\"0 0 1\" ref=\"30\" range=\"0 "
                  "60\"/>") +
      kTip + "</body>"));
  // At its reference the body is as the file shows it.
  EXPECT_LT((poses(robot, {kRightAngle / 3.0})[1].linear() - Matrix3::Identity()).norm(), kExact);
}

TEST(MjcfFile, RotationsInAllSpellings) {
  const auto turned = [](const std::string& words, const std::string& compiler = "") {
    const Robot robot = robot_of(on_palm(
        "<body name=\"tip\" " + words + "><joint name=\"j\" range=\"0 1\"/>" + kTip + "</body>",
        compiler));
    return Matrix3(robot.joints[0].X_PJ.linear());
  };
  const Matrix3 wanted = Eigen::AngleAxisd(0.6, Vector3(1, 2, 2) / 3.0).toRotationMatrix();
  const double s = std::sin(0.3) / 3.0;
  const auto text = [](double value) { return std::to_string(value); };
  EXPECT_LT((turned("quat=\"" + text(2.0 * std::cos(0.3)) + " " + text(2.0 * s) + " " +
                    text(4.0 * s) + " " + text(4.0 * s) + "\"") -
             wanted)
                .norm(),
            1e-5);
  const std::string radian = "<compiler angle=\"radian\"/>\n";
  EXPECT_LT((turned("axisangle=\"1 2 2 0.6\"", radian) - wanted).norm(), kExact);
  const Matrix3 X = Eigen::AngleAxisd(0.1, Vector3::UnitX()).toRotationMatrix();
  const Matrix3 Y = Eigen::AngleAxisd(0.2, Vector3::UnitY()).toRotationMatrix();
  const Matrix3 Z = Eigen::AngleAxisd(0.3, Vector3::UnitZ()).toRotationMatrix();
  EXPECT_LT((turned("euler=\"0.1 0.2 0.3\"", radian) - X * Y * Z).norm(), kExact);
  EXPECT_LT((turned("euler=\"0.1 0.2 0.3\"", "<compiler angle=\"radian\" eulerseq=\"XYZ\"/>\n") -
             Z * Y * X)
                .norm(),
            kExact);
  EXPECT_LT((turned("xyaxes=\"0 2 0 -1 1 0\"") -
             Eigen::AngleAxisd(kRightAngle, Vector3::UnitZ()).toRotationMatrix())
                .norm(),
            kExact);
  EXPECT_LT((turned("zaxis=\"1 2 2\"").col(2) - Vector3(1, 2, 2) / 3.0).norm(), kExact);
}

TEST(MjcfFile, ClassesSayWhatElementsDoNot) {
  const std::string defaults =
      "<default><geom type=\"capsule\" size=\"0.01 0.05\"/><default class=\"thick\"><geom "
      "size=\"0.02 0.05\"/><joint axis=\"0 1 0\" range=\"0 45\"/></default></default>\n";
  const Robot robot = robot_of(
      on_palm("<body name=\"tip\" childclass=\"thick\"><joint name=\"j\"/><geom/></body>"
              "<body name=\"other\"><joint name=\"k\" class=\"thick\" axis=\"1 0 0\"/><geom/>"
              "</body>",
              defaults));
  EXPECT_EQ(robot.joints[0].axis, Vector3::UnitY());
  EXPECT_NEAR(robot.joints[0].upper, 0.5 * kRightAngle, kExact);
  EXPECT_EQ(robot.joints[1].axis, Vector3::UnitX());
  EXPECT_NEAR(bounds(robot.links[1].mesh).size().z(), 0.1 + 2.0 * 0.02, kExact);
  EXPECT_NEAR(bounds(robot.links[2].mesh).size().z(), 0.1 + 2.0 * 0.01, kExact);
}

TEST(MjcfFile, GeomsThatCollideComeFirst) {
  const std::filesystem::path folder = test_folder();
  write_text(folder / "assets/cube.obj", test::kUnitCubeObj);
  const std::filesystem::path file = write_text(
      folder / "made.xml",
      mjcf("<compiler meshdir=\"assets\"/><asset><mesh file=\"cube.obj\" scale=\"0.1 0.2 0.3\"/>"
           "<mesh name=\"gone\" file=\"gone.obj\"/></asset><worldbody><body name=\"palm\">"
           "<geom type=\"mesh\" mesh=\"gone\" contype=\"0\" conaffinity=\"0\"/>"
           "<geom type=\"mesh\" mesh=\"cube\" pos=\"1 0 0\"/>"
           "<body name=\"tip\"><joint name=\"j\" range=\"0 90\"/><geom type=\"capsule\" "
           "size=\"0.01\" fromto=\"0 0 0 0.2 0 0\" contype=\"0\" conaffinity=\"0\"/></body>"
           "</body></worldbody>"));
  const Robot robot = read_foreign_robot(file)->robots.at(0).robot;
  EXPECT_LT((bounds(robot.links[0].mesh).lower - Vector3(1.0, 0.0, 0.0)).norm(), 1e-6);
  EXPECT_LT((bounds(robot.links[0].mesh).size() - Vector3(0.1, 0.2, 0.3)).norm(), 1e-6);
  EXPECT_NEAR(bounds(robot.links[1].mesh).lower.x(), -0.01, kExact);
  EXPECT_NEAR(bounds(robot.links[1].mesh).upper.x(), 0.21, kExact);
}

TEST(MjcfFile, CouplingsDriveJointsTogether) {
  const auto body = [](const std::string& name) {
    return "<body name=\"" + name + "\"><joint name=\"j" + name +
           "\" type=\"slide\" axis=\"0 1 0\" range=\"0 1\"/>" + kTip + "</body>";
  };
  const Robot robot = robot_of(on_palm(
      body("a") + body("b") + body("c") + body("d"),
      "<equality><joint joint1=\"jb\" joint2=\"ja\" polycoef=\"0.1 0.5 0 0 0\"/><weld "
      "body1=\"a\"/></equality><tendon><fixed name=\"t\"><joint joint=\"jc\" coef=\"1\"/><joint "
      "joint=\"jd\" coef=\"1\"/></fixed></tendon><actuator><position tendon=\"t\"/><motor "
      "joint=\"ja\" forcerange=\"-7 5\"/></actuator><contact><exclude body1=\"a\" body2=\"b\"/>"
      "</contact><keyframe><key name=\"home\" qpos=\"0.5 0.35 0.2 0.2\"/></keyframe>\n"));
  ASSERT_EQ(robot.dofs.size(), 2U);
  EXPECT_EQ(robot.joints[1].ratio, 0.5);
  EXPECT_EQ(robot.joints[1].offset, 0.1);
  EXPECT_EQ(robot.joints[3].dof, robot.joints[2].dof);
  EXPECT_EQ(robot.joints[0].max_effort, 7.0);
  EXPECT_EQ(robot.dofs[0].initial, 0.5);
  EXPECT_EQ(robot.dofs[1].initial, 0.2);
  EXPECT_EQ(robot.exempt_pairs, (std::vector<std::pair<int, int>>{{1, 2}}));
  EXPECT_TRUE(has_note(robot, "closed loops"));
  EXPECT_TRUE(has_note(robot, "taken to move alike"));
}

// They speak of the ways from where the file shows the joints (ref).
TEST(MjcfFile, CouplingsCountFromTheReferences) {
  const Robot robot = robot_of(on_palm(
      "<body name=\"a\"><joint name=\"ja\" range=\"-90 90\" ref=\"30\"/><geom "
      "size=\"0.01\"/></body>"
      "<body name=\"b\"><joint name=\"jb\" range=\"-90 90\" ref=\"-10\"/><geom "
      "size=\"0.01\"/></body>",
      "<equality><joint joint1=\"jb\" joint2=\"ja\" polycoef=\"0 0.5 0 0 0\"/></equality>"));
  ASSERT_EQ(robot.dofs.size(), 1U);
  EXPECT_EQ(robot.joints[1].ratio, 0.5);
  EXPECT_NEAR(robot.joints[1].offset, (-10.0 - 15.0) / 90.0 * kRightAngle, kExact);
}

TEST(MjcfFile, MeshesMayBeWrittenInTheFile) {
  const std::string body =
      "<body name=\"tip\"><joint name=\"j\" range=\"0 90\"/>"
      "<geom type=\"mesh\" mesh=\"m\"/></body>";
  const std::string corners = "0 0 0  0.1 0 0  0 0.1 0  0 0 0.1";
  // The hull of the vertices, in which an inner one has no part.
  const Robot hull = robot_of(
      on_palm(body, "<asset><mesh name=\"m\" vertex=\"" + corners + " 0.01 0.01 0.01\"/></asset>"));
  EXPECT_EQ(hull.links[1].mesh.triangles.size(), 4U);
  EXPECT_NEAR(bounds(hull.links[1].mesh).size().x(), 0.1, kExact);
  const Robot faces =
      robot_of(on_palm(body, "<asset><mesh name=\"m\" scale=\"2 2 2\" vertex=\"" + corners +
                                 "\" face=\"0 2 1 0 1 3 0 3 2\"/></asset>"));
  EXPECT_EQ(faces.links[1].mesh.triangles.size(), 3U);
  EXPECT_NEAR(bounds(faces.links[1].mesh).size().z(), 0.2, kExact);
}

// A hand that flies, beside what it holds: its own free body is the base.
TEST(MjcfFile, AFreeBodyWithJointsIsTheRobot) {
  const Robot robot = robot_of(
      mjcf("<worldbody><body name=\"target\" mocap=\"true\"/><body name=\"palm\" pos=\"1 2 3\">"
           "<freejoint/><geom size=\"0.02\"/><body name=\"tip\" pos=\"0.1 0 0\"><joint name=\"j\" "
           "range=\"0 90\"/><geom size=\"0.01\"/></body></body><body name=\"cup\"><freejoint/>"
           "<geom size=\"0.03\"/></body></worldbody>"));
  ASSERT_EQ(robot.links.size(), 2U);
  EXPECT_EQ(robot.links[0].name, "palm");
  EXPECT_LT((poses(robot, {0.0})[1].translation() - Vector3(0.1, 0.0, 0.0)).norm(), kExact);
  EXPECT_TRUE(has_note(robot, "beside the robot"));
}

TEST(MjcfFile, DetailsDoNotRefuseTheRobot) {
  const Robot robot = robot_of(mjcf(
      "<asset><mesh name=\"tetra\" vertex=\"0 0 0 0.1 0 0 0 0.1 0 0 0 0.1\"/></asset><worldbody>"
      "<body name=\"palm\"><geom size=\"0.02\"/><body name=\"a\"><joint name=\"j\" "
      "type=\"slide\"/><geom type=\"capsule\" mesh=\"tetra\"/></body><body name=\"b\"><joint "
      "name=\"k\" range=\"0 90\"/><geom size=\"0.01\"/></body></body></worldbody>"
      "<equality><joint joint1=\"k\" joint2=\"j\"/></equality>"));
  ASSERT_EQ(robot.dofs.size(), 2U);
  EXPECT_EQ(robot.dofs[0].lower, -1.0);
  EXPECT_EQ(robot.dofs[0].upper, 1.0);
  EXPECT_GT(robot.links[1].mesh.triangles.size(), 100U);  // a capsule that is fitted to it
  EXPECT_TRUE(has_note(robot, "may slide 1 m to either side"));
  EXPECT_TRUE(has_note(robot, "joint k follows j, a joint of another type"));
}

// Two of them inside each other turn and move all that is in them, by classes too.
TEST(MjcfFile, FramesMoveWhatIsInThem) {
  const std::string classes =
      "<compiler angle=\"radian\"/><default><default class=\"far\"><geom pos=\"0 0 0.5\" "
      "size=\"0.01\"/></default></default>";
  const Robot framed = robot_of(on_palm(
      "<frame pos=\"0 0 0.1\" euler=\"0 0 0.5\"><frame pos=\"0.2 0 0\" euler=\"0.3 0 0\" "
      "childclass=\"far\"><geom/><geom class=\"far\" fromto=\"0 0 0 0.1 0 0\" type=\"capsule\"/>"
      "<body name=\"a\" pos=\"0 0.3 0\" quat=\"0 1 0 0\"><joint name=\"j\"/><geom/></body>"
      "</frame></frame>",
      classes));
  const Pose X = translation({0.0, 0.0, 0.1}) * Eigen::AngleAxisd(0.5, Vector3::UnitZ()) *
                 translation({0.2, 0.0, 0.0}) * Eigen::AngleAxisd(0.3, Vector3::UnitX());
  const auto box = [](const Robot& robot, std::size_t link) {
    return bounds(transformed(robot.links[link].mesh, poses(robot, {0.0})[link])).center();
  };
  const Pose X_A =
      X * translation({0.0, 0.3, 0.0}) * Eigen::AngleAxisd(2.0 * kRightAngle, Vector3::UnitX());
  EXPECT_LT((box(framed, 1) - X_A * Vector3(0.0, 0.0, 0.5)).norm(), 1e-9);
  // Of the palm: itself, a ball at the class's place, a capsule between two points.
  const Vector3 ball = X * Vector3(0.0, 0.0, 0.5);
  const Bounds all = bounds(framed.links[0].mesh);
  EXPECT_NEAR(all.upper.z(), ball.z() + 0.01, 1e-4);
  EXPECT_NEAR(all.upper.x(), (X * Vector3(0.1, 0.0, 0.0)).x() + 0.01, 1e-3);
}

TEST(MjcfFile, ReplicatedPartsStandBesideEachOther) {
  const Robot robot = robot_of(on_palm(
      "<replicate count=\"3\" offset=\"0.1 0 0\" euler=\"0 0 90\" sep=\"-\"><body name=\"finger\" "
      "pos=\"0 0 0.2\"><joint name=\"bend\" range=\"0 90\"/><geom "
      "size=\"0.01\"/></body></replicate>"));
  ASSERT_EQ(robot.links.size(), 4U);
  const std::vector<Vector3> expected = {{0.0, 0.0, 0.2}, {0.1, 0.0, 0.2}, {0.1, 0.1, 0.2}};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(robot.links[k + 1].name, "finger-" + std::to_string(k));
    EXPECT_EQ(robot.dofs[k].name, "bend-" + std::to_string(k));
    EXPECT_LT((poses(robot, {0, 0, 0})[k + 1].translation() - expected[k]).norm(), kExact);
  }
}

TEST(MjcfFile, IncludedFilesStandInTheirPlace) {
  const std::filesystem::path folder = test_folder();
  write_text(folder / "parts" / "classes.xml",
             "<mujocoinclude><default><geom size=\"0.02\"/></default></mujocoinclude>");
  write_text(folder / "parts" / "finger.xml",
             "<mujocoinclude><body name=\"a\"><joint name=\"j\"/>\n<geom/></body></mujocoinclude>");
  const std::string head = "<include file=\"parts/classes.xml\"/>";
  const std::filesystem::path file =
      write_text(folder / "made.xml", on_palm("<include file=\"parts/finger.xml\"/>", head));
  const Robot robot = read_foreign_robot(file).value().robots.at(0).robot;
  ASSERT_EQ(robot.links.size(), 2U);
  EXPECT_NEAR(bounds(robot.links[1].mesh).size().x(), 0.04, 1e-3);
  write_text(
      folder / "parts" / "finger.xml",
      "<mujocoinclude><body name=\"a\"><joint name=\"j\" type=\"ball\"/></body></mujocoinclude>");
  try {
    (void)read_foreign_robot(file);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(
        std::string(error.what()).find("made.xml: finger.xml line 1, <joint>: joints of type"),
        std::string::npos)
        << error.what();
  }
  write_text(folder / "parts" / "finger.xml",
             "<mujocoinclude><include file=\"parts/finger.xml\"/></mujocoinclude>");
  EXPECT_THROW((void)read_foreign_robot(file), InputError);
}

struct BadMjcf {
  const char* name;
  std::string text;
  const char* complaint;
};

class MjcfFileErrors : public testing::TestWithParam<BadMjcf> {};

TEST_P(MjcfFileErrors, AreOneLineWithTheirPlace) {
  EXPECT_EQ(foreign_complaint(GetParam().text), GetParam().complaint);
}

INSTANTIATE_TEST_SUITE_P(
    Files, MjcfFileErrors,
    testing::Values(
        BadMjcf{"NoBody", mjcf("<worldbody/>"),
                "line 1, <mujoco>: there is no body in <worldbody>"},
        BadMjcf{"Includes", mjcf("<include file=\"a.xml\"/>"),
                "line 2, <include>: no such file: it must be there, relative to this one (a.xml)"},
        BadMjcf{"Composite", on_palm("<composite type=\"grid\"/>"),
                "line 2, <composite>: cannot be read; save the model as one file "
                "(mj_saveLastXML)"},
        BadMjcf{"JointInAFrame", on_palm("<body><frame><joint name=\"j\"/></frame></body>"),
                "line 2, <joint>: cannot stand in a frame"},
        BadMjcf{"ReplicatesALot",
                on_palm("<replicate count=\"1e9\"><geom size=\"1\"/></replicate>"),
                "line 2, <replicate>: count must be a whole number from 1 to 10000 (1e9)"},
        BadMjcf{"Ball", on_palm("<body><joint name=\"j\" type=\"ball\"/></body>"),
                "line 2, <joint>: joints of type ball cannot be planned with; known are hinge and "
                "slide (j)"},
        BadMjcf{"SwappedRange", on_palm("<body><joint name=\"j\" range=\"1 0\"/></body>"),
                "line 2, <joint>: attribute range must be two numbers, the lower one first (1 0)"},
        BadMjcf{"UnknownClass", on_palm("<body><joint name=\"j\" class=\"c\"/></body>"),
                "line 2, <joint>: no default class of this name (c)"},
        BadMjcf{"UnknownGeom", on_palm("<geom type=\"cone\" size=\"1\"/>"),
                "line 2, <geom>: unknown type, known are plane, sphere, capsule, ellipsoid, "
                "cylinder, box and mesh (cone)"},
        BadMjcf{"FewSizes", on_palm("<geom type=\"box\" size=\"1 1\"/>"),
                "line 2, <geom>: too few sizes for a box (1 1)"},
        BadMjcf{"UnknownMesh", on_palm("<geom mesh=\"m\"/>"),
                "line 2, <geom>: no mesh of this name in <asset> (m)"},
        BadMjcf{"NoQuaternion", on_palm("<geom size=\"1\" quat=\"0 0 0 0\"/>"),
                "line 2, <geom>: a quaternion must not be 0"},
        BadMjcf{"CoupledToNobody", on_palm("", "<equality><joint joint1=\"a\"/></equality>\n"),
                "line 2, <joint>: no joint of this name (a)"},
        BadMjcf{"SameName", on_palm("<body name=\"palm\"/>"),
                "line 2, <body>: name used twice (palm)"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace prehend
