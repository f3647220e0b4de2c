#include "planner/show/picture/animated_glb.h"

#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "planner/show/picture/glb_bytes.h"
#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"
#include "tests/support/glb_file.h"
#include "tests/support/refusal_of.h"

namespace prehend::test {
namespace {

AnimatedNode still(const std::string& name, const Pose& X) {
  return {.name = name, .mesh = make_box(Vector3(0.1, 0.2, 0.3)), .X_PN = {X}};
}

// The numbers of the channel of a node; none where it has no such channel.
std::vector<float> keys_of(const Glb& glb, std::size_t node, const std::string& path,
                           std::size_t size, const std::string& interpolation) {
  const nlohmann::json& animation = glb.document["animations"][0];
  for (const nlohmann::json& channel : animation["channels"]) {
    if (channel["target"]["node"] != node || channel["target"]["path"] != path) continue;
    const nlohmann::json& sampler = animation["samplers"][channel["sampler"].get<std::size_t>()];
    EXPECT_EQ(sampler["interpolation"], interpolation);
    return glb.numbers(sampler["output"], size);
  }
  return {};
}

std::string animated(const std::vector<AnimatedNode>& nodes, const std::vector<double>& times) {
  return animated_glb(nodes, times, "film", {});
}

TEST(AnimatedGlb, PosesAreKeysAndQuaternionsNeverTakeTheLongWay) {
  Random random(5);
  AnimatedNode node = still("box", Pose::Identity());
  node.X_PN.clear();
  std::vector<double> times;
  for (int m = 0; m < 50; ++m) {
    node.X_PN.push_back(random.pose(2.0));
    times.push_back(0.5 * m);
  }
  const Glb glb(animated({still("first", random.pose(1.0)), node}, times));
  const std::vector<float> p = keys_of(glb, 1, "translation", 3, "LINEAR");
  const std::vector<float> q = keys_of(glb, 1, "rotation", 4, "LINEAR");
  ASSERT_EQ(p.size(), 150);
  ASSERT_EQ(q.size(), 200);
  Eigen::Quaternionf last = Eigen::Quaternionf::Identity();
  for (std::size_t m = 0; m < 50; ++m) {
    const Eigen::Quaternionf turn(&q[4 * m]);
    EXPECT_TRUE(turn.toRotationMatrix().cast<double>().isApprox(node.X_PN[m].linear(), 1e-6));
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(p[3 * m + k], static_cast<float>(node.X_PN[m].translation()[static_cast<int>(k)]));
    }
    // The first one is compared with itself.
    EXPECT_GE(turn.dot(m > 0 ? last : turn), -1e-6F);
    last = turn;
  }
  const nlohmann::json& sampler = glb.document["animations"][0]["samplers"][0];
  const std::vector<float> seconds = glb.numbers(sampler["input"], 1);
  EXPECT_EQ(seconds, std::vector<float>(times.begin(), times.end()));
  // What stands still has no channels, and programs without animations show the end.
  EXPECT_TRUE(keys_of(glb, 0, "translation", 3, "").empty());
  EXPECT_TRUE(pose_of(glb.node(1)).isApprox(node.X_PN.back(), 1e-12));
}

TEST(AnimatedGlb, WhatComesAndGoesIsScaledInSteps) {
  AnimatedNode node = still("box", Pose::Identity());
  node.shown = {false, true, true, false};
  AnimatedNode always = still("ball", Pose::Identity());
  always.shown = {true, true, true, true};
  AnimatedNode below = still("below", Pose::Identity());
  below.parent = 0;
  const Glb glb(animated({node, always, below}, {0.0, 1.0, 2.0, 3.0}));
  EXPECT_EQ(keys_of(glb, 0, "scale", 3, "STEP"),
            (std::vector<float>{0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0, 0}));
  EXPECT_TRUE(keys_of(glb, 1, "scale", 3, "").empty());
  EXPECT_EQ(glb.document["nodes"][0]["scale"], (std::vector<double>{0, 0, 0}));
  EXPECT_EQ(glb.document["nodes"][0]["children"], (std::vector<int>{2}));
  EXPECT_EQ(glb.root()["children"], (std::vector<int>{0, 1}));
}

TEST(AnimatedGlb, WithoutAnyChangeItIsTheFileOfTheBodies) {
  const Pose X = translation(Vector3(1.0, 2.0, 3.0));
  const AnimatedNode node = still("box", X);
  const std::vector<DrawnBody> bodies = {{node.mesh, X, node.color, "box"}};
  EXPECT_EQ(animated({node}, {0.0, 1.0}), glb_bytes(bodies, "film", {}));
}

TEST(AnimatedGlb, RefusesWhatDoesNotFit) {
  const AnimatedNode node = still("box", Pose::Identity());
  const auto refusal = [](const std::vector<AnimatedNode>& nodes, std::vector<double> times) {
    return std::string(refusal_of([&] { animated(nodes, times); }).what());
  };
  EXPECT_NE(refusal({node}, {}).find("times"), std::string::npos);
  EXPECT_NE(refusal({node}, {0.0, 0.0}).find("times"), std::string::npos);
  EXPECT_NE(refusal({node}, {-1.0}).find("times"), std::string::npos);
  // Different, but not in single precision.
  EXPECT_NE(refusal({node}, {1.0, 1.0 + 1e-12}).find("times"), std::string::npos);
  AnimatedNode bad = node;
  bad.X_PN.assign(2, Pose::Identity());
  EXPECT_NE(refusal({node, bad}, {0.0, 1.0, 2.0}).find("nodes[1].X_PN"), std::string::npos);
  bad = node;
  bad.shown = {true};
  EXPECT_NE(refusal({bad}, {0.0, 1.0}).find("nodes[0].shown"), std::string::npos);
  bad = node;
  bad.parent = 0;
  EXPECT_NE(refusal({bad}, {0.0}).find("nodes[0].parent"), std::string::npos);
  bad = still("box", translation(Vector3(0.0, std::numeric_limits<double>::infinity(), 0.0)));
  EXPECT_NE(refusal({bad}, {0.0}).find("nodes[0].X_PN"), std::string::npos);
}

}  // namespace
}  // namespace prehend::test
