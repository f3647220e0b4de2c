// Shapes that boxes, spheres and cylinders describe badly, and a jaw of the right size for their
// thin parts: on a table, where there is no room below them.
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "planner/plan/plan.h"
#include "sim/scene/make_scene.h"
#include "sim/shape/basic_shapes.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

// The polygon of (distance from z, z) turned about z: a ring, or where it begins and ends on the
// axis a solid. Counterclockwise in this plane.
TriangleMesh turned(const std::vector<Eigen::Vector2d>& profile) {
  constexpr int kSides = 64;
  const bool solid = profile.front().x() == 0.0;
  const auto count = static_cast<int>(profile.size());
  TriangleMesh mesh;
  for (int k = 0; k < kSides; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kSides;
    for (const Eigen::Vector2d& p : profile) {
      mesh.vertices.emplace_back(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y());
    }
  }
  // Points on the axis are shared.
  const auto at = [&](int k, int i) {
    const bool on_axis = solid && (i == 0 || i == count - 1);
    return (on_axis ? 0 : k % kSides) * count + i;
  };
  for (int k = 0; k < kSides; ++k) {
    for (int i = 0; i < (solid ? count - 1 : count); ++i) {
      const int next = (i + 1) % count;
      const std::array<int, 4> corners = {at(k, i), at(k + 1, i), at(k + 1, next), at(k, next)};
      if (corners[0] != corners[1]) mesh.triangles.push_back({corners[0], corners[1], corners[2]});
      if (corners[2] != corners[3]) mesh.triangles.push_back({corners[0], corners[2], corners[3]});
    }
  }
  return mesh;
}

TriangleMesh ring_of_wire() {
  std::vector<Eigen::Vector2d> profile;
  for (int i = 0; i < 12; ++i) {
    const double angle = std::numbers::pi / 6.0 * i;
    profile.emplace_back(0.08 + 0.008 * std::cos(angle), 0.008 + 0.008 * std::sin(angle));
  }
  return turned(profile);
}

struct ThinShape {
  std::string name;
  TriangleMesh mesh;  // stands on z = 0
  std::string shape;  // of the primitive that the best grasp is of; "": any
};

std::vector<ThinShape> thin_shapes() {
  const auto bowl = turned({{0.0, 0.0},
                            {0.05, 0.0},
                            {0.09, 0.03},
                            {0.11, 0.07},
                            {0.107, 0.071},
                            {0.087, 0.032},
                            {0.049, 0.004},
                            {0.0, 0.004}});
  const auto bucket = turned(
      {{0.0, 0.0}, {0.11, 0.0}, {0.14, 0.25}, {0.1385, 0.25}, {0.1085, 0.0015}, {0.0, 0.0015}});
  const auto stick = transformed(make_box({0.14, 0.008, 0.008}), translation({0.0, 0.0, 0.004}));
  auto spatula = transformed(make_box({0.1, 0.08, 0.002}), translation({0.0, 0.0, 0.001}));
  append(spatula, transformed(make_box({0.2, 0.02, 0.008}), translation({0.15, 0.0, 0.004})));
  return {{"bowl", bowl, "rim"},
          {"bucket", bucket, "rim"},
          {"ring", ring_of_wire(), "bar"},
          {"stick", stick, ""},
          {"spatula", spatula, ""}};
}

class ThinShapes : public testing::TestWithParam<ThinShape> {};

TEST_P(ThinShapes, AreGraspedOnATable) {
  const ThinShape& thin = GetParam();
  for (const char* hand : {"parallel_jaw", "parallel_jaw_wide"}) {
    SCOPED_TRACE(hand);
    Scene scene = make_scene(make_graspable(thin.name, thin.mesh, Material::plastic), hand);
    StaticBody table = test::obstacle(make_box({1.0, 1.0, 0.03}), {0.0, 0.0, -0.0155});
    table.name = "table";
    scene.obstacles.push_back(table);
    const CompiledScene compiled = compile(std::move(scene));
    const PlanResult result = plan(compiled);
    ASSERT_FALSE(result.grasps.empty());
    const ScoredGrasp& best = result.grasps.front();
    EXPECT_GT(best.trial.epsilon.lower, 0.02);
    EXPECT_EQ(test::collision(compiled, best.trial.X_OH, best.trial.joints), "");
    if (!thin.shape.empty()) {
      EXPECT_EQ(shape_name(result.primitives[static_cast<std::size_t>(*best.primitive)].shape),
                thin.shape);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ThinShapes, testing::ValuesIn(thin_shapes()),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace prehend
