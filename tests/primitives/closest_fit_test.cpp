// The last fit against exact shapes.
#include "primitives/closest_fit.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "primitives/primitive_surface.h"
#include "sim/base/random.h"

namespace prehend {
namespace {

constexpr double kExact = 1e-6;
constexpr double kTolerance = 0.05;

// Points on the surface with their normals.
std::vector<SurfacePoint> points_on(const Primitive& primitive) {
  std::vector<SurfacePoint> points;
  for (const PatchPoint& patch : spread_points(primitive, 800)) {
    constexpr double kStep = 1e-6;
    Vector3 normal;
    for (int k = 0; k < 3; ++k) {
      normal[k] = signed_distance(primitive, patch.p_O + kStep * Vector3::Unit(k));
    }
    points.push_back({patch.p_O, normal.normalized(), 0});
  }
  return points;
}

// Turned by up to 6 degrees, shifted, and of other sizes.
Primitive nudged(Primitive primitive, Random& random) {
  primitive.X_OP =
      primitive.X_OP *
      pose_from(Eigen::AngleAxisd(0.1 * random.uniform(), random.direction()).toRotationMatrix(),
                0.02 * random.direction());
  const auto change = [&] { return random.uniform(0.95, 1.05); };
  if (auto* box = std::get_if<Box>(&primitive.shape)) {
    for (int k = 0; k < 3; ++k) box->size[k] *= change();
  } else if (auto* sphere = std::get_if<Sphere>(&primitive.shape)) {
    sphere->radius *= change();
  } else if (auto* cylinder = std::get_if<Cylinder>(&primitive.shape)) {
    cylinder->radius *= change();
    cylinder->height *= change();
  } else if (auto* cone = std::get_if<Cone>(&primitive.shape)) {
    cone->radius_low *= change();
    cone->radius_high *= change();
    cone->height *= change();
  }
  return primitive;
}

std::vector<Shape> shapes_to_fit() {
  return {Box{{0.3, 0.4, 0.7}}, Sphere{0.3}, Cylinder{0.2, 0.8}, Cone{0.3, 0.15, 0.6}};
}

double farthest(const Primitive& primitive, const std::vector<SurfacePoint>& points) {
  double most = 0.0;
  for (const SurfacePoint& s : points) {
    most = std::max(most, std::abs(signed_distance(primitive, s.p_O)));
  }
  return most;
}

TEST(ClosestFit, FindsTheShapeThatThePointsAreOn) {
  Random random(191);
  for (const Shape& shape : shapes_to_fit()) {
    for (int i = 0; i < 10; ++i) {
      const Primitive exact{shape, random.pose(0.3)};
      const std::vector<SurfacePoint> points = points_on(exact);
      const Primitive found = closest_fit(nudged(exact, random), points, kTolerance);
      EXPECT_LT(farthest(found, points), kExact) << shape_name(shape) << " " << i;
    }
  }
}

// A sixth of the points in a lump beside the surface, nearer than the tolerance.
TEST(ClosestFit, ALumpOnTheSurfaceDoesNotMoveIt) {
  Random random(192);
  for (const Shape& shape : shapes_to_fit()) {
    for (int i = 0; i < 10; ++i) {
      const Primitive exact{shape, random.pose(0.3)};
      const std::vector<SurfacePoint> points = points_on(exact);
      std::vector<SurfacePoint> with_lump = points;
      const Vector3 at = points[static_cast<std::size_t>(i)].p_O;
      for (std::size_t k = 0; k < points.size() / 5; ++k) {
        with_lump.push_back({at + 0.04 * random.direction(), random.direction(), 0});
      }
      const Primitive found = closest_fit(nudged(exact, random), with_lump, kTolerance);
      EXPECT_LT(farthest(found, points), 1e-4) << shape_name(shape) << " " << i;
    }
  }
}

// Half of a tube, without ends: its length is not in the points.
TEST(ClosestFit, WhatThePointsDoNotTellStays) {
  const Primitive tube{Cylinder{0.2, 0.8}, Pose::Identity()};
  std::vector<SurfacePoint> points;
  for (const SurfacePoint& s : points_on(tube)) {
    if (std::abs(s.p_O.z()) < 0.3 && s.p_O.x() > 0.0) points.push_back(s);
  }
  const Primitive found =
      closest_fit({Cylinder{0.21, 0.8}, translation({0.01, 0.0, 0.0})}, points, kTolerance);
  EXPECT_NEAR(std::get<Cylinder>(found.shape).radius, 0.2, kExact);
  EXPECT_NEAR(std::get<Cylinder>(found.shape).height, 0.8, kExact);
  EXPECT_NEAR(found.X_OP.translation().z(), 0.0, kExact);
}

}  // namespace
}  // namespace prehend
