// Every box holds what is below it.
#include "sim/shape/box_tree.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "sim/shape/basic_shapes.h"
#include "sim/shape/object_generator.h"

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

}  // namespace
}  // namespace prehend
