// The frame of an object moves with it.
#include "primitives/own_frame.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/object_generator.h"
#include "tests/primitives/test_meshes.h"

namespace prehend {
namespace {

std::vector<TriangleMesh> meshes_to_turn() {
  Random random(171);
  return {generate_object("mug", 2000), make_box({0.1, 0.1, 0.1}, 3),
          make_box({0.1, 0.2, 0.3}, 2), make_cylinder(0.03, 0.1),
          test::uv_sphere(0.05, 8, 12), test::triangle_soup(20, random)};
}

TEST(OwnFrame, MovesWithTheObject) {
  Random random(172);
  for (const TriangleMesh& mesh : meshes_to_turn()) {
    const OwnFrame own = own_frame(mesh);
    EXPECT_LT((own.X_OA.linear().transpose() * own.X_OA.linear() - Matrix3::Identity()).norm(),
              1e-12);
    EXPECT_GT(own.X_OA.linear().determinant(), 0.0);
    for (int i = 0; i < 20; ++i) {
      const Pose X_NO = random.pose(0.5);
      const double factor = random.uniform(0.1, 10.0);
      const OwnFrame moved = own_frame(test::scaled(transformed(mesh, X_NO), factor));
      EXPECT_LT((moved.X_OA.linear() - X_NO.linear() * own.X_OA.linear()).norm(), 1e-6);
      EXPECT_LT((moved.X_OA.translation() - factor * (X_NO * own.X_OA.translation())).norm(),
                1e-9 * factor);
      EXPECT_NEAR(moved.diagonal, factor * own.diagonal, 1e-6 * factor * own.diagonal);
    }
  }
}

// What divides triangles or lists them in another order leaves the surface as it is.
TEST(OwnFrame, DependsOnTheSurfaceOnly) {
  const TriangleMesh mug = generate_object("mug", 2000);
  TriangleMesh finer = test::subdivided(mug);
  std::reverse(finer.triangles.begin(), finer.triangles.end());
  const OwnFrame own = own_frame(mug);
  const OwnFrame same = own_frame(finer);
  EXPECT_LT((same.X_OA.matrix() - own.X_OA.matrix()).norm(), 1e-6);
  EXPECT_NEAR(same.diagonal, own.diagonal, 1e-9);
}

TEST(OwnFrame, OfABoxIsAlongItsEdges) {
  const OwnFrame own = own_frame(transformed(make_box({0.3, 0.1, 0.2}, 2), translation({1, 2, 3})));
  EXPECT_LT((own.X_OA.translation() - Vector3(1, 2, 3)).norm(), 1e-12);
  EXPECT_NEAR(own.diagonal, Vector3(0.1, 0.2, 0.3).norm(), 1e-12);
  EXPECT_NEAR(std::abs(own.X_OA.linear()(1, 0)), 1.0, 1e-12);
  EXPECT_NEAR(std::abs(own.X_OA.linear()(0, 2)), 1.0, 1e-12);
}

TEST(OwnFrame, OfACubeIsAlongItsEdges) {
  Random random(173);
  for (int i = 0; i < 10; ++i) {
    const OwnFrame own = own_frame(transformed(make_box({0.1, 0.1, 0.1}, 1 + i), random.pose(1.0)));
    EXPECT_NEAR(own.diagonal, std::sqrt(3.0) * 0.1, 1e-9);
  }
}

TEST(OwnFrame, WithoutAreaIsThatOfTheMesh) {
  const TriangleMesh line{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(own_frame(line).diagonal, 0.0);
  EXPECT_EQ(own_frame({}).diagonal, 0.0);
}

}  // namespace
}  // namespace prehend
