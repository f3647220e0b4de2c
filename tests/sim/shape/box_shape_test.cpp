#include "sim/shape/box_shape.h"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/convex_hull.h"

namespace prehend {
namespace {

TEST(BoxShape, ABoxIsFoundWhereverItIs) {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    const Vector3 size = random.in_box(Vector3::Constant(0.001), Vector3::Constant(0.1));
    const Pose X = random.pose(0.5);
    const TriangleMesh mesh = convex_hull(transformed(make_box(size), X).vertices);
    const auto box = box_shape(mesh);
    ASSERT_TRUE(box);
    EXPECT_LT((box->X_MB.translation() - X.translation()).norm(), 1e-7);
    EXPECT_NEAR(box->X_MB.linear().determinant(), 1.0, 1e-9);
    // The edges are those of the box, in another order.
    std::array<double, 3> found = {box->size.x(), box->size.y(), box->size.z()};
    std::array<double, 3> made = {size.x(), size.y(), size.z()};
    std::sort(found.begin(), found.end());
    std::sort(made.begin(), made.end());
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], made[k], 1e-7);
    for (const Vector3& p : mesh.vertices) {
      const Vector3 at = box->X_MB.inverse() * p;
      EXPECT_LT((2.0 * at.cwiseAbs() - box->size).cwiseAbs().maxCoeff(), 1e-6);
    }
  }
}

TEST(BoxShape, OthersAreNone) {
  EXPECT_FALSE(box_shape(make_sphere(0.1)));
  EXPECT_FALSE(box_shape(make_cylinder(0.1, 0.1)));
  EXPECT_FALSE(box_shape(make_prism({{0, 0}, {1, 0}, {1, 1}, {0.1, 1}}, 0.0, 1.0)));
  EXPECT_FALSE(box_shape({}));
}

}  // namespace
}  // namespace prehend
