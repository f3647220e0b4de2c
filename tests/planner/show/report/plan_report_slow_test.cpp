// What a report says of plans and of given grasps, also of those that came to nothing.
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "planner/plan/plan.h"
#include "planner/results/grasps_file.h"
#include "planner/show/report/plan_report.h"
#include "tests/planner/show/report/page_data.h"
#include "tests/support/block_on_table.h"
#include "tests/support/held_cube.h"

namespace prehend {
namespace {

using test::block_on_table;
using test::data_of;
using test::expect_numbers;
using test::held_cube;
using test::HeldCube;

// Without what takes long to find out.
constexpr std::size_t kBrief = 0;  // grasps in detail

PlanOptions few_candidates() {
  PlanOptions options;
  options.search.trials = 30;
  options.sections = 3;
  return options;
}

int count_in(const PlanResult& result, Outcome outcome) { return result.outcomes[outcome]; }

// Every candidate is counted once, in all that a result and its report say.
void expect_counted(const PlanResult& result, const nlohmann::json& data) {
  EnumArray<Outcome, int> tried;
  for (const Tried& one : result.tried) ++tried[one.outcome];
  EXPECT_EQ(tried, result.outcomes);
  EnumArray<Outcome, int> drawn;
  for (const nlohmann::json& row : data["candidates"]["rows"]) {
    ASSERT_EQ(row.size(), 8U);
    expect_numbers(row, "candidate");
    ++drawn.entries.at(row[6].get<std::size_t>());
    EXPECT_LT(row[7].get<std::size_t>(), data["candidates"]["blames"].size());
  }
  EXPECT_EQ(drawn, result.outcomes);
  EXPECT_EQ(data["candidates"]["in_all"], result.tried.size());
  ASSERT_EQ(data["outcomes"].size(), kAll<Outcome>.size());
  for (std::size_t i = 0; i < kAll<Outcome>.size(); ++i) {
    EXPECT_EQ(data["outcomes"][i]["name"], name_of(kAll<Outcome>[i]));
    EXPECT_EQ(data["outcomes"][i]["count"], result.outcomes.entries[i]);
    EXPECT_FALSE(data["outcomes"][i]["meaning"].get<std::string>().empty());
  }
}

// No number of a grasp is missing.
void expect_numbers_of(const nlohmann::json& grasp) {
  for (const char* field : {"epsilon", "volume", "weakest_force", "weakest_torque", "primitive"}) {
    expect_numbers(grasp[field], field);
  }
  for (const nlohmann::json& contact : grasp["contacts"]) {
    for (const char* field : {"p", "n", "mu", "gap"}) expect_numbers(contact[field], field);
  }
  for (const char* field : {"X_OH", "times", "rows"}) expect_numbers(grasp["motion"][field], field);
  EXPECT_EQ(grasp["motion"]["times"].size(), grasp["motion"]["rows"].size());
}

PlanResult planned(const CompiledScene& scene) { return plan(scene, few_candidates()); }

TEST(PlanReport, CancelledBeforehandThrows) {
  const CompiledScene scene = held_cube().scene;
  const PlanResult result = planned(scene);
  RunContext context;
  context.cancellation.request();
  EXPECT_THROW(plan_report(scene, result, {}, kMostDetailed, context), Cancelled);
}

TEST(PlanReport, IsTheSameOnOneAndTwoThreads) {
  const CompiledScene scene = held_cube().scene;
  const PlanResult result = planned(scene);
  ASSERT_GE(result.grasps.size(), 4U);
  const std::string one =
      report_html(plan_report(scene, result, {}, kMostDetailed, {.threads = 1}));
  EXPECT_EQ(one, report_html(plan_report(scene, result, {}, kMostDetailed, {.threads = 2})));
  const nlohmann::json data = data_of(one);
  expect_counted(result, data);
  ASSERT_EQ(data["grasps"].size(), result.grasps.size());
  for (std::size_t i = 0; i < result.grasps.size(); ++i) {
    const nlohmann::json& grasp = data["grasps"][i];
    expect_numbers_of(grasp);
    EXPECT_EQ(grasp["outcome"], "stable");
    EXPECT_NEAR(grasp["epsilon"][0].get<double>(), result.grasps[i].trial.epsilon.lower, 1e-6);
    EXPECT_EQ(grasp["contacts"].size(), result.grasps[i].trial.contacts.size());
    EXPECT_EQ(grasp["detail"]["without"].size(), grasp["contacts"].size());
    std::set<LinkId> links;
    for (const GraspContact& contact : result.grasps[i].trial.contacts) links.insert(contact.link);
    EXPECT_EQ(grasp["detail"]["links"].size(), links.size());
    // Sections are those of the result, which has three.
    EXPECT_EQ(grasp["detail"]["forces"]["triangles"].empty(), i >= 3);
    expect_numbers(grasp["side"], "side");
  }
}

TEST(PlanReport, SaysHowFarTheSurfaceIsFromItsPrimitives) {
  const CompiledScene scene = test::compiled_library_scene("mug");
  PlanResult result = planned(scene);
  ASSERT_TRUE(result.solids);
  const std::size_t solids = result.solids->primitives.size();
  ASSERT_LT(solids, result.primitives.size());
  const nlohmann::json data = data_of(plan_report(scene, result, {}, kBrief));
  ASSERT_EQ(data["primitives"].size(), result.primitives.size());
  EXPECT_NEAR(data["distances"]["median"], result.solids->distances.median, 1e-8);
  for (std::size_t k = 0; k < solids; ++k) {
    const nlohmann::json& told = data["primitives"][k]["distances"];
    EXPECT_NEAR(told["median"], result.solids->distances_of[k].median, 1e-8);
    EXPECT_NEAR(told["percentile_95"], result.solids->distances_of[k].percentile_95, 1e-8);
  }
  // Rims and bars are not measured, nor is what a scene states.
  EXPECT_TRUE(data["primitives"].back()["distances"].is_null());
  result.solids.reset();
  const nlohmann::json stated = data_of(plan_report(scene, result, {}, kBrief));
  EXPECT_TRUE(stated["distances"].is_null());
  EXPECT_TRUE(stated["primitives"][0]["distances"].is_null());
}

TEST(PlanReport, WithoutAGraspTheCandidatesAreThere) {
  const auto wall = [](const Vector3& size, const Vector3& at) {
    return test::obstacle(make_box(size), at);
  };
  std::vector<StaticBody> crate;
  for (const double side : {-1.0, 1.0}) {
    crate.push_back(wall({0.01, 0.08, 0.08}, {0.033 * side, 0, 0}));
    crate.push_back(wall({0.08, 0.01, 0.08}, {0, 0.033 * side, 0}));
    crate.push_back(wall({0.08, 0.08, 0.01}, {0, 0, 0.033 * side}));
  }
  const CompiledScene scene = held_cube(std::move(crate)).scene;
  const PlanResult result = planned(scene);
  ASSERT_TRUE(result.grasps.empty());
  ASSERT_FALSE(result.tried.empty());
  EXPECT_EQ(count_in(result, Outcome::stable), 0);
  const nlohmann::json data = data_of(plan_report(scene, result, {}, kBrief));
  expect_counted(result, data);
  EXPECT_TRUE(data["grasps"].empty());
  EXPECT_EQ(data["scene"]["obstacles"].size(), 6U);
  ASSERT_FALSE(data["blockers"].empty());
  EXPECT_EQ(data["blockers"][0]["by"], "obstacle");
}

TEST(PlanReport, OfGivenGraspsHowTheyEnded) {
  const CompiledScene scene =
      held_cube({test::obstacle(make_box({0.02, 0.02, 0.02}), Vector3(0, 0, 0.3))}).scene;
  std::vector<Candidate> candidates(4, test::from_above());
  candidates[1].X_OH.translation().x() = 1.0;  // in the air
  candidates[2].X_OH.translation().z() = 0.0;  // in the cube
  candidates[2].approach_distance = 0.0;
  candidates[3].X_OH.translation().z() = 0.3;  // through the obstacle
  const PlanResult result = evaluate(scene, candidates);
  const nlohmann::json data = data_of(plan_report(scene, result, {}));
  expect_counted(result, data);
  const std::vector<std::string> outcomes = {"stable", "no_contact", "hand_blocked",
                                             "approach_blocked"};
  ASSERT_EQ(data["grasps"].size(), outcomes.size());
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const nlohmann::json& grasp = data["grasps"][i];
    EXPECT_EQ(grasp["outcome"], outcomes[i]);
    EXPECT_EQ(grasp["force_closure"], i == 0);
    EXPECT_EQ(grasp["contacts"].empty(), i != 0);
    EXPECT_EQ(grasp["detail"]["without"].empty(), i != 0);
    EXPECT_EQ(grasp["origin"], "given");
    EXPECT_EQ(grasp["blame"].get<std::string>().empty(), i < 2);
    expect_numbers_of(grasp);
  }
  EXPECT_NE(data["grasps"][2]["blame"].get<std::string>().find(" met object"), std::string::npos);
  EXPECT_NE(data["grasps"][3]["blame"].get<std::string>().find(" met obstacle"), std::string::npos);
}

TEST(PlanReport, OfNoGraspsAtAll) {
  const CompiledScene scene = held_cube().scene;
  const PlanResult result = evaluate(scene, {});
  const nlohmann::json data = data_of(plan_report(scene, result, {}));
  expect_counted(result, data);
  EXPECT_TRUE(data["grasps"].empty());
}

TEST(PlanReport, AnObjectWithoutANameHasATitle) {
  HeldCube held = held_cube();
  held.scene.scene.object.name = "";
  const Report report = plan_report(held.scene, evaluate(held.scene, {}), {});
  EXPECT_EQ(report.title, "object, " + held.scene.scene.hand.name);
}

// The hand closes on nothing of its own, so its motion goes straight.
TEST(PlanReport, AHandWithoutClosingVelocities) {
  Robot hand = find_robot("parallel_jaw");
  for (DegreeOfFreedom& dof : hand.dofs) dof.closing_velocity = 0.0;
  const CompiledScene scene = test::compiled(std::move(hand), make_box(Vector3::Constant(0.05)));
  const PlanResult result = evaluate(scene, {test::from_above()});
  const nlohmann::json data = data_of(plan_report(scene, result, {}));
  ASSERT_EQ(data["grasps"].size(), 1U);
  EXPECT_NE(data["grasps"][0]["outcome"], "stable");
  expect_numbers_of(data["grasps"][0]);
}

// With a path that moves the whole arm in 600 steps.
ScoredGrasp long_grasp(const CompiledScene& scene) {
  const test::Grasp grasp = test::stable_grasp(scene);
  ScoredGrasp scored;
  scored.trial = grasp.trial;
  scored.candidate = grasp.candidate;
  scored.rule = "given";
  while (scored.trial.contacts.size() < 24) {
    scored.trial.contacts.push_back(scored.trial.contacts.front());
  }
  Random random(3);
  scored.path.emplace();
  for (int i = 0; i < 600; ++i) {
    scored.path->times.push_back(0.0123 * i);
    scored.path->positions.emplace_back();
    for (const Joint& joint : scene.arm->robot().joints) {
      scored.path->positions.back().push_back(random.uniform(joint.lower, joint.upper));
    }
  }
  scored.path->segments = {{"transfer", 0, 400}, {"approach", 400, 500}, {"close", 500, 599}};
  return scored;
}

TEST(PlanReport, OfAThousandGraspsIsNotTooLarge) {
  const CompiledScene scene = compile(block_on_table());
  PlanResult result;
  result.grasps.assign(1000, long_grasp(scene));
  result.tried.assign(1000, {0,
                             Pose::Identity(),
                             Vector3(0.6, 0.0, 0.8),
                             Outcome::hand_blocked,
                             {"finger_1/distal", "a table"}});
  const std::string html = report_html(plan_report(scene, result, {}, kBrief));
  EXPECT_LT(html.size(), 10'000'000U);
  const nlohmann::json data = data_of(html);
  ASSERT_EQ(data["grasps"].size(), 1000U);
  EXPECT_GE(data["grasps"][999]["motion"]["rows"].size(), 20U);
  // Fewer grasps have more frames.
  result.grasps.resize(10);
  const nlohmann::json few = data_of(plan_report(scene, result, {}, kBrief));
  EXPECT_GE(few["grasps"][9]["motion"]["rows"].size(), 100U);
}

TEST(PlanReport, SaysWhatShakingShowed) {
  const HeldCube held = held_cube();
  PlanResult result;
  ScoredGrasp scored;
  scored.trial = held.trial;
  scored.candidate = test::from_above();
  result.grasps.assign(2, scored);
  ShakeTestReport tug;
  tug.name = "tug";
  tug.outcome = ShakeOutcome::moved;
  tug.failed_at = 0.5;
  tug.phases = {{.kind = PhaseKind::hold, .seconds = 0.5, .moved = 0.006}};
  tug.first_slip = FirstSlip{"pad", 0.25};
  tug.largest_pull = 12.5;
  result.grasps[0].shake = ShakeReport{.procedure = "strength", .tests = {tug}, .effort = {}};
  const nlohmann::json data = data_of(plan_report(held.scene, result, {}, kBrief));
  const nlohmann::json& shake = data["grasps"][0]["shake"];
  EXPECT_EQ(shake["survived"], 0);
  EXPECT_EQ(shake["largest_pull"], 12.5);
  EXPECT_EQ(shake["tests"][0]["outcome"], "moved");
  EXPECT_EQ(shake["tests"][0]["first_slip"]["link"], "pad");
  EXPECT_FALSE(data["grasps"][1].contains("shake"));
}

TEST(PlanReport, OfMoreGraspsAndCandidatesSomeAreShown) {
  const HeldCube held = held_cube();
  PlanResult result;
  ScoredGrasp scored;
  scored.trial = held.trial;
  scored.candidate = test::from_above();
  result.grasps.assign(1500, scored);
  for (int i = 0; i < 10001; ++i) {
    result.tried.push_back(
        {i, translation(Vector3(i, 0, 0)), -Vector3::UnitZ(), Outcome::stable, {}});
  }
  const Report report = plan_report(held.scene, result, {}, kBrief);
  EXPECT_EQ(report.grasps.size(), 1000U);
  EXPECT_EQ(report.grasps_in_all, 1500U);
  EXPECT_EQ(report.candidates_in_all, 10001U);
  ASSERT_EQ(report.candidates.size(), 4000U);
  for (std::size_t i = 1; i < report.candidates.size(); ++i) {
    const double step = report.candidates[i].p_O.x() - report.candidates[i - 1].p_O.x();
    EXPECT_TRUE(step == 2.0 || step == 3.0) << step;
  }
}

// A search without a step finds only what lies straight ahead.
TEST(PlanReport, AGraspWithoutAPathIsCountedAsSuch) {
  const CompiledScene scene = test::compiled_library_scene("cluttered_table");
  PlanOptions options = few_candidates();
  options.search.trials = 400;
  options.rank.top = 1000;
  options.paths.emplace();
  options.paths->alternatives = 1;
  options.paths->transfer.max_iterations = 1;
  const PlanResult result = plan(scene, options);
  EXPECT_GT(count_in(result, Outcome::no_path), 0);
  EXPECT_GT(count_in(result, Outcome::unreachable), 0);
  const nlohmann::json data = data_of(plan_report(scene, result, {}, kBrief));
  expect_counted(result, data);
  for (std::size_t i = 0; i < result.grasps.size(); ++i) {
    const auto tried = static_cast<std::size_t>(result.grasps[i].tried);
    EXPECT_EQ(result.tried[tried].outcome, Outcome::stable);
    EXPECT_TRUE(data["grasps"][i]["motion"]["on_arm"]);
    expect_numbers_of(data["grasps"][i]);
  }
}

// A hand that the arm cannot bring there is shown without the arm.
TEST(PlanReport, OfAGraspOutOfReach) {
  const CompiledScene scene = compile(block_on_table());
  Candidate far = test::from_above(scene.scene.hand, 0.0);
  far.X_OH.translation().x() += 5.0;
  const PlanResult result = evaluate(scene, {far});
  EXPECT_EQ(count_in(result, Outcome::unreachable), 1);
  const nlohmann::json data = data_of(plan_report(scene, result, {}));
  expect_counted(result, data);
  ASSERT_EQ(data["grasps"].size(), 1U);
  EXPECT_FALSE(data["grasps"][0]["motion"]["on_arm"]);
  expect_numbers_of(data["grasps"][0]);
}

}  // namespace
}  // namespace prehend
