// Arms made ready for motions: which bodies are never tested, and scenes that are refused.
#include "sim/scene/compiled_arm.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/shape/proximity.h"
#include "tests/support/library_scenes.h"

namespace prehend {
namespace {

using nlohmann::json;

using PairKey = std::pair<LinkId, std::variant<LinkId, BodyId>>;
PairKey key(const ArmPair& pair) { return {pair.link, pair.other}; }

// Every pair that has to be looked at, without any proof: links that are not joined, but for two of
// the hand; links before the hand with every fixed body.
std::vector<ArmPair> all_pairs(const CompiledArm& arm) {
  std::vector<ArmPair> pairs;
  for (const LinkPair& links : collision_pairs(arm.links, arm.robot())) {
    if (arm.is_hand_link(links.a) && arm.is_hand_link(links.b)) continue;
    pairs.push_back({.link = links.a, .other = links.b});
  }
  for (std::size_t l = 0; l < arm.links.size(); ++l) {
    if (arm.is_hand_link(link_id(l))) continue;
    for (std::size_t b = 0; b < arm.bodies.size(); ++b) {
      pairs.push_back({.link = link_id(l), .other = BodyId::at(b)});
    }
  }
  return pairs;
}

bool cross(const CompiledArm& arm, const ArmPair& pair, const std::vector<Pose>& X_BL) {
  const ProximityMesh& link = arm.links[index(pair.link)].mesh;
  const Pose& X = X_BL[index(pair.link)];
  if (const LinkId* other = std::get_if<LinkId>(&pair.other)) {
    return surfaces_cross(arm.links[index(*other)].mesh, link, X_BL[index(*other)].inverse() * X);
  }
  const PlacedBody& body = arm.body(std::get<BodyId>(pair.other));
  return surfaces_cross(body.mesh, link, body.X_RB.inverse() * X);
}

std::vector<double> random_dofs(const Robot& robot, Random& random) {
  std::vector<double> dofs;
  for (const DegreeOfFreedom& dof : robot.dofs)
    dofs.push_back(random.uniform(dof.lower, dof.upper));
  return dofs;
}

class ArmScene : public testing::TestWithParam<const char*> {};

TEST_P(ArmScene, PairsThatAreNotTestedNeverMeet) {
  const CompiledScene scene = test::compiled_library_scene(GetParam());
  const CompiledArm& arm = *scene.arm;
  std::set<PairKey> tested;
  for (const ArmPair& pair : arm.arm_pairs) tested.insert(key(pair));
  std::vector<ArmPair> dropped;
  const std::vector<ArmPair> all = all_pairs(arm);
  for (const ArmPair& pair : all) {
    if (tested.erase(key(pair)) == 0) dropped.push_back(pair);
  }
  EXPECT_TRUE(tested.empty()) << "pairs that should not be there";
  EXPECT_FALSE(dropped.empty());
  std::cout << GetParam() << ": " << dropped.size() << " of " << all.size() << " pairs dropped\n";
  Random random(61);
  std::vector<Pose> X_BL;
  for (int i = 0; i < 2000; ++i) {
    arm_link_poses(arm, joint_values(arm.robot(), random_dofs(arm.robot(), random)), X_BL);
    for (const ArmPair& pair : dropped) {
      ASSERT_FALSE(cross(arm, pair, X_BL))
          << first_name(arm, pair) << " meets " << second_name(arm, pair) << " in posture " << i;
    }
  }
}

TEST_P(ArmScene, TheHandIsTestedWithEveryFixedBody) {
  const CompiledScene scene = test::compiled_library_scene(GetParam());
  const CompiledArm& arm = *scene.arm;
  ASSERT_EQ(arm.bodies.size(), scene.obstacles().size() + 1);
  std::set<PairKey> tested;
  for (const ArmPair& pair : arm.hand_pairs) tested.insert(key(pair));
  EXPECT_EQ(tested.size(), arm.hand_pairs.size());
  EXPECT_EQ(tested.size(), scene.links.size() * arm.bodies.size());
  for (const PairKey& pair : tested) EXPECT_TRUE(arm.is_hand_link(pair.first));
}

// The frame after the last joint that both links of a pair hang on; the base for fixed bodies.
Pose shared_frame(const CompiledArm& arm, const ArmPair& pair, const std::vector<Pose>& X_BJ) {
  const LinkId* other = std::get_if<LinkId>(&pair.other);
  if (other == nullptr) return Pose::Identity();
  const std::vector<int>& a = arm.links[index(pair.link)].joints;
  const std::vector<int>& b = arm.links[index(*other)].joints;
  Pose X = Pose::Identity();
  for (std::size_t k = 0; k < std::min(a.size(), b.size()) && a[k] == b[k]; ++k) {
    X = X_BJ[index(a[k])];
  }
  return X;
}

struct Posture {
  std::vector<double> joints;
  std::vector<Pose> X_BJ;
  std::vector<Pose> X_BL;
};

Posture random_posture(const CompiledArm& arm, Random& random) {
  Posture posture;
  posture.joints = joint_values(arm.robot(), random_dofs(arm.robot(), random));
  joint_poses(arm.robot(), posture.joints, posture.X_BJ);
  arm_link_poses(arm, posture.joints, posture.X_BL);
  return posture;
}

// The farthest that a point of the link moves, seen from the pair's shared frame.
double farthest(const CompiledArm& arm, const ArmPair& pair, LinkId link, const Posture& from,
                const Posture& to) {
  const Pose before = shared_frame(arm, pair, from.X_BJ).inverse() * from.X_BL[index(link)];
  const Pose after = shared_frame(arm, pair, to.X_BJ).inverse() * to.X_BL[index(link)];
  double most = 0.0;
  for (const Vector3& p : arm.links[index(link)].mesh.mesh().vertices) {
    most = std::max(most, (after * p - before * p).norm());
  }
  return most;
}

// A gap cannot shrink by more than both bodies move, seen from what they share: at most the sum of
// reach times turn.
TEST_P(ArmScene, ReachesBoundHowFarTheBodiesOfAPairMoveTowardsEachOther) {
  const CompiledScene scene = test::compiled_library_scene(GetParam());
  const CompiledArm& arm = *scene.arm;
  Random random(62);
  double tightest = 0.0;
  for (int i = 0; i < 60; ++i) {
    const Posture from = random_posture(arm, random);
    const Posture to = random_posture(arm, random);
    for (const ArmPair& pair : arm.arm_pairs) {
      double bound = 0.0;
      for (std::size_t k = 0; k < pair.joints.size(); ++k) {
        const std::size_t j = index(pair.joints[k]);
        bound += pair.reach[k] * std::abs(to.joints[j] - from.joints[j]);
      }
      const LinkId* other = std::get_if<LinkId>(&pair.other);
      const double moved = farthest(arm, pair, pair.link, from, to) +
                           (other != nullptr ? farthest(arm, pair, *other, from, to) : 0.0);
      ASSERT_LE(moved, bound + 1e-9) << first_name(arm, pair) << ' ' << second_name(arm, pair);
      if (bound > 0.0) tightest = std::max(tightest, moved / bound);
    }
  }
  EXPECT_GT(tightest, 0.5);  // a bound that says something
}

INSTANTIATE_TEST_SUITE_P(Library, ArmScene,
                         testing::Values("mug_on_table", "cluttered_table", "shelf", "living_room"),
                         [](const auto& name) { return std::string(name.param); });

std::string complaint(const json& scene) {
  const std::filesystem::path file = test::write_scene(scene);
  try {
    (void)load_scene(file);
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    EXPECT_EQ(what.rfind(file.string() + ": ", 0), 0U) << what;
    return what.substr(std::min(what.size(), file.string().size() + 2));
  }
  return "";
}

std::string compile_complaint(const json& scene) {
  try {
    (void)test::compiled_scene(scene);
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    return what;
  }
  return "";
}

TEST(BadArmScene, AnObjectInAnObstacle) {
  json scene = test::scene_json("mug_on_table");
  scene["object"]["pose"]["position"] = {0.58, 0.05, 0.71};  // 10 mm into the board
  const std::string complaint = compile_complaint(scene);
  EXPECT_EQ(complaint.find("mug_on_table: object: mug overlaps the obstacle table, and would be "
                           "free of it 10"),
            0U)
      << complaint;
}

TEST(BadArmScene, AnObjectInsideAnObstacleWithoutTouchingIt) {
  json scene = test::scene_json("mug_on_table");
  scene["obstacles"].push_back(test::box_obstacle("crate", {0.3, 0.3, 0.3}, {0.58, 0.05, 0.75}));
  const std::string complaint = compile_complaint(scene);
  EXPECT_EQ(complaint.find("mug_on_table: object: mug overlaps the obstacle crate"), 0U);
}

TEST(BadArmScene, AStartThatCollides) {
  json scene = test::scene_json("mug_on_table");
  scene["robot"]["start"] = {{"arm/shoulder", 0.0}, {"arm/elbow", 0.0}};
  scene["obstacles"].push_back(test::box_obstacle("post", {0.05, 0.05, 0.2}, {0.3, -0.15, 1.1}));
  const std::string what = compile_complaint(scene);
  EXPECT_EQ(what.rfind("mug_on_table: robot.start: arm/", 0), 0U) << what;
  EXPECT_NE(what.find("collides with "), std::string::npos) << what;
}

TEST(BadArmScene, AStartInsideAnObstacle) {
  json scene = test::scene_json("mug_on_table");
  // In the middle of the arm's pedestal, where it touches no surface.
  scene["obstacles"].push_back(test::box_obstacle("cube", {0.02, 0.02, 0.02}, {0.0, 0.0, 0.2}));
  const std::string what = compile_complaint(scene);
  EXPECT_EQ(what, "mug_on_table: robot.start: arm/pedestal collides with cube");
}

TEST(BadArmScene, AStartOfALoadedSceneOutsideLimits) {
  Scene scene = load_scene(test::library_scene("mug_on_table"));
  scene.carrier->start[1] = 99.0;
  try {
    (void)compile(scene);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("arm/shoulder: outside the limits"), std::string::npos)
        << error.what();
    EXPECT_NE(std::string(error.what()).find("99.0"), std::string::npos) << error.what();
  }
}

// A scene of the library with one field changed.
struct BadArm {
  const char* label;
  const char* pointer;
  const char* value;
  const char* complaint;
};

void PrintTo(const BadArm& bad, std::ostream* stream) { *stream << bad.label; }

class BadArmField : public testing::TestWithParam<BadArm> {};

TEST_P(BadArmField, IsRefusedInOneLineThatNamesFileFieldAndValue) {
  json scene = test::scene_json("mug_on_table");
  scene[json::json_pointer(GetParam().pointer)] = json::parse(GetParam().value);
  const std::string what = complaint(scene);
  EXPECT_EQ(what.rfind(GetParam().complaint, 0), 0U) << what;
}

INSTANTIATE_TEST_SUITE_P(
    Corpus, BadArmField,
    testing::Values(
        BadArm{"StartOutsideLimits", "/robot/start", R"({"arm/waist": 9})",
               "robot.start.arm/waist: outside the limits -"},
        BadArm{"StartOutsideNarrowedLimits", "/robot",
               R"({"platform": "puma560_barrett", "start": {"arm/waist": 0.5},
                   "limits": {"arm/waist": [0, 0.4]}})",
               "robot.start.arm/waist: outside the limits 0.000000 to 0.400000 rad or m (0.5)"},
        BadArm{"StartOfUnknownDof", "/robot/start", R"({"arm/thumb": 0})",
               "robot.start.arm/thumb: no degree of freedom is called arm/thumb in "
               "puma560_barrett (0)"},
        BadArm{"StartWithoutRobotName", "/robot/start", R"({"waist": 0})",
               "robot.start.waist: no degree of freedom is called waist"},
        BadArm{"StartIsText", "/robot/start", R"({"arm/waist": "left"})",
               R"(robot.start.arm/waist: must be a number ("left"))"},
        BadArm{"LimitsOfUnknownDof", "/robot/limits", R"({"base/x": [0, 1]})",
               "robot.limits.base/x: no degree of freedom is called base/x"},
        BadArm{"WiderLimits", "/robot/limits", R"({"arm/waist": [-9, 1]})",
               "robot.limits.arm/waist: must be within the robot's own limits -"},
        BadArm{"LimitsWrongWayRound", "/robot/limits", R"({"arm/waist": [1, 0]})",
               "robot.limits.arm/waist: the lower limit must be at most the upper one ([1,0])"},
        BadArm{"OneLimit", "/robot/limits", R"({"arm/waist": [1]})",
               "robot.limits.arm/waist: must be a list of 2 numbers ([1])"},
        BadArm{"HandBesideRobot", "/hand", R"("barrett")",
               R"(hand: not beside "robot", whose platform has a hand ("barrett"))"},
        BadArm{"NoHand", "/robot/platform", R"("puma560")",
               "robot.platform: puma560: robots: none"},
        BadArm{"OnlyAHand", "/robot/platform", R"("barrett")",
               R"(robot.platform: nothing carries the hand ("barrett"))"},
        BadArm{"MissingPlatform", "/robot/platform", R"("tentacle")",
               "robot.platform: neither a file nor one of allegro, "},
        BadArm{"MissingHand", "/robot/hand", R"("tentacle")",
               "robot.hand: neither a file nor one of allegro, "},
        BadArm{"NoPlatform", "/robot", "{}", "robot.platform: must be given"},
        BadArm{"UnknownField", "/robot/speed", "1",
               "robot.speed: unknown field, known here are platform, hand, pose, start, limits, "
               "stands_on (1)"}),
    [](const auto& bad) { return std::string(bad.param.label); });

}  // namespace
}  // namespace prehend
