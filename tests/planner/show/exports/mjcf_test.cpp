#include "planner/show/exports/mjcf.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "planner/plan/plan_result.h"
#include "planner/show/exports/export_files.h"
#include "planner/show/exports/export_formats.h"
#include "sim/motion/placed_contact.h"
#include "sim/robot/files/joint_tree.h"
#include "sim/robot/files/mjcf_file.h"
#include "tests/support/held_cube.h"
#include "tests/support/library_scenes.h"

namespace prehend {
namespace {

// A few pieces are enough where their shape does not matter.
constexpr ConvexPiecesOptions kCoarse{.tolerance = 0.02, .relative_tolerance = 1.0};

ExportGrasp export_of_trial(const CompiledScene& scene, const Trial& trial,
                            const Candidate& candidate) {
  ScoredGrasp grasp;
  grasp.trial = trial;
  grasp.candidate = candidate;
  return export_of(scene, grasp, 1);
}

// The hand at its last preshape, half closed, at an arbitrary place.
ExportGrasp half_closed(const CompiledScene& scene) {
  const Robot& hand = scene.scene.hand;
  Candidate candidate = test::from_above();
  std::vector<double> dofs = hand.hand->preshapes.back().dofs;
  candidate.preshape = static_cast<int>(hand.hand->preshapes.size()) - 1;
  for (std::size_t d = 0; d < dofs.size(); ++d) {
    const double v = hand.dofs[d].closing_velocity;
    const double end = v > 0.0 ? hand.dofs[d].upper : v < 0.0 ? hand.dofs[d].lower : dofs[d];
    dofs[d] = 0.5 * (dofs[d] + end);
  }
  Trial trial;
  trial.X_OH = Random(8).pose(0.2);
  trial.dofs = dofs;
  trial.joints = joint_values(hand, dofs);
  return export_of_trial(scene, trial, candidate);
}

Robot read_back(const std::string& text) { return to_robot(read_mjcf(XmlFile("hand.xml", text))); }

// The values that a robot's joints have by name in another robot.
std::vector<double> values_by_name(const Robot& robot, const Robot& of,
                                   const std::vector<double>& values) {
  std::vector<double> found;
  for (const Joint& joint : robot.joints) {
    const auto same = std::find_if(of.joints.begin(), of.joints.end(),
                                   [&](const Joint& other) { return other.name == joint.name; });
    EXPECT_NE(same, of.joints.end()) << joint.name;
    found.push_back(values[static_cast<std::size_t>(same - of.joints.begin())]);
  }
  return found;
}

class MjcfOfHand : public testing::TestWithParam<const char*> {};

// The hand reads back with all links at the same places, also at values other than the grasp's, and
// with its limits, efforts and masses.
TEST_P(MjcfOfHand, ReadsBackWithTheSameLinkPoses) {
  const CompiledScene scene = test::compiled(find_robot(GetParam()), make_box({0.03, 0.04, 0.05}));
  const Robot& hand = scene.scene.hand;
  const ExportGrasp grasp = half_closed(scene);
  const Robot read = read_back(mjcf_text(scene, mjcf_shapes(scene, kCoarse), grasp));
  ASSERT_EQ(read.links.size(), hand.links.size());
  ASSERT_EQ(read.joints.size(), hand.joints.size());
  Random random(3);
  for (int i = 0; i < 5; ++i) {
    std::vector<double> values = grasp.closed_joints;
    for (std::size_t j = 0; i > 0 && j < values.size(); ++j) {
      values[j] = random.uniform(hand.joints[j].lower, hand.joints[j].upper);
    }
    std::vector<Pose> wanted;
    std::vector<Pose> found;
    link_poses(hand, values, wanted);
    link_poses(read, values_by_name(read, hand, values), found);
    for (std::size_t l = 0; l < found.size(); ++l) {
      const auto same = std::find_if(hand.links.begin(), hand.links.end(), [&](const Link& link) {
        return link.name == read.links[l].name;
      });
      ASSERT_NE(same, hand.links.end()) << read.links[l].name;
      const auto at = static_cast<std::size_t>(same - hand.links.begin());
      // The reader has meshes in the frames of joints, so that places are compared by the centre of
      // mass that both know.
      const Vector3 p =
          wanted[at] * (hand.links[at].inertial.mass > 0.0
                            ? hand.links[at].inertial.center_of_mass
                            : inertial_of_density(hand.links[at].mesh, 1.0).center_of_mass);
      EXPECT_LT((found[l] * read.links[l].inertial.center_of_mass - p).norm(), 1e-9)
          << read.links[l].name;
      EXPECT_GT(read.links[l].inertial.mass, 0.0);
      EXPECT_LT((found[l].linear() - wanted[at].linear()).norm(), 1e-9) << read.links[l].name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Library, MjcfOfHand,
                         testing::Values("barrett", "franka_hand", "parallel_jaw", "robotiq_2f85",
                                         "robotiq_3f", "shadow_like", "allegro"),
                         [](const auto& of) { return std::string(of.param); });

// The numbers of `ctrl` in the keyframe of this name.
std::vector<double> efforts_of(const std::string& text, const std::string& key) {
  const std::size_t begin = text.find("<key name=\"" + key + "\"");
  if (begin == std::string::npos) return {};
  const std::string ctrl = "ctrl=\"";
  const std::size_t first = text.find(ctrl, begin) + ctrl.size();
  std::istringstream numbers(text.substr(first, text.find('"', first) - first));
  return {std::istream_iterator<double>(numbers), {}};
}

// In each stage what closes works with its part of its effort, and what waits bears its weight.
TEST(Mjcf, AStrategyIsAKeyframeForEachStage) {
  const CompiledScene scene = test::compiled(find_robot("barrett"), make_box({0.03, 0.04, 0.05}));
  const MjcfShapes shapes = mjcf_shapes(scene, kCoarse);
  ExportGrasp grasp = half_closed(scene);
  EXPECT_TRUE(efforts_of(mjcf_text(scene, shapes, grasp), "closing_1").empty());
  grasp.strategy = {.name = "thumb_first", .first = {3}, .effort = 0.5};
  const std::string text = mjcf_text(scene, shapes, grasp);
  const std::vector<double> closed = efforts_of(text, "grasp");
  const std::vector<double> first = efforts_of(text, "closing_1");
  const std::vector<double> second = efforts_of(text, "closing_2");
  EXPECT_TRUE(efforts_of(text, "closing_3").empty());
  const HandDrives drives = hand_drives(scene.scene.hand);
  ASSERT_EQ(closed.size(), drives.drives.size());
  ASSERT_EQ(first.size(), closed.size());
  ASSERT_EQ(second.size(), closed.size());
  for (std::size_t d = 0; d < closed.size(); ++d) {
    const HandDrive& drive = drives.drives[d];
    if (drive.closing == 0.0) continue;
    const int dof = scene.scene.hand.joints[static_cast<std::size_t>(drive.joint)].dof;
    EXPECT_NEAR(second[d], 0.5 * closed[d], 1e-9);
    if (dof == 3)
      EXPECT_NEAR(first[d], 0.5 * closed[d], 1e-9);
    else
      EXPECT_LT(std::abs(first[d]), 0.1 * closed[d]);
  }
}

TEST(Mjcf, DrivesAndCouplingsAreThoseOfTheHand) {
  const HandDrives jaw = hand_drives(find_robot("parallel_jaw"));
  ASSERT_EQ(jaw.drives.size(), 2U);
  EXPECT_TRUE(jaw.couplings.empty());
  for (const HandDrive& drive : jaw.drives) {
    EXPECT_EQ(drive.effort, 20.0);
    EXPECT_EQ(drive.closing, -20.0);
  }
  const HandDrives franka = hand_drives(find_robot("franka_hand"));
  ASSERT_EQ(franka.drives.size(), 2U);
  EXPECT_EQ(franka.drives[0].closing, -70.0);
  ASSERT_EQ(franka.couplings.size(), 1U);
  EXPECT_EQ(franka.couplings[0].ratio, 1.0);
  // Two fingers turn about the palm together, which holds them where they are; each finger bends by
  // itself, both of its joints at once.
  const Robot barrett = find_robot("barrett");
  const HandDrives drives = hand_drives(barrett);
  std::size_t holding = 0;
  for (const HandDrive& drive : drives.drives) {
    EXPECT_GT(drive.effort, 0.0);
    holding += drive.closing == 0.0 ? 1U : 0U;
  }
  EXPECT_EQ(holding, 2U);
  EXPECT_EQ(drives.drives.size(), 5U);
  EXPECT_EQ(drives.couplings.size(), 4U);
}

// With clutches the drive of a finger is at its last joint, with the effort through that ratio, and
// the first joint follows it up to the clutch's effort. Cables that pass the first joint press on
// both alike: with values p and d, the motor is at 3 (p + d) / 4 and the clutch has slipped by (p -
// 3 d) / 4.
TEST(Mjcf, ClutchesAreDryFrictionBetweenJoints) {
  const CompiledScene scene = test::compiled(find_robot("barrett"), make_box({0.03, 0.04, 0.05}));
  const Robot& hand = scene.scene.hand;
  MjcfOptions options;
  options.clutches = make_robot_model(hand).clutches;
  const HandDrives drives = hand_drives(hand, options.clutches);
  EXPECT_EQ(drives.couplings.size(), 1U);  // the spread
  ASSERT_EQ(drives.clutches.size(), 3U);
  for (const HandClutch& clutch : drives.clutches) {
    EXPECT_NEAR(clutch.follows.ratio, 3.0, 1e-12);
    EXPECT_NEAR(clutch.effort, 0.5 / 4.0, 1e-12);
  }
  // 5 N m of the thumb.
  const std::size_t last = drives.drives.size() - 1;
  EXPECT_NEAR(drives.drives[last].effort, 3.75, 1e-9);
  EXPECT_NEAR(drives.drives[last - 1].effort, 3.75, 1e-9);
  Robot geared = hand;
  for (Joint& joint : geared.joints) joint.across = -1;
  const HandDrives without = hand_drives(geared, options.clutches);
  EXPECT_NEAR(without.drives.back().effort, 15.0, 1e-9);
  EXPECT_NEAR(without.clutches.front().effort, 0.5, 1e-12);
  const std::string text =
      mjcf_text(scene, mjcf_shapes(scene, kCoarse), half_closed(scene), options);
  EXPECT_NE(text.find("<fixed name=\"thumb_proximal/clutch\" frictionloss=\"0.125\""),
            std::string::npos);
}

// Rubber pads resist spin (soft_arm); hard links do not.
TEST(Mjcf, SoftPadsResistSpin) {
  const CompiledScene scene =
      test::compiled(find_robot("franka_hand"), make_box({0.03, 0.04, 0.05}));
  const XmlFile file("x.xml", mjcf_text(scene, mjcf_shapes(scene, kCoarse), half_closed(scene)));
  std::map<std::string, double> torsion;
  const std::function<void(const XmlElement&)> visit = [&](const XmlElement& body) {
    for (const XmlElement& geom : body.children("geom")) {
      if (!geom.has("friction")) continue;
      torsion[geom.text("name")] = geom.numbers("friction").at(1);
      EXPECT_EQ(geom.has("condim"), geom.numbers("friction").at(1) > 0.0);
    }
    for (const XmlElement& child : body.children("body")) visit(child);
  };
  visit(file.root()["worldbody"]);
  const double friction = scene.scene.friction.between(Material::rubber, Material::plastic);
  EXPECT_NEAR(torsion.at("left_pad/0"), friction * soft_arm(1e-3), 1e-12);
  EXPECT_EQ(torsion.at("left_finger/0"), 0.0);
}

// Friction of the hand's geoms is that of the scene's table, which has the object's material.
TEST(Mjcf, EachPairHasItsFriction) {
  Scene scene = test::scene_with(find_robot("parallel_jaw"), make_box(Vector3::Constant(0.05)),
                                 {test::obstacle(make_box({1.0, 1.0, 0.1}), {0.0, 0.0, -0.2})});
  scene.friction.set(Material::rubber, Material::plastic, 0.77);
  scene.friction.set(Material::metal, Material::plastic, 0.11);
  scene.friction.set(Material::wood, Material::plastic, 0.33);
  scene.friction.set(Material::rubber, Material::wood, 0.44);
  scene.friction.set(Material::metal, Material::wood, 0.33);
  const CompiledScene ready = compile(scene);
  const XmlFile file("x.xml", mjcf_text(ready, mjcf_shapes(ready), half_closed(ready)));
  std::map<std::string, double> found;
  const std::function<void(const XmlElement&)> visit = [&](const XmlElement& body) {
    for (const XmlElement& geom : body.children("geom")) {
      if (geom.has("friction")) found[geom.text("name")] = geom.numbers("friction").front();
    }
    for (const XmlElement& child : body.children("body")) visit(child);
  };
  visit(file.root()["worldbody"]);
  EXPECT_EQ(found, (std::map<std::string, double>{{"left_plate/0", 0.77},
                                                  {"right_plate/0", 0.77},
                                                  {"palm/0", 0.11},
                                                  {"obstacle/0", 0.33}}));
  std::map<std::string, double> pairs;
  for (const XmlElement& pair : file.root()["contact"].children("pair")) {
    pairs[pair.text("geom1") + " " + pair.text("geom2")] = pair.numbers("friction").front();
  }
  EXPECT_EQ(pairs.at("left_plate/0 obstacle/0"), 0.44);
  EXPECT_FALSE(pairs.contains("palm/0 obstacle/0"));  // for which the larger of the two is right
}

TEST(Mjcf, TheSameGraspGivesTheSameText) {
  const test::HeldCube held = test::held_cube();
  const ExportGrasp grasp = export_of_trial(held.scene, held.trial, test::from_above());
  const std::string text = mjcf_text(held.scene, mjcf_shapes(held.scene), grasp);
  EXPECT_EQ(text, mjcf_text(held.scene, mjcf_shapes(held.scene), grasp));
  EXPECT_EQ(mjcf_file_name(3), "grasp_3.xml");
}

}  // namespace
}  // namespace prehend
