// What a plan without a grasp says: each hint where it applies and not where it does not.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "planner/plan/find_advice.h"
#include "planner/plan/plan.h"
#include "planner/results/grasps_file.h"
#include "sim/base/json/json_field.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/make_scene.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

bool has(const std::vector<Advice>& advice, Hint hint) {
  return std::any_of(advice.begin(), advice.end(),
                     [&](const Advice& one) { return one.hint == hint; });
}

std::string words_of(const std::vector<Advice>& advice, Hint hint) {
  for (const Advice& one : advice) {
    if (one.hint == hint) return one.words;
  }
  return "";
}

std::vector<Hint> hints_of(const PlanResult& result) {
  std::vector<Hint> hints;
  for (const Advice& one : result.advice) hints.push_back(one.hint);
  return hints;
}

// A metal block between rubber plates that do not rub at all.
Scene slippery() {
  Scene scene =
      make_scene(make_graspable("block", make_box(Vector3(0.05, 0.05, 0.05)), Material::metal),
                 "parallel_jaw");
  scene.friction.set(Material::metal, Material::rubber, 0.0);
  return scene;
}

// A plate 220 mm wide and 20 mm high, `gap` above a table.
Scene plate_on_table(double gap) {
  Scene scene =
      make_scene(make_graspable("plate", make_box(Vector3(0.22, 0.22, 0.02)), Material::plastic),
                 "parallel_jaw");
  add_obstacle(scene, "table", make_box(Vector3(1.0, 1.0, 0.1)),
               translation({0.0, 0.0, -0.06 - gap}));
  return scene;
}

// A box that is too wide for the plates of a jaw.
Scene wide_box(const std::string& hand) {
  return make_scene(make_graspable("box", make_box(Vector3(0.12, 0.12, 0.12)), Material::plastic),
                    hand);
}

