// Features: what they are of an object where they are known, and that they stay the same however
// object and hand are placed and scaled.
#include "planner/plan/learn/grasp_features.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "planner/plan/propose/proposal_sequence.h"
#include "sim/base/index.h"
#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/object_generator.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

std::size_t feature(std::string_view name) {
  const auto found = std::find(kGraspFeatures.begin(), kGraspFeatures.end(), name);
  EXPECT_NE(found, kGraspFeatures.end()) << name;
  return static_cast<std::size_t>(found - kGraspFeatures.begin());
}

std::vector<ProposedGrasp> proposals(const CompiledScene& scene,
                                     const std::vector<Primitive>& primitives, int count) {
  ProposalSequence sequence(scene, primitives, {});
  std::vector<ProposedGrasp> grasps;
  for (int i = 0; i < count; ++i) {
    if (auto grasp = sequence.next(Track::solids)) grasps.push_back(std::move(*grasp));
  }
  return grasps;
}

// Rays that graze an edge meet one of its sides by rounding, so that a few numbers may differ.
void expect_alike(const GraspFeatures& a, const GraspFeatures& b, int& different) {
  for (std::size_t f = 0; f < a.size(); ++f) {
    if (std::abs(a[f] - b[f]) > 1e-4F * (1.0F + std::abs(a[f]))) ++different;
  }
}

TEST(GraspFeatures, HaveDifferentNames) {
  std::vector<std::string> names = grasp_feature_names();
  ASSERT_EQ(names.size(), kGraspFeatures.size());
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
  for (const std::string& name : names) EXPECT_FALSE(name.empty());
}

// A cube that is grasped at its middle, of which everything is known.
TEST(GraspFeatures, OfACube) {
  constexpr double kSide = 0.04;
  const CompiledScene scene =
      test::compiled(find_robot("parallel_jaw"), make_box(Vector3::Constant(kSide)));
  const Hand& hand = *scene.scene.hand.hand;
  const std::vector<Primitive> primitives = {{Box{Vector3::Constant(kSide)}, Pose::Identity()}};
  const FeatureMaker maker(scene, primitives);
  const auto grasps = proposals(scene, primitives, 40);
  int middles = 0;
  for (const ProposedGrasp& grasp : grasps) {
    const GraspFeatures f = maker.features(grasp);
    const auto value = [&](std::string_view name) { return double{f[feature(name)]}; };
    const double opening = hand.preshapes[index(*grasp.candidate.preshape)].max_width;
    EXPECT_EQ(value("box"), 1.0);
    EXPECT_EQ(value("sphere") + value("cylinder") + value("cone") + value("rim") + value("bar"),
              0.0);
    EXPECT_NEAR(value("width"), kSide / opening, 1e-6);
    EXPECT_NEAR(value("surface_share"), 1.0, 1e-6);
    // Of a cube, the variance along any direction is side^2 / 12.
    for (const char* name : {"mass_approach", "mass_closing", "mass_lateral"}) {
      EXPECT_NEAR(value(name), kSide / std::sqrt(12.0) / opening, 1e-5) << name;
    }
    EXPECT_NEAR(value("thickness"), kSide / opening, 1e-4);
    EXPECT_NEAR(value("facing_least"), 1.0, 1e-6);
    EXPECT_NEAR(value("before") + value("behind"), kSide / opening, 2e-3);
    if (value("primitive_offset") > 1e-6) continue;
    ++middles;
    EXPECT_NEAR(value("center_line"), 0.0, 1e-6);
    EXPECT_NEAR(value("off_middle"), 0.0, 1e-5);
    EXPECT_NEAR(value("under_surface"), 0.5 * kSide / opening, 1e-4);
  }
  EXPECT_GT(middles, 0);
}

TEST(GraspFeatures, StayTheSameWhereObjectAndHandAreTurned) {
  const Robot hand = find_robot("barrett");
  const TriangleMesh mug = generate_object("mug", 1500);
  // Turned a little against the mesh, so that rays do not go through its edges: those meet either
  // side of them by rounding.
  const Pose tilt = pose_from(Eigen::AngleAxisd(0.1, Vector3(0.3, 0.5, 0.81).normalized()).matrix(),
                              {0.0013, 0.0007, 0.0009});
  const std::vector<Primitive> primitives = {
      {Cylinder{0.04, 0.09}, tilt * translation({0.0, 0.0, 0.045})},
      {Box{{0.02, 0.01, 0.06}}, tilt * translation({0.06, 0.0, 0.045})}};
  const CompiledScene scene = test::compiled(hand, mug);
  const auto grasps = proposals(scene, primitives, 60);
  const FeatureMaker maker(scene, primitives);
  Random random(5);
  int different = 0;
  for (int turn = 0; turn < 3; ++turn) {
    const Pose X_AO = random.pose(0.2);
    const CompiledScene turned = test::compiled(hand, transformed(mug, X_AO));
    std::vector<Primitive> moved = primitives;
    for (Primitive& primitive : moved) primitive.X_OP = X_AO * primitive.X_OP;
    const FeatureMaker other(turned, moved);
    for (ProposedGrasp grasp : grasps) {
      const GraspFeatures before = maker.features(grasp);
      grasp.candidate.X_OH = X_AO * grasp.candidate.X_OH;
      grasp.candidate.approach_O = X_AO.linear() * grasp.candidate.approach_O;
      expect_alike(before, other.features(grasp), different);
    }
  }
  ASSERT_EQ(grasps.size(), 60U);
  EXPECT_LE(different, 3 * 60 * static_cast<int>(kGraspFeatures.size()) / 200);
}

// The hand of a scene in which all is `by` times as large.
Robot scaled(Robot robot, double by) {
  for (Joint& joint : robot.joints) {
    joint.X_PJ.translation() *= by;
    joint.X_JA.translation() *= by;
  }
  for (Link& link : robot.links) {
    for (Vector3& vertex : link.mesh.vertices) vertex *= by;
  }
  robot.hand->origin *= by;
  for (Preshape& preshape : robot.hand->preshapes) {
    preshape.min_width *= by;
    preshape.max_width *= by;
    preshape.depth *= by;
  }
  return robot;
}

TEST(GraspFeatures, StayTheSameWhereObjectAndHandAreScaled) {
  constexpr double kBy = 1.7;
  const Robot hand = find_robot("barrett");
  TriangleMesh mug = generate_object("mug", 1500);
  const std::vector<Primitive> primitives = {
      {Cylinder{0.04, 0.09}, translation({0.0, 0.0, 0.045})}};
  const CompiledScene scene = test::compiled(hand, mug);
  for (Vector3& vertex : mug.vertices) vertex *= kBy;
  const CompiledScene larger = test::compiled(scaled(hand, kBy), mug);
  const std::vector<Primitive> larger_primitives = {
      {Cylinder{kBy * 0.04, kBy * 0.09}, translation({0.0, 0.0, kBy * 0.045})}};
  const FeatureMaker maker(scene, primitives);
  const FeatureMaker other(larger, larger_primitives);
  int different = 0;
  for (ProposedGrasp grasp : proposals(scene, primitives, 60)) {
    const GraspFeatures before = maker.features(grasp);
    grasp.candidate.X_OH.translation() *= kBy;
    grasp.width *= kBy;
    grasp.stand_off *= kBy;
    expect_alike(before, other.features(grasp), different);
  }
  EXPECT_LE(different, 60 * static_cast<int>(kGraspFeatures.size()) / 200);
}

}  // namespace
}  // namespace prehend
