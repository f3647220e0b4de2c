// What is written is what is read, and what does not fit is complained of.
#include "planner/results/grasps_file.h"

#include <cmath>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/base/input_error.h"
#include "sim/base/json/json_field.h"
#include "sim/robot/files/robot_file.h"
#include "sim/scene/compiled_scene.h"
#include "tests/support/library_scenes.h"

namespace prehend {
namespace {

using Json = nlohmann::ordered_json;

JsonFile file_with(const std::string& text) {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(test.test_suite_name()) + "_" + test.name();
  for (char& c : name) c = c == '/' ? '_' : c;
  const std::filesystem::path file = testing::TempDir() + "/" + name + ".json";
  std::ofstream(file) << text;
  return JsonFile(file);
}

// A grasp with a value of its own in every field that is read.
ScoredGrasp some_grasp(const CompiledScene& scene) {
  const Robot& hand = scene.scene.hand;
  ScoredGrasp grasp;
  grasp.trial.outcome = Outcome::stable;
  grasp.trial.X_OH = translation({0.1, -0.2, 0.3}) * Eigen::AngleAxisd(0.3, Vector3::UnitY());
  grasp.trial.travel = 0.07;
  grasp.trial.overlap_shift = {1e-3, -2e-4, 0.0};
  grasp.trial.back_offs = 2;
  grasp.trial.pushed = {2e-3, 0.0, -4e-3};
  grasp.trial.turned = 0.14;
  grasp.trial.slid = 6e-3;
  grasp.trial.dofs = hand.hand->preshapes[1].dofs;
  grasp.trial.dofs[1] += 0.25;
  grasp.trial.joints = joint_values(hand, grasp.trial.dofs);
  grasp.trial.epsilon.lower = 0.125;
  grasp.trial.epsilon.weakest << 0.1, 0.2, 0.3, -0.1, -0.2, -0.3;
  GraspContact contact;
  contact.link = link_id(3);
  contact.point = {{0.01, 0.02, 0.03}, Vector3::UnitX(), 0.75, ContactModel::soft_finger, 0.004};
  contact.gap = 6e-5;
  GraspContact hard;
  hard.link = link_id(1);
  hard.point = {{-0.01, 0.02, 0.03}, -Vector3::UnitX(), 0.5};
  grasp.trial.contacts = {contact, hard};
  grasp.candidate.preshape = 1;
  grasp.candidate.strategy = 1;
  grasp.candidate.approach_O = Vector3(0.6, 0.0, 0.8);
  grasp.candidate.approach_distance = 0.2;
  grasp.volume = 0.0625;
  grasp.epsilon_nearby = Interval{0.125, 0.25};
  grasp.primitive = 1;
  grasp.rule = "cylinder side, thumb across";
  return grasp;
}

PlanResult some_result(const CompiledScene& scene) {
  PlanResult result;
  result.primitives = {{Box{Vector3(0.1, 0.2, 0.3)}, translation({0, 0, 0.1})},
                       {Cylinder{0.04, 0.1}, Pose::Identity()},
                       {Sphere{0.03}, translation({0.2, 0, 0})}};
  result.grasps = {some_grasp(scene), some_grasp(scene)};
  // One that was given as numbers and does not hold.
  ScoredGrasp& given = result.grasps[1];
  given.trial.outcome = Outcome::not_force_closure;
  given.trial.epsilon = {};
  given.candidate.preshape.reset();
  given.candidate.dofs = given.trial.dofs;
  given.candidate.joints = given.trial.joints;
  given.volume = 0.0;
  given.primitive.reset();
  given.rule = "given";
  result.outcomes = {5, 4, 3, 2, 1, 0, 0, 6};
  result.blockers = {{Outcome::hand_blocked, "palm", "mug", 2}};
  result.stages = {{PlanCount::primitives, 3}, {PlanCount::trials, 21}};
  result.status = PlanStatus::cancelled;
  result.untested = 12;
  return result;
}

RunRecord some_record() {
  RunRecord record;
  record.scene = "mug";
  record.unit = "mm";
  record.hand = "barrett";
  record.options.seed = 18446744073709551615U;  // the largest
  record.options.rank.top = 7;
  record.options.trial.contacts = ContactKind::hard;
  record.options.trial.cone_edges = 12;
  record.options.trial.back_off_step = 0.01;
  record.options.primitives.tolerance = 0.07;
  record.options.search.local_fraction = 0.2;
  record.options.paths.emplace();
  record.options.paths->transfer.planner = PathPlanner::rrt_star;
  record.options.paths->transfer.max_iterations = 50;
  return record;
}

void expect_near(const Json& a, const Json& b, const std::string& where) {
  if (a.is_number() && b.is_number()) {
    EXPECT_NEAR(a.get<double>(), b.get<double>(), 1e-12) << where;
    return;
  }
  ASSERT_EQ(a.type(), b.type()) << where;
  if (!a.is_structured()) {
    EXPECT_EQ(a, b) << where;
    return;
  }
  ASSERT_EQ(a.size(), b.size()) << where;
  for (auto i = a.begin(), j = b.begin(); i != a.end(); ++i, ++j) {
    if (a.is_object()) {
      EXPECT_EQ(i.key(), j.key()) << where;
    }
    expect_near(*i, *j, where + "/" + (a.is_object() ? i.key() : "-"));
  }
}

// A rotation comes back through a quaternion, and so to rounding; all else digit by digit.
TEST(GraspsFile, WhatIsReadIsWrittenAsItWas) {
  const CompiledScene scene = test::compiled_library_scene("mug");
  const std::string first = grasps_json(scene, some_result(scene), some_record());
  const GraspFile read = read_grasps(file_with(first), scene);
  Json a = Json::parse(first);
  Json b = Json::parse(grasps_json(scene, read.result, read.record));
  for (std::size_t g = 0; g < a["grasps"].size(); ++g) {
    for (const char* pose : {"X_object_hand", "X_world_hand"}) {
      expect_near(a["grasps"][g][pose], b["grasps"][g][pose], pose);
      a["grasps"][g].erase(pose);
      b["grasps"][g].erase(pose);
    }
  }
  EXPECT_EQ(a.dump(1), b.dump(1));
  EXPECT_EQ(read.judged, std::vector<bool>({true, true}));
  EXPECT_EQ(read.result.grasps[0].trial.contacts[0].point.model, ContactModel::soft_finger);
  EXPECT_EQ(read.result.grasps[0].trial.contacts[0].point.torsion, 0.004);
  EXPECT_EQ(read.result.grasps[0].trial.contacts[0].link, link_id(3));
  EXPECT_EQ(read.record.options.seed, 18446744073709551615U);
  EXPECT_EQ(read.record.options.trial.contacts, ContactKind::hard);
}

// What is infinite is null: no forces balance the weight, or nothing limits them.
TEST(GraspsFile, TheWeightIsWrittenAndIgnoredByReaders) {
  const CompiledScene scene = test::compiled_library_scene("mug");
  PlanResult result = some_result(scene);
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  result.grasps[0].holding = PayloadMargin{{-Vector3::UnitX(), 12.5, 4.5, kInfinite},
                                           {Vector3::UnitY(), kInfinite, kInfinite, 0.0}};
  const std::string text = grasps_json(scene, result, some_record());
  const Json weight = Json::parse(text)["grasps"][0]["weight"];
  EXPECT_EQ(weight["holds"], true);
  EXPECT_EQ(weight["given"]["down"], Json::array({-1.0, 0.0, 0.0}));
  EXPECT_EQ(weight["given"]["squeeze"], 12.5);
  EXPECT_EQ(weight["given"]["largest_normal"], 4.5);
  EXPECT_TRUE(weight["given"]["strength"].is_null());
  EXPECT_TRUE(weight["worst"]["squeeze"].is_null());
  EXPECT_EQ(weight["worst"]["strength"], 0.0);
  EXPECT_FALSE(Json::parse(text)["grasps"][1].contains("weight"));
  EXPECT_FALSE(read_grasps(file_with(text), scene).result.grasps[0].holding.has_value());
}

TEST(GraspsFile, RobustnessIsWrittenAndIgnoredByReaders) {
  const CompiledScene scene = test::compiled_library_scene("mug");
  PlanResult result = some_result(scene);
  Robustness robustness;
  robustness.samples = 16;
  robustness.held = 12;
  robustness.epsilon_mean = 0.25;
  robustness.epsilon_low = 0.125;
  robustness.outcomes[Outcome::stable] = 14;
  robustness.outcomes[Outcome::no_contact] = 2;
  robustness.position_margin = 2.5e-3;
  robustness.weakest_O = -Vector3::UnitY();
  result.grasps[0].robustness = robustness;
  const std::string text = grasps_json(scene, result, some_record());
  const Json json = Json::parse(text)["grasps"][0]["robustness"];
  EXPECT_EQ(json["samples"], 16);
  EXPECT_EQ(json["held"], 12);
  EXPECT_EQ(json["probability"], 0.75);
  EXPECT_LT(json["interval"][0], 0.75);
  EXPECT_GT(json["interval"][1], 0.75);
  EXPECT_EQ(json["epsilon_mean"], 0.25);
  EXPECT_EQ(json["epsilon_low"], 0.125);
  EXPECT_EQ(json["outcomes"], Json({{"stable", 14}, {"no_contact", 2}}));
  EXPECT_EQ(json["spare"], 2.5e-3);
  EXPECT_EQ(json["weakest"], Json::array({0.0, -1.0, 0.0}));
  EXPECT_FALSE(Json::parse(text)["grasps"][1].contains("robustness"));
  EXPECT_FALSE(read_grasps(file_with(text), scene).result.grasps[0].robustness.has_value());
}

TEST(GraspsFile, OfAnArmPostureAndPathComeBack) {
  const CompiledScene scene = test::compiled_library_scene("mug_on_table");
  const Robot& robot = scene.arm->robot();
  PlanResult result = some_result(scene);
  ScoredGrasp& grasp = result.grasps[0];
  grasp.trial.arm_dofs = initial_dofs(robot);
  const std::vector<double> posture = joint_values(robot, grasp.trial.arm_dofs);
  grasp.path.emplace();
  for (const Joint& joint : robot.joints) grasp.path->joints.push_back(joint.name);
  grasp.path->times = {0.0, 0.25, 1.0};
  grasp.path->positions.assign(3, posture);
  grasp.path->velocities.assign(3, std::vector<double>(posture.size(), 0.125));
  grasp.path->segments = {{"transfer", 0, 1}, {"approach", 1, 2}};
  grasp.lift = LiftEnd::lift_blocked;
  const Json first = Json::parse(grasps_json(scene, result, some_record()));
  const GraspFile read = read_grasps(file_with(first.dump()), scene);
  const Json again = Json::parse(grasps_json(scene, read.result, read.record));
  EXPECT_EQ(first["grasps"][0]["path"].dump(), again["grasps"][0]["path"].dump());
  EXPECT_EQ(first["grasps"][0]["lift"], "lift_blocked");
  EXPECT_EQ(read.result.grasps[0].lift, LiftEnd::lift_blocked);
  EXPECT_FALSE(again["grasps"][1].contains("lift"));
  EXPECT_EQ(first["grasps"][0]["arm_dofs"].dump(), again["grasps"][0]["arm_dofs"].dump());
  EXPECT_FALSE(again["grasps"][1].contains("path"));
}

TEST(GraspsFile, APoseAndAnOpeningAreEnough) {
  const CompiledScene scene = test::compiled_library_scene("mug");
  const JsonFile file = file_with(
      R"({"scene": "mug", "grasps": [{"X_object_hand": {"position": [0, 0, 1]}, "preshape": "spread_0"},
          {"X_world_hand": {"position": [0, 0, 1]}, "dofs": [0, 0, 0, 0], "epsilon": 0.5}]})");
  EXPECT_EQ(read_scene_reference(file).scene, "mug");
  const GraspFile read = read_grasps(file, scene);
  ASSERT_EQ(read.result.grasps.size(), 2U);
  EXPECT_EQ(read.judged, std::vector<bool>({false, true}));
  EXPECT_EQ(read.result.grasps[1].trial.outcome, Outcome::stable);
  const Hand& hand = *scene.scene.hand.hand;
  for (const Candidate& candidate : given_candidates(read, scene)) {
    EXPECT_EQ(candidate.approach_distance, 0.0);
    EXPECT_TRUE(candidate.approach_O.isApprox(candidate.X_OH.linear() * hand.approach));
  }
  EXPECT_EQ(read.result.grasps[0].candidate.preshape, 0);
  EXPECT_EQ(read.result.grasps[1].candidate.dofs, std::vector<double>(4, 0.0));
}

