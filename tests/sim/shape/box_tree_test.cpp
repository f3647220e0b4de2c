// Every box holds what is below it.
#include "sim/shape/box_tree.h"

#include <algorithm>
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
    EXPECT_LE(deepest, 2 * static_cast<int>(std::log2(mesh.triangles.size()))) << name;
  }
}

TEST(BoxTree, SplitsTrianglesThatLieOnTopOfEachOther) {
  TriangleMesh mesh = make_box({0.1, 0.1, 0.1});
  mesh.triangles.assign(64, mesh.triangles.front());
  EXPECT_EQ(build_box_tree(mesh).size(), 127U);
}

int depth_below(const std::vector<BoxNode>& tree, int at) {
  const BoxNode& node = tree[static_cast<std::size_t>(at)];
  if (node.is_leaf()) return 1;
  return 1 + std::max(depth_below(tree, node.left), depth_below(tree, node.left + 1));
}

// Triangles that shrink towards a point by a factor of 20 each: every split by surface takes the
// largest away.
TEST(BoxTree, IsNotDeepWhereTrianglesShrink) {
  TriangleMesh mesh;
  for (int i = 0; i < 200; ++i) {
    const double size = std::pow(20.0, -i);
    const int first = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(),
                         {Vector3(size, 0, 0), Vector3(size, size, 0), Vector3(size, 0, size)});
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  const int depth = depth_below(build_box_tree(mesh), 0);
  EXPECT_GT(depth, 40);
  EXPECT_LE(depth, 60);
}

// The neighbours of a large triangle are in boxes of their own, not in one as large as it is.
TEST(BoxTree, SetsALargeTriangleApart) {
  TriangleMesh mesh;
  const auto add = [&](const Vector3& at, double size) {
    const int first = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(),
                         {at, at + size * Vector3::UnitX(), at + size * Vector3::UnitY()});
    mesh.triangles.push_back({first, first + 1, first + 2});
  };
  for (int i = 0; i < 31; ++i) add(Vector3(0.01 * i, 0.0, 0.0), 0.01);
  add(Vector3(0.32, 0.0, 0.0), 10.0);
  const std::vector<BoxNode> tree = build_box_tree(mesh);
  const BoxNode& left = tree[static_cast<std::size_t>(tree[0].left)];
  const BoxNode& right = tree[static_cast<std::size_t>(tree[0].left) + 1];
  EXPECT_TRUE(left.is_leaf() || right.is_leaf());
}

TEST(BoxTree, OfNothingIsEmpty) { EXPECT_TRUE(build_box_tree({}).empty()); }

}  // namespace
}  // namespace prehend
