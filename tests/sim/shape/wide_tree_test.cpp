// Every box holds what is below it, and distances of boxes never exceed what they bound.
#include "sim/shape/wide_tree.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/object_generator.h"

namespace prehend {
namespace {

Vector3 vector_of(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

WideBox lane_of(const WideNode& node, std::size_t lane) {
  return {{node.center[0][lane], node.center[1][lane], node.center[2][lane]},
          {node.half[0][lane], node.half[1][lane], node.half[2][lane]},
          node.child[lane]};
}

bool holds(const WideBox& box, const Vector3& p) {
  return ((p - vector_of(box.center)).cwiseAbs().array() <= vector_of(box.half).array()).all();
}

// Checks the boxes around everything below `box`, and counts the triangles.
void look_below(const TriangleMesh& mesh, const WideTree& tree, const WideBox& box,
                std::vector<WideBox> above, std::vector<int>& seen) {
  above.push_back(box);
  if (is_triangle(box.child)) {
    ++seen[static_cast<std::size_t>(~box.child)];
    for (const int v : mesh.triangles[static_cast<std::size_t>(~box.child)]) {
      const Vector3 p = mesh.vertices[static_cast<std::size_t>(v)] - tree.origin;
      EXPECT_LE(p.norm(), tree.radius * (1.0 + 1e-15));
      for (const WideBox& holder : above) EXPECT_TRUE(holds(holder, p));
    }
    return;
  }
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const WideBox child = lane_of(tree.nodes[static_cast<std::size_t>(box.child)], lane);
    if (child.center[0] < 1e17F) look_below(mesh, tree, child, above, seen);
  }
}

TEST(WideTree, EveryBoxHoldsItsTrianglesAndEveryTriangleIsThereOnce) {
  std::vector<TriangleMesh> meshes{make_box({0.1, 0.2, 0.3})};
  for (const char* name : {"mug", "ball", "phone"}) meshes.push_back(generate_object(name, 700));
  meshes.push_back({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  for (TriangleMesh& mesh : meshes) {
    // Far from the origin of its frame, where single precision would be coarse.
    for (Vector3& p : mesh.vertices) p += Vector3(30.0, -20.0, 10.0);
    const WideTree tree = build_wide_tree(build_box_tree(mesh));
    std::vector<int> seen(mesh.triangles.size(), 0);
    look_below(mesh, tree, tree.root, {}, seen);
    EXPECT_EQ(seen, std::vector<int>(mesh.triangles.size(), 1));
  }
}

// A tree whose root node has these boxes, and no triangles.
WideTree tree_of(const std::vector<WideBox>& boxes, const Vector3& origin) {
  WideTree tree;
  tree.origin = origin;
  tree.nodes.emplace_back();
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const WideBox& box = boxes[lane];
    for (std::size_t k = 0; k < 3; ++k) {
      tree.nodes[0].center[k][lane] = box.center[k];
      tree.nodes[0].half[k][lane] = box.half[k];
    }
    tree.nodes[0].child[lane] = -1;
    tree.radius = std::max(tree.radius, vector_of(box.center).norm() + vector_of(box.half).norm());
  }
  return tree;
}

std::vector<WideBox> random_boxes(Random& random) {
  std::vector<WideBox> boxes(kLanes);
  for (WideBox& box : boxes) {
    const Vector3 center = random.in_box(0.05);
    const Vector3 half = random.in_box(0.08).cwiseAbs();
    for (std::size_t k = 0; k < 3; ++k) {
      box.center[k] = static_cast<float>(center[static_cast<Vector3::Index>(k)]);
      box.half[k] = static_cast<float>(half[static_cast<Vector3::Index>(k)]);
    }
  }
  return boxes;
}

// The least squared distance of points of the two boxes, half of them on corners, where boxes are
// nearest.
double sampled(Random& random, const Pose& X_AB, const WideTree& a, const WideBox& in_a,
               const WideTree& b, const WideBox& in_b) {
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 100; ++k) {
    const auto point_of = [&](const WideTree& tree, const WideBox& box) -> Vector3 {
      Vector3 s = random.in_box(1.0);
      if (k % 2 == 0) s = s.array().sign();
      return tree.origin + vector_of(box.center) + s.cwiseProduct(vector_of(box.half));
    };
    least = std::min(least, (X_AB * point_of(b, in_b) - point_of(a, in_a)).squaredNorm());
  }
  return least;
}

constexpr float kAny = std::numeric_limits<float>::infinity();

TEST(WideDistance, NeverExceedsTheDistanceOfAnyTwoPoints) {
  Random random(21);
  int positive = 0;
  for (int i = 0; i < 600; ++i) {
    const Vector3 far = random.in_box(20.0);
    const WideTree a = tree_of(random_boxes(random), far);
    const auto boxes = random_boxes(random);
    const WideTree b = tree_of(boxes, random.in_box(20.0));
    const Pose X_AB = translation(far) * random.pose(0.2) * translation(-b.origin);
    const WideDistance distance(a, b, X_AB);
    const auto box_b = lane_of(b.nodes[0], 0);
    const auto box_a = lane_of(a.nodes[0], 1);
    WideDistance::PlacedNode ignored;
    const LaneNumbers to_a = distance.squared(a.nodes[0], distance.placed(box_b), kAny);
    const LaneNumbers to_b = distance.squared(box_a, b.nodes[0], kAny, ignored);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      positive += to_a[lane] > 0.0F ? 1 : 0;
      ASSERT_LE(0.999999 * to_a[lane],
                sampled(random, X_AB, a, lane_of(a.nodes[0], lane), b, box_b));
      ASSERT_LE(0.999999 * to_b[lane],
                sampled(random, X_AB, a, box_a, b, lane_of(b.nodes[0], lane)));
    }
    // Where less is enough, no more than that is promised.
    const auto enough = static_cast<float>(random.uniform(0.0, 0.01));
    const LaneNumbers some = distance.squared(a.nodes[0], distance.placed(box_b), enough);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      ASSERT_TRUE(some[lane] == to_a[lane] || (some[lane] > enough && some[lane] < to_a[lane]));
    }
  }
  EXPECT_GT(positive, 500);
}