// The file above with one value changed.
struct Mistake {
  const char* name;
  const char* pointer;
  const char* value;
  const char* complaint;
};

void PrintTo(const Mistake& mistake, std::ostream* stream) { *stream << mistake.name; }

class GraspsFileMistakes : public testing::TestWithParam<Mistake> {};

TEST_P(GraspsFileMistakes, NameFileGraspAndField) {
  const CompiledScene scene = test::compiled_library_scene("mug");
  nlohmann::json json =
      nlohmann::json::parse(grasps_json(scene, some_result(scene), some_record()));
  json[nlohmann::json::json_pointer(GetParam().pointer)] = nlohmann::json::parse(GetParam().value);
  const JsonFile file = file_with(json.dump());
  try {
    (void)read_grasps(file, scene);
    FAIL() << "no error";
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_EQ(what.rfind(file.path().string() + ": " + GetParam().complaint, 0), 0U) << what;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Corpus, GraspsFileMistakes,
    testing::Values(
        Mistake{"Link", "/grasps/1/contacts/0/link", R"("elbow")",
                "grasps[1].contacts[0].link: must be one of palm, "},
        Mistake{"Model", "/grasps/0/contacts/1/model", R"("rubber")",
                "grasps[0].contacts[1].model: must be one of frictionless, point, soft_finger"},
        Mistake{"Outcome", "/grasps/0/outcome", R"("Stable")",
                "grasps[0].outcome: must be one of stable, not_force_closure, no_contact"},
        Mistake{"Strategy", "/grasps/0/strategy", R"("rough")",
                "grasps[0].strategy: must be one of gentle, thumb_first"},
        Mistake{"Preshape", "/grasps/0/preshape", R"("spread")",
                "grasps[0].preshape: must be one of spread_0, "},
        Mistake{"Normal", "/grasps/0/contacts/1/normal", "[0, 0, 2]",
                "grasps[0].contacts[1].normal: not unit (0, 0, 2)"},
        Mistake{"NoTorsion", "/grasps/0/contacts/0",
                R"({"link": "palm", "position": [0, 0, 0], "normal": [0, 0, 1], "friction": 1,
                    "model": "soft_finger"})",
                "grasps[0].contacts[0]: a soft_finger needs torsion"},
        Mistake{"GraspField", "/grasps/0/contact", "[]", "grasps[0].contact: unknown field"},
        Mistake{"ContactField", "/grasps/0/contacts/0/mu", "1",
                "grasps[0].contacts[0].mu: unknown field"},
        Mistake{"ApproachField", "/grasps/0/approach/speed", "1",
                "grasps[0].approach.speed: unknown field"},
        Mistake{"RootField", "/grasp", "[]", "grasp: unknown field"},
        Mistake{"SceneField", "/scene/mesh", "1", "scene.mesh: unknown field"},
        Mistake{"Setting", "/settings/cone_edge", "8", "settings.cone_edge: unknown field"},
        Mistake{"Status", "/status", R"("done")", "status: must be one of complete, out_of_time"},
        Mistake{"Stage", "/stages/0/name", R"("thinking")",
                "stages[0].name: must be one of primitives given"},
        Mistake{"Format", "/format", R"("prehend grasps 2")",
                "format: must be one of prehend grasps 1"},
        Mistake{"Primitive", "/grasps/0/primitive/index", "3",
                "grasps[0].primitive.index: must be the place of one of the file's primitives"},
        Mistake{"Dofs", "/grasps/0/dofs", "[100, 0, 0, 0]", "grasps[0].dofs: "},
        Mistake{"Joints", "/grasps/0/joints/2", "100", "grasps[0].joints[2]: "},
        Mistake{"Distance", "/grasps/0/approach/distance", "-1",
                "grasps[0].approach.distance: must not be negative"},
        Mistake{"Outcomes", "/outcomes/fine", "1", "outcomes.fine: unknown field"},
        Mistake{"BlockerOutcome", "/blockers/0/outcome", R"("stuck")",
                "blockers[0].outcome: must be one of stable"},
        Mistake{"NoFriction", "/grasps/0/contacts", R"([{"link": "palm"}])",
                "grasps[0].contacts[0].position: must be given"}),
    [](const auto& mistake) { return std::string(mistake.param.name); });

}  // namespace
}  // namespace prehend
