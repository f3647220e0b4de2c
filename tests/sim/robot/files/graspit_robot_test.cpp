#include "sim/robot/files/graspit_robot.h"

#include <algorithm>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/robot/files/graspit_body.h"
#include "sim/robot/files/graspit_expression.h"
#include "sim/robot/sound_robot.h"
#include "tests/support/graspit_files.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

constexpr double kInRadians = std::numbers::pi / 180.0;

Robot imported_robot(const std::filesystem::path& file) {
  return read_graspit_robot(XmlFile(file));
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

bool noted(const std::vector<std::string>& notes, const std::string& phrase) {
  return std::any_of(notes.begin(), notes.end(), [&](const std::string& note) {
    return note.find(phrase) != std::string::npos && note.find('\n') == std::string::npos;
  });
}

TEST(GraspitExpression, IsReadAsAWholeOrNotAtAll) {
  const auto expect = [](const char* text, int dof, double ratio, double constant) {
    const auto read = graspit_expression(text);
    ASSERT_TRUE(read.has_value()) << text;
    EXPECT_EQ(read->dof.value_or(-1), dof) << text;
    EXPECT_EQ(read->ratio, ratio) << text;
    EXPECT_EQ(read->constant, constant) << text;
  };
  expect("d0", 0, 1.0, 0.0);
  expect("d12+90", 12, 1.0, 90.0);
  expect("d1-2.46", 1, 1.0, -2.46);
  expect("d1*-1+-3.1", 1, -1.0, -3.1);
  expect("d2*0.5-3", 2, 0.5, -3.0);
  expect(" d2 * .5e0 - -3 ", 2, 0.5, 3.0);
  expect("-90.5", -1, 1.0, -90.5);
  expect("+1e2", -1, 1.0, 100.0);
  for (const char* text :
       {"", "d", "d+1", "dx", "d1*", "d1+", "d1*2*3", "d1+1+1x", "90+d0", "d1 d2", "1e999", "nan",
        "d1*inf", "d99999999999", "d-1", "d1--", "0x10", "d1---3"}) {
    EXPECT_FALSE(graspit_expression(text).has_value()) << text;
  }
}

TEST(GraspitRobot, HasWhatItsFileSays) {
  const Robot hand = imported_robot(test::written_graspit_hand(test::graspit_folder()));
  EXPECT_EQ(hand.name, "pincher");
  ASSERT_EQ(hand.dofs.size(), 2u);
  EXPECT_EQ(hand.dofs[0].coupling, Coupling::breakaway);
  EXPECT_EQ(hand.dofs[1].coupling, Coupling::rigid);
  EXPECT_NEAR(hand.dofs[0].lower, 0.0, 1e-12);
  EXPECT_NEAR(hand.dofs[0].upper, 90.0 * kInRadians, 1e-12);
  EXPECT_EQ(hand.dofs[1].closing_velocity, 0.5);
  ASSERT_EQ(hand.joints.size(), 4u);
  EXPECT_EQ(hand.joints[1].ratio, -0.5);
  EXPECT_NEAR(hand.joints[1].zero, -10.0 * kInRadians, 1e-12);
  EXPECT_NEAR(hand.joints[1].lower, -60.0 * kInRadians, 1e-12);
  EXPECT_NEAR(hand.joints[0].max_effort, 2.5, 1e-12);
  EXPECT_NEAR(hand.joints[0].friction.viscous, 0.05, 1e-12);
  EXPECT_TRUE(noted(hand.notes, "exchanged"));
  ASSERT_EQ(hand.links.size(), 4u);
  EXPECT_EQ(hand.links[3].joint, 3);
  EXPECT_EQ(hand.links[0].material, "rubber");
  EXPECT_NEAR(hand.links[0].inertial.mass, 0.2, 1e-12);
  EXPECT_NEAR(bounds(hand.links[0].mesh).size().x(), 0.1, 1e-9);
  ASSERT_TRUE(hand.hand.has_value());
  EXPECT_TRUE(hand.hand->approach.isApprox(Vector3::UnitZ()));
  EXPECT_NEAR(hand.hand->origin.z(), 0.005, 1e-12);
  require_sound(hand);
}

// Rz(theta) Tx(a) by hand, in planes that the chains turn to x and z.
TEST(GraspitRobot, TipsAreWhereTrigonometrySays) {
  const Robot hand = imported_robot(test::written_graspit_hand(test::graspit_folder()));
  const double d0 = 0.7;
  const double d1 = 0.4;
  std::vector<Pose> X_BL;
  link_poses(hand, joint_values(hand, {d0, d1}), X_BL);
  const double first = 90.0 * kInRadians - d0;
  const double second = first - 0.5 * d0 - 10.0 * kInRadians;
  const Vector3 tip(0.030 + 0.050 * std::cos(first) + 0.040 * std::cos(second), 0.0,
                    0.010 + 0.050 * std::sin(first) + 0.040 * std::sin(second));
  EXPECT_LT((X_BL[2].translation() - tip).norm(), 1e-12);
  const double own = 90.0 * kInRadians + d1;
  const double next = own + 0.5 * d1 - 10.0 * kInRadians;
  const Vector3 other(-0.030 + 0.050 * std::cos(own) + 0.040 * std::cos(next), 0.0,
                      0.010 + 0.050 * std::sin(own) + 0.040 * std::sin(next));
  EXPECT_LT((X_BL[3].translation() - other).norm(), 1e-12);
}

TEST(GraspitRobot, SlidingJointsAreInMetresAndNewtons) {
  const Robot arm = imported_robot(test::written_graspit_arm(test::graspit_folder()));
  EXPECT_FALSE(arm.hand.has_value());
  EXPECT_NEAR(arm.dofs[0].upper, 0.5, 1e-12);
  EXPECT_NEAR(arm.joints[0].upper, 1.0, 1e-12);
  EXPECT_NEAR(arm.joints[0].max_effort, 50.0, 1e-12);
  EXPECT_NEAR(arm.joints[0].friction.coulomb, 1.0, 1e-12);
  std::vector<Pose> X_BL;
  link_poses(arm, joint_values(arm, {0.25, 0.0}), X_BL);
  EXPECT_LT((X_BL[2].translation() - Vector3(0.5, 0.0, 0.3)).norm(), 1e-8);
}

struct RefusedRobot {
  std::string from;
  std::string to;
  std::string phrase;
};

TEST(GraspitRobot, RefusesWithFileAndLine) {
  const std::filesystem::path root = test::graspit_folder();
  const std::vector<RefusedRobot> all = {
      {"d0*-1+90", "d0*-1+90x",
       "line 10, <theta>: must be a number or dN*ratio+constant (d0*-1+90x)"},
      {"d0*-1+90", "d7", "line 10, <theta>: the robot has degrees of freedom d0 to d1 only (d7)"},
      {"d0*-1+90", "d0*0", "ratio must be at least 1e-9"},
      {"d0*-1+90", "90", "no degree of freedom drives it"},
      {"<d>0</d>", "<d>d1</d>", "must be a number"},
      {"<d>0</d>", "<d>nan</d>", "must be a number"},
      {"<d>0</d>", "", "<d> is missing"},
      {"type=\"Revolute\"", "type=\"Screw\"", "unknown type of joint"},
      {"\"Universal\"", "\"Ball\"", "need more joints"},
      {"\"Universal\"", "\"Weld\"", "unknown dynamicJointType"},
      {"type=\"b\"", "type=\"z\"", "unknown type"},
      {"90 x", "90 w", "the axis must be x, y or z"},
      {"90 x", "90", "must be an angle and an axis"},
      {"30 0 10", "30 0", "three numbers"},
      {"1 0 0 0 0 1 0 -1 0", "1 0 0 0 0 1 0 -2 0", "not a rotation"},
      {"<rotation>", "<scale>1</scale><rotation>", "not a step of a transform"},
      {"<palm>palm.xml</palm>", "<palm>missing.xml</palm>",
       "missing.xml: cannot be read: no such file"},
      {"0 0 2", "0 0 0", "has no length"},
      {"</robot>", "", "line "},
      {"<robot", "<!DOCTYPE r [<!ENTITY a \"b\">]><robot", "line 2: entities"},
  };
  for (const RefusedRobot& refused : all) {
    SCOPED_TRACE(refused.to);
    const auto file =
        test::written_graspit_hand(root, changed(test::graspit_hand(), refused.from, refused.to));
    const std::string message = test::refusal_of([&] { (void)imported_robot(file); }).what();
    EXPECT_NE(message.find(refused.phrase), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_TRUE(message.starts_with(root.string())) << message;
  }
}

TEST(GraspitRobot, RefusesDegreesOfFreedomWithoutJointsOrValues) {
  const std::filesystem::path root = test::graspit_folder();
  const auto refusal = [&](const std::string& from, const std::string& to) {
    const auto file = test::written_graspit_hand(root, changed(test::graspit_hand(), from, to));
    return std::string(test::refusal_of([&] { (void)imported_robot(file); }).what());
  };
  EXPECT_NE(refusal("</palm>", "</palm>\n<dof type=\"r\"/>").find("no joint is driven by d2"),
            std::string::npos);
  EXPECT_NE(refusal("<minValue>0</minValue><maxValue>-60", "<minValue>10</minValue><maxValue>60")
                .find("no value keeps all its joints inside"),
            std::string::npos);
}

TEST(GraspitRobot, NotesWhatItLeavesOut) {
  const std::filesystem::path root = test::graspit_folder();
  const Robot hand = imported_robot(test::written_graspit_hand(
      root, changed(test::graspit_hand(), "</palm>", "</palm><telepathy>3</telepathy>")));
  EXPECT_TRUE(noted(hand.notes, "pincher.xml: line 3, <telepathy>: not known, left out"));
}

GraspitBody body_with(const std::string& more, const std::string& material = "stone") {
  const std::filesystem::path file = test::graspit_folder() / "body.xml";
  test::write_graspit_box(file, "width 1 height 2 depth 3");
  test::write_graspit_text(file, "<root><material>" + material + "</material>" + more +
                                     "<geometryFile>body.iv</geometryFile></root>");
  return load_graspit_body(file);
}

TEST(GraspitBody, IsInMetresAndKilograms) {
  const GraspitBody body = body_with(
      "<mass>500</mass><cog>1 2 3</cog><inertia_matrix>4 1 0 1 5 0 0 0 6</inertia_matrix>");
  EXPECT_NEAR(body.mass, 0.5, 1e-12);
  const Inertial inertial = inertial_of(body);
  EXPECT_LT((inertial.center_of_mass - Vector3(1e-3, 2e-3, 3e-3)).norm(), 1e-12);
  EXPECT_NEAR(inertial.inertia(0, 1), 0.5e-6, 1e-15);
  EXPECT_EQ(body.unit, "mm");
  EXPECT_EQ(body.material, Material::wood);
  EXPECT_TRUE(noted(body.notes, "no material 'stone' here: taken as wood"));
}

TEST(GraspitBody, IsScaledAndMoved) {
  const GraspitBody metres = body_with("<geometryScaling>1000</geometryScaling>", "glass");
  EXPECT_EQ(metres.unit, "m");
  EXPECT_TRUE(metres.notes.empty());
  EXPECT_NEAR(bounds(metres.mesh).size().z(), 3.0, 1e-12);
  const GraspitBody moved =
      body_with("<geometryScaling>1 2 1</geometryScaling><geometryOffset>0 0 1</geometryOffset>");
  EXPECT_EQ(moved.unit, "");
  EXPECT_NEAR(bounds(moved.mesh).size().y(), 0.004, 1e-12);
  EXPECT_NEAR(bounds(moved.mesh).lower.z(), -0.0005, 1e-12);
}

TEST(GraspitBody, RepairsInertiaWithANote) {
  const GraspitBody uneven =
      body_with("<mass>1</mass><inertia_matrix>4 2 0 0 5 0 0 0 6</inertia_matrix>");
  EXPECT_TRUE(noted(uneven.notes, "not symmetric"));
  EXPECT_NEAR((*uneven.unit_inertia)(1, 0), 1e-6, 1e-15);
  const GraspitBody impossible =
      body_with("<mass>1</mass><inertia_matrix>-1 0 0 0 5 0 0 0 6</inertia_matrix>");
  EXPECT_FALSE(impossible.unit_inertia.has_value());
  EXPECT_TRUE(noted(impossible.notes, "that of the mesh is taken instead"));
}

TEST(GraspitBody, RefusesWithFileAndLine) {
  const auto refusal = [](const std::string& more) {
    return std::string(test::refusal_of([&] { (void)body_with(more); }).what());
  };
  EXPECT_NE(refusal("<mass>0</mass>").find("body.xml: line 1, <mass>: must be positive"),
            std::string::npos);
  EXPECT_NE(refusal("<mass>a</mass>").find("must be a number"), std::string::npos);
  EXPECT_NE(refusal("<cog>1 2</cog>").find("three numbers"), std::string::npos);
  EXPECT_NE(refusal("<inertia_matrix>1</inertia_matrix>").find("nine numbers"), std::string::npos);
  EXPECT_NE(refusal("<geometryScaling>-1</geometryScaling>").find("positive"), std::string::npos);
}

}  // namespace
}  // namespace prehend