// Plates that close along an axis touch it at one corner each.
Scene octahedron() {
  TriangleMesh mesh;
  const double r = 0.03;
  mesh.vertices = {{r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}, {0, 0, r}, {0, 0, -r}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return make_scene(make_graspable("octahedron", std::move(mesh), Material::plastic),
                    "parallel_jaw");
}

TEST(Advice, OnFrictionNamesACoefficientWithWhichGraspsHold) {
  Scene scene = slippery();
  const PlanResult result = plan(compile(scene));
  ASSERT_TRUE(result.grasps.empty());
  const std::string words = words_of(result.advice, Hint::friction);
  EXPECT_NE(words.find("it is 0 between rubber (hand) and metal (object); with 0.1, "),
            std::string::npos)
      << words;
  EXPECT_NE(words.find("\"friction\""), std::string::npos);
  scene.friction.set(Material::metal, Material::rubber, 0.1);
  EXPECT_FALSE(plan(compile(std::move(scene))).grasps.empty());
}

TEST(Advice, OnFrictionIsNotGivenWhereNothingTouches) {
  const PlanResult result = plan(compile(plate_on_table(1e-4)));
  ASSERT_TRUE(result.grasps.empty());
  EXPECT_EQ(hints_of(result), std::vector<Hint>{Hint::obstacle});
}

TEST(Advice, OnAnObstacleNamesItAndHelps) {
  const PlanResult result = plan(compile(plate_on_table(1e-4)));
  const std::string words = words_of(result.advice, Hint::obstacle);
  EXPECT_NE(words.find("the obstacle table is in the way: without it, "), std::string::npos)
      << words;
  EXPECT_FALSE(plan(compile(plate_on_table(0.3))).grasps.empty());
}

TEST(Advice, OnAnotherHandNamesOneThatHolds) {
  const CompiledScene scene = compile(wide_box("parallel_jaw"));
  const PlanResult result = plan(scene);
  EXPECT_EQ(result.status, PlanStatus::object_too_large);
  const std::string words = words_of(result.advice, Hint::other_hand);
  const std::string start = "--hand ";
  ASSERT_EQ(words.find(start), 0U) << words;
  const std::string hand = words.substr(start.size(), words.find(',') - start.size());
  EXPECT_NE(words.find("(parallel_jaw: 80 mm)"), std::string::npos) << words;
  EXPECT_FALSE(plan(compile(wide_box(hand))).grasps.empty()) << hand;
  // The program says it in its one line.
  EXPECT_NE(no_candidates_text(scene, result).find("mm; try --hand " + hand), std::string::npos);
}

TEST(Advice, DoesNotNameAHandWhereNoneOpensWideEnough) {
  const PlanResult result = plan(compile(make_scene(
      make_graspable("box", make_box(Vector3(0.5, 0.5, 0.5)), Material::plastic), "parallel_jaw")));
  EXPECT_EQ(result.status, PlanStatus::object_too_large);
  EXPECT_TRUE(result.advice.empty());
}

TEST(Advice, OnSoftContactsIsForThoseWhoLeftThemOut) {
  const CompiledScene scene = compile(octahedron());
  Candidate candidate;
  candidate.X_OH = translation({0.0, 0.0, -0.05});
  candidate.preshape = 0;
  EvaluateOptions evaluated;
  evaluated.trial.settle.steps = 0;
  EXPECT_EQ(evaluate(scene, {candidate}, evaluated).grasps[0].trial.outcome, Outcome::stable);
  evaluated.trial.contacts = ContactKind::hard;
  const PlanResult hard = evaluate(scene, {candidate}, evaluated);
  ASSERT_EQ(hard.grasps[0].trial.outcome, Outcome::not_force_closure);
  PlanOptions options;
  options.trial = evaluated.trial;
  const std::vector<Advice> advice = find_advice(scene, options, hard, {hard.grasps[0].trial});
  EXPECT_EQ(words_of(advice, Hint::soft_contacts),
            "--contacts soft: where rubber counts as a soft finger, 1 of 1 candidates that touch "
            "would hold");
  EXPECT_FALSE(has(plan(compile(slippery()), options).advice, Hint::soft_contacts));
}

TEST(Advice, OnTrialsIsGivenWhereNothingElseHelps) {
  PlanOptions options;
  options.search.trials = 10;
  PlanResult result;
  result.outcomes[Outcome::no_contact] = 10;
  const std::vector<Trial> tried(10);
  // A ball larger than any hand of the library, and tried all the same.
  const Scene scene =
      make_scene(make_graspable("ball", make_sphere(0.3, 2), Material::metal), "parallel_jaw");
  EXPECT_EQ(words_of(find_advice(compile(scene), options, result, tried), Hint::candidates),
            "--trials 40: finer candidates than these 10 were not tried");
  options.search.trials = 11;
  EXPECT_FALSE(has(find_advice(compile(scene), options, result, tried), Hint::candidates));
  EXPECT_FALSE(has(plan(compile(slippery())).advice, Hint::candidates));
}

// A box that is too wide, with a stud on one side that coarse primitives pass over.
TEST(Advice, OnToleranceIsGivenWhereFinerPrimitivesLeadToGrasps) {
  TriangleMesh studded = make_box(Vector3(0.2, 0.2, 0.2));
  append(studded, transformed(make_box(Vector3(0.07, 0.07, 0.02)), translation({0.0, 0.0, 0.11})));
  const CompiledScene scene = compile(
      make_scene(make_graspable("studded", std::move(studded), Material::plastic), "parallel_jaw"));
  PlanOptions options;
  options.primitives.tolerance = 0.1;
  // 0.02 of the diagonal, which is 358 mm long.
  const PlanResult coarse = plan(scene, options);
  ASSERT_TRUE(coarse.grasps.empty());
  EXPECT_EQ(words_of(coarse.advice, Hint::tolerance).find("--primitive-tolerance 7.2: "), 0U);
  options.primitives.tolerance = 0.02;
  EXPECT_FALSE(plan(scene, options).grasps.empty());
  options.primitives.tolerance = 0.1;
  EXPECT_FALSE(has(plan(compile(wide_box("parallel_jaw")), options).advice, Hint::tolerance));
}

TEST(Advice, OnTheArmSaysHowFarTheObjectIs) {
  const auto planned = [](double distance) {
    Scene scene = make_scene(
        make_graspable("block", make_box(Vector3(0.05, 0.05, 0.05)), Material::plastic), "barrett");
    scene.object.X_WO = translation({distance, 0.0, 0.5});
    mount(scene, "puma560_barrett");
    PlanOptions options;
    options.search.trials = 100;
    return plan(compile(std::move(scene)), options);
  };
  const PlanResult far = planned(3.0);
  ASSERT_TRUE(far.grasps.empty());
  const std::string words = words_of(far.advice, Hint::arm);
  EXPECT_NE(words.find("The object is 3.04 m from the robot's base"), std::string::npos) << words;
  EXPECT_FALSE(has(far.advice, Hint::other_hand));
  EXPECT_FALSE(planned(0.6).grasps.empty());
}

TEST(Advice, OnPathsIsGivenWhereOnlyAPathIsMissing) {
  const CompiledScene scene = compile(slippery());
  PlanResult result;
  result.outcomes[Outcome::no_path] = 2;
  const std::vector<Advice> advice = find_advice(scene, {}, result, {});
  ASSERT_EQ(advice.size(), 1U);
  EXPECT_EQ(advice[0].hint, Hint::path);
  EXPECT_EQ(advice[0].words.find("2 grasps hold, but no path"), 0U) << advice[0].words;
  EXPECT_FALSE(has(plan(scene).advice, Hint::path));
}

TEST(Advice, OnTheUnitIsForMeshFilesOfAnUnlikelySize) {
  const auto planned = [](double size) {
    Scene scene =
        make_scene(make_graspable("box", make_box(Vector3(size, size, size)), Material::plastic),
                   "parallel_jaw");
    scene.object.source = MeshFileSource{"/box.obj", "m"};
    return plan(compile(std::move(scene)));
  };
  EXPECT_EQ(words_of(planned(120.0).advice, Hint::unit).find("--unit: "), 0U);
  EXPECT_FALSE(has(planned(0.5).advice, Hint::unit));
}

TEST(Advice, CountsEveryCandidateUnderItsRule) {
  const PlanResult result = plan(compile(slippery()));
  ASSERT_EQ(result.rules.size(), 1U);
  EXPECT_EQ(result.rules[0].rule, "box faces");
  EXPECT_EQ(result.rules[0].outcomes, result.outcomes);
}

TEST(Advice, IsTheSameOnAnyNumberOfThreadsAndComesBackFromTheFile) {
  const CompiledScene scene = compile(slippery());
  const PlanResult one = plan(scene, {}, RunContext{.threads = 1});
  const PlanResult two = plan(scene, {}, RunContext{.threads = 2});
  const std::string text = grasps_json(scene, one, {});
  EXPECT_EQ(text, grasps_json(scene, two, {}));
  const std::filesystem::path file = testing::TempDir() + "/advice.json";
  std::ofstream(file) << text;
  const PlanResult read = read_grasps(JsonFile(file), scene).result;
  ASSERT_EQ(read.advice.size(), one.advice.size());
  EXPECT_EQ(read.advice[0].words, one.advice[0].words);
  EXPECT_EQ(read.rules[0].outcomes, one.rules[0].outcomes);
}

TEST(Advice, IsNotGivenWhereThereAreGrasps) {
  Scene scene = slippery();
  scene.friction = {};
  const CompiledScene ready = compile(std::move(scene));
  const PlanResult result = plan(ready);
  ASSERT_FALSE(result.grasps.empty());
  EXPECT_TRUE(result.advice.empty());
  EXPECT_TRUE(result.rules.empty());
  EXPECT_EQ(grasps_json(ready, result, {}).find("advice"), std::string::npos);
}

}  // namespace
}  // namespace prehend