TEST(WideDistance, IsNearTheDistanceOfBoxesWithParallelAxes) {
  const WideTree a = tree_of(std::vector<WideBox>(kLanes, {{}, {0.1F, 0.2F, 0.3F}, -1}), {0, 0, 0});
  const WideBox box = lane_of(a.nodes[0], 0);
  const auto squared = [&](const Vector3& shift) {
    const WideDistance distance(a, a, translation(shift));
    return static_cast<double>(distance.squared(a.nodes[0], distance.placed(box), kAny)[0]);
  };
  EXPECT_NEAR(squared({0.6, 0.0, 0.9}), 0.4 * 0.4 + 0.3 * 0.3, 1e-5);
  EXPECT_EQ(squared({0.1, 0.1, 0.1}), 0.0);
}

TEST(WideTree, FindsAllTrianglesWhoseBoxesMeetABox) {
  Random random(22);
  TriangleMesh mesh = generate_object("mug", 700);
  const Vector3 far(30.0, -20.0, 10.0);
  for (Vector3& p : mesh.vertices) p += far;
  const WideTree tree = build_wide_tree(build_box_tree(mesh));
  for (int run = 0; run < 300; ++run) {
    const Vector3 center = far + random.in_box(0.08);
    const Vector3 half = random.in_box(0.02).cwiseAbs();
    const Bounds box{center - half, center + half};
    std::vector<int> found;
    collect_in_box(tree, box, found);
    std::vector<int> times(mesh.triangles.size(), 0);
    for (const int t : found) ++times[static_cast<std::size_t>(t)];
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      Bounds own;
      for (const int v : mesh.triangles[t]) {
        own.lower = own.lower.cwiseMin(mesh.vertices[static_cast<std::size_t>(v)]);
        own.upper = own.upper.cwiseMax(mesh.vertices[static_cast<std::size_t>(v)]);
      }
      const double apart = (own.lower - box.upper).cwiseMax(box.lower - own.upper).maxCoeff();
      ASSERT_LE(times[t], 1);
      if (apart <= 0.0) {
        ASSERT_EQ(times[t], 1);
      }
      // Single precision at the size of the mesh, 0.1 m.
      if (apart > 1e-6) {
        ASSERT_EQ(times[t], 0);
      }
    }
  }
}

