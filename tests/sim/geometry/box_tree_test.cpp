// Every box holds what is below it, and box distances never exceed what they bound.
#include "sim/geometry/box_tree.h"

#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/geometry/basic_shapes.h"
#include "sim/geometry/object_generator.h"

namespace prehend {
namespace {

// Centre and half size are each rounded once: a few units in the last place of a coordinate.
constexpr double kBoxRounding = 1e-16;

TEST(BoxTree, EveryBoxHoldsItsTrianglesAndEveryTriangleIsALeafOnce) {
  for (const char* name : {"mug", "ball", "phone"}) {
    const TriangleMesh mesh = generate_object(name, 700);
    const std::vector<BoxNode> tree = build_box_tree(mesh);
    ASSERT_EQ(tree.size(), 2 * mesh.triangles.size() - 1) << name;
    std::vector<int> seen(mesh.triangles.size(), 0);
    int deepest = 0;
    const std::function<void(int, std::vector<int>)> descend = [&](int at, std::vector<int> above) {
      const BoxNode& node = tree[static_cast<std::size_t>(at)];
      above.push_back(at);
      deepest = std::max(deepest, static_cast<int>(above.size()));
      if (!node.is_leaf()) {
        EXPECT_EQ(node.triangle, -1);
        descend(node.left, above);
        descend(node.left + 1, above);
        return;
      }
      ++seen[static_cast<std::size_t>(node.triangle)];
      for (int v : mesh.triangles[static_cast<std::size_t>(node.triangle)]) {
        const Vector3& p = mesh.vertices[static_cast<std::size_t>(v)];
        for (int box : above) {
          const BoxNode& holder = tree[static_cast<std::size_t>(box)];
          EXPECT_LE(((p - holder.center).cwiseAbs() - holder.half).maxCoeff(), kBoxRounding);
        }
      }
    };
    descend(0, {});
    EXPECT_EQ(seen, std::vector<int>(mesh.triangles.size(), 1)) << name;
    // Halving at the median: the depth is the logarithm of the count, also for equal centres.
    EXPECT_LE(deepest, 2 + static_cast<int>(std::log2(mesh.triangles.size()))) << name;
  }
}

TEST(BoxTree, SplitsTrianglesThatLieOnTopOfEachOther) {
  TriangleMesh mesh = make_box({0.1, 0.1, 0.1});
  mesh.triangles.assign(64, mesh.triangles.front());
  EXPECT_EQ(build_box_tree(mesh).size(), 127U);
}

TEST(BoxTree, OfNothingIsEmpty) { EXPECT_TRUE(build_box_tree({}).empty()); }

constexpr double kAny = std::numeric_limits<double>::infinity();

double squared_distance(const Pose& X_AB, const BoxNode& a, const BoxNode& b, double enough) {
  const BoxDistance distance(X_AB);
  return distance.squared(a, b, distance.placed(b), enough);
}

TEST(BoxDistance, NeverExceedsTheDistanceOfAnyTwoPoints) {
  Random random(21);
  int positive = 0;
  for (int i = 0; i < 2000; ++i) {
    const Pose X_AB = random.pose(0.2);
    BoxNode a;
    BoxNode b;
    a.center = random.in_box(0.05);
    b.center = random.in_box(0.05);
    a.half = random.in_box(0.08).cwiseAbs();
    b.half = random.in_box(0.08).cwiseAbs();
    const double squared = squared_distance(X_AB, a, b, kAny);
    positive += squared > 0.0;
    // Where less is enough, no more than that is promised.
    const double enough = random.uniform(0.0, 0.01);
    const double some = squared_distance(X_AB, a, b, enough);
    ASSERT_TRUE(some == squared || (some > enough && some < squared));
    for (int k = 0; k < 100; ++k) {
      // Half of the points on corners, where boxes are nearest.
      const auto point_of = [&](const BoxNode& box) -> Vector3 {
        Vector3 s = random.in_box(1.0);
        if (k % 2 == 0) s = s.array().sign();
        return box.center + s.cwiseProduct(box.half);
      };
      const Vector3 p = point_of(a);
      const Vector3 q = X_AB * point_of(b);
      ASSERT_LE(squared, (p - q).squaredNorm() + kBoxRounding);
    }
  }
  EXPECT_GT(positive, 200);
}

TEST(BoxDistance, IsExactForBoxesWithParallelAxes) {
  BoxNode a;
  a.half = {0.1, 0.2, 0.3};
  EXPECT_NEAR(squared_distance(translation({0.6, 0.0, 0.9}), a, a, kAny), 0.4 * 0.4 + 0.3 * 0.3,
              1e-15);
  EXPECT_EQ(squared_distance(translation({0.1, 0.1, 0.1}), a, a, kAny), 0.0);
}

}  // namespace
}  // namespace prehend
