// Cylinders that taper, among shapes that do not.
#include "primitives/taper.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "primitives/decompose.h"
#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

// A cone without its tip, closed, about z.
TriangleMesh frustum(double radius_low, double radius_high, double height) {
  TriangleMesh mesh = make_cylinder(1.0, height, 48, 12);
  for (Vector3& p : mesh.vertices) {
    const double part = p.z() / height + 0.5;
    p.head<2>() *= radius_low + part * (radius_high - radius_low);
  }
  return mesh;
}

const Cone* cone_in(const Decomposition& parts) {
  return parts.primitives.size() == 1 ? std::get_if<Cone>(&parts.primitives.front().shape)
                                      : nullptr;
}

TEST(Taper, ConesAreFoundWithTheirRadiiAndAxis) {
  Random random(171);
  for (const auto& [low, high, height] :
       {std::array{0.04, 0.03, 0.12}, {0.05, 0.035, 0.10}, {0.03, 0.045, 0.15}}) {
    const Pose X_WO = random.pose(0.5);
    const Decomposition parts = decompose(transformed(frustum(low, high, height), X_WO));
    const Cone* cone = cone_in(parts);
    ASSERT_NE(cone, nullptr) << low << " " << high;
    const Pose X_OP = X_WO.inverse() * parts.primitives.front().X_OP;
    const double axis = X_OP.linear()(2, 2);
    EXPECT_GT(std::abs(axis), 0.999);
    EXPECT_NEAR(axis > 0.0 ? cone->radius_low : cone->radius_high, low, 1.5e-3);
    EXPECT_NEAR(axis > 0.0 ? cone->radius_high : cone->radius_low, high, 1.5e-3);
    EXPECT_NEAR(cone->height, height, 4e-3);
    EXPECT_GT(parts.explained, 0.99);
  }
}

TEST(Taper, WhatDoesNotTaperStays) {
  for (const TriangleMesh& mesh :
       {make_cylinder(0.03, 0.1), frustum(0.03, 0.029, 0.1), make_box({0.05, 0.06, 0.1})}) {
    EXPECT_EQ(cone_in(decompose(mesh)), nullptr);
  }
  const Primitive sphere{Sphere{0.05}, Pose::Identity()};
  EXPECT_TRUE(std::holds_alternative<Sphere>(tapered(sphere, {}, 0.01).shape));
  const Primitive cylinder{Cylinder{0.05, 0.1}, Pose::Identity()};
  EXPECT_TRUE(std::holds_alternative<Cylinder>(tapered(cylinder, {}, 0.01).shape));
}

}  // namespace
}  // namespace prehend
