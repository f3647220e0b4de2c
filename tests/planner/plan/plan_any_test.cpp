// Plans for several objects that stand together.
#include "planner/plan/plan_any.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/refusal_of.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

struct PlacedBox {
  std::string name;
  Vector3 size;
  Vector3 at;
};

// One scene for each of the boxes: the others, and the walls, are obstacles.
std::vector<CompiledScene> scenes_of(const std::vector<PlacedBox>& boxes,
                                     const std::vector<PlacedBox>& walls) {
  std::vector<CompiledScene> scenes;
  for (const PlacedBox& chosen : boxes) {
    Scene scene = test::scene_with(find_robot("parallel_jaw"), make_box(chosen.size));
    scene.object.name = chosen.name;
    scene.object.X_WO = translation(chosen.at);
    for (const std::vector<PlacedBox>* all : {&boxes, &walls}) {
      for (const PlacedBox& other : *all) {
        if (other.name == chosen.name) continue;
        scene.obstacles.push_back(test::obstacle(make_box(other.size), other.at));
        scene.obstacles.back().name = other.name;
      }
    }
    scenes.push_back(compile(std::move(scene)));
  }
  return scenes;
}

// A cube in a pit of four walls, open above, which a lid or two close.
const std::vector<PlacedBox> kPit = {{"north", {0.3, 0.02, 0.3}, {0.0, 0.08, 0.05}},
                                     {"south", {0.3, 0.02, 0.3}, {0.0, -0.08, 0.05}},
                                     {"east", {0.02, 0.12, 0.3}, {0.14, 0.0, 0.05}},
                                     {"west", {0.02, 0.12, 0.3}, {-0.14, 0.0, 0.05}},
                                     {"floor", {0.3, 0.18, 0.02}, {0.0, 0.0, -0.111}}};
const PlacedBox kCube = {"cube", {0.04, 0.04, 0.06}, {0.0, 0.0, -0.07}};
const PlacedBox kFar = {"far", {0.04, 0.04, 0.06}, {1.0, 0.0, 0.0}};

PlanOptions few() {
  PlanOptions options;
  options.search.trials = 60;
  options.rank.top = 5;
  options.refine.trials = 0;
  options.volumes = false;
  return options;
}

TEST(PlanAny, AllGraspsAreRankedTogether) {
  const std::vector<CompiledScene> scenes = scenes_of({kCube, kFar}, kPit);
  const AnyPlan any = plan_any(scenes, few());
  ASSERT_EQ(any.results.size(), 2U);
  EXPECT_FALSE(any.results[0].grasps.empty());
  EXPECT_FALSE(any.results[1].grasps.empty());
  EXPECT_EQ(any.ranked.size(), any.results[0].grasps.size() + any.results[1].grasps.size());
  std::vector<int> next = {0, 0};
  for (const AnyGrasp& one : any.ranked) {
    EXPECT_EQ(one.grasp, next[static_cast<std::size_t>(one.scene)]++);
  }
  EXPECT_EQ(any.first, (std::vector<std::vector<std::string>>(2)));
}

TEST(PlanAny, NamesTheOneThatMustGoFirst) {
  const PlacedBox lid = {"lid", {0.25, 0.13, 0.02}, {0.0, 0.0, 0.0}};
  const AnyPlan any = plan_any(scenes_of({kFar, kCube, lid}, kPit), few());
  EXPECT_TRUE(any.results[1].grasps.empty());
  EXPECT_EQ(any.first[1], std::vector<std::string>{"lid"});
  EXPECT_TRUE(any.first[0].empty());
  const AnyPlan again = plan_any(scenes_of({kFar, kCube, lid}, kPit), few(), {.threads = 2});
  EXPECT_EQ(again.first, any.first);
}

TEST(PlanAny, NamesTheFewestOfSeveral) {
  const PlacedBox upper = {"upper", {0.25, 0.13, 0.02}, {0.0, 0.0, 0.05}};
  const PlacedBox lower = {"lower", {0.25, 0.13, 0.02}, {0.0, 0.0, 0.0}};
  const AnyPlan any = plan_any(scenes_of({kFar, kCube, upper, lower}, kPit), few());
  EXPECT_EQ(any.first[1], (std::vector<std::string>{"upper", "lower"}));
}

TEST(PlanAny, WhatNoOtherObjectBlocksHasNoneThatGoesFirst) {
  std::vector<PlacedBox> closed = kPit;
  closed.push_back({"cover", {0.25, 0.13, 0.02}, {0.0, 0.0, 0.0}});
  const AnyPlan any = plan_any(scenes_of({kFar, kCube}, closed), few());
  EXPECT_TRUE(any.results[1].grasps.empty());
  EXPECT_TRUE(any.first[1].empty());
}

TEST(PlanAny, ObjectsNeedNamesOfTheirOwn) {
  const std::vector<CompiledScene> scenes = scenes_of({kFar, kFar}, {});
  EXPECT_STREQ(test::refusal_of([&] { (void)plan_any(scenes, few()); }).what(),
               "scenes: two have an object of the same name (far)");
}

}  // namespace
}  // namespace prehend