TEST(WideTree, FindsEachTriangleOnceInABoxHoweverLarge) {
  const TriangleMesh mesh = generate_object("ball", 500);
  const WideTree tree = build_wide_tree(build_box_tree(mesh));
  for (const double half : {1.0, 1e9, 1e17, 1e18, 1e30, 1e38, 1e100}) {
    const Bounds box{Vector3::Constant(-half), Vector3::Constant(half)};
    std::vector<int> found;
    collect_in_box(tree, box, found);
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found.size(), mesh.triangles.size()) << half;
    for (std::size_t t = 0; t < found.size(); ++t) EXPECT_EQ(found[t], static_cast<int>(t));
  }
}

TEST(WideDistance, OfAPrismNeverExceedsTheDistanceOfAnyPointOfItsTriangle) {
  Random random(23);
  int positive = 0;
  for (int i = 0; i < 600; ++i) {
    const Vector3 far = random.in_box(20.0);
    const WideTree a = tree_of(random_boxes(random), far);
    const WideTree b = tree_of(random_boxes(random), Vector3::Zero());
    PlacedTriangle triangle;
    for (Vector3& corner : triangle.corner) corner = far + random.in_box(0.15);
    triangle.normal = reliable_normal(triangle.corner);
    const WideDistance distance(a, b, translation(far));
    const LaneNumbers squared = distance.squared(a.nodes[0], distance.prism(triangle));
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      positive += squared[lane] > 0.0F ? 1 : 0;
      const WideBox box = lane_of(a.nodes[0], lane);
      for (int k = 0; k < 100; ++k) {
        const double s = random.uniform();
        const double t = random.uniform() * (1.0 - s);
        const Vector3 p = triangle.corner[0] + s * (triangle.corner[1] - triangle.corner[0]) +
                          t * (triangle.corner[2] - triangle.corner[0]);
        const Vector3 apart =
            ((p - far - vector_of(box.center)).cwiseAbs() - vector_of(box.half)).cwiseMax(0.0);
        ASSERT_LE(0.999999 * squared[lane], apart.squaredNorm());
      }
    }
  }
  EXPECT_GT(positive, 500);
}

// A plate across the diagonal of its box: the prism tells what the box does not.
TEST(WideDistance, OfAPrismIsThatOfItsPlaneOverTheTriangleAndOfItsEdgesBeside) {
  const WideTree a =
      tree_of(std::vector<WideBox>(kLanes, {{}, {1e-6F, 1e-6F, 1e-6F}, -1}), {0, 0, 0});
  const auto distance_of = [&](const std::array<Vector3, 3>& corners) {
    const WideDistance distance(a, a, translation(Vector3::Zero()));
    const PlacedTriangle triangle{corners, reliable_normal(corners)};
    return std::sqrt(
        static_cast<double>(distance.squared(a.nodes[0], distance.prism(triangle))[0]));
  };
  EXPECT_NEAR(distance_of({Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)}),
              1.0 / std::sqrt(3.0), 1e-5);
  EXPECT_NEAR(distance_of({Vector3(1, -1, 0), Vector3(1, 1, 0), Vector3(2, 0, 0)}), 1.0, 1e-5);
  EXPECT_EQ(distance_of({Vector3(1, 1, 1), Vector3(1, 1, 1), Vector3(1, 1, 1)}), 0.0);
}

}  // namespace
}  // namespace prehend
