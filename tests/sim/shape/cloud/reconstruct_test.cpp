// Bodies from depth images of shapes whose surface is known.
#include "sim/shape/cloud/reconstruct.h"

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/shape/mesh_checks.h"
#include "sim/shape/object_generator.h"
#include "sim/shape/proximity.h"
#include "tests/support/shown_shapes.h"

namespace prehend {
namespace {

constexpr double kNoise = 0.0013;  // that of a structured-light camera at 0.65 m [m]

ShownShape ball() {
  return {ShownShape::Kind::ball, Vector3::Constant(0.035), translation({0.0, 0.0, 0.035})};
}
ShownShape box() {
  Pose X_WS = translation({0.0, 0.0, 0.05});
  X_WS.linear() = Eigen::AngleAxisd(0.4, Vector3::UnitZ()).toRotationMatrix();
  return {ShownShape::Kind::box, Vector3(0.03, 0.045, 0.05), X_WS};
}
ShownShape cylinder() {
  return {ShownShape::Kind::cylinder, Vector3(0.033, 0.033, 0.05), translation({0.0, 0.0, 0.05})};
}

// Of the seen triangles' middles: the mean distance from the shape, and the share that is farther
// from it than 2 mm.
struct SeenError {
  double mean = 0.0;
  double far = 0.0;
};

SeenError seen_error(const SeenObject& object, const ShownShape& shape) {
  SeenError error;
  double count = 0.0;
  for (std::size_t t = 0; t < object.seen.size(); ++t) {
    if (object.seen[t] == 0) continue;
    const Corners corners = corners_of(object.mesh, static_cast<int>(t));
    const double off = std::abs(shape.distance((corners[0] + corners[1] + corners[2]) / 3.0));
    error.mean += off;
    error.far += off > 0.002 ? 1.0 : 0.0;
    count += 1.0;
  }
  error.mean /= std::max(count, 1.0);
  error.far /= std::max(count, 1.0);
  return error;
}

void expect_body(const Reconstruction& found, const ShownShape& shape, double volume_error) {
  ASSERT_EQ(found.objects.size(), 1U);
  const SeenObject& object = found.objects.front();
  for (const TriangleMesh* mesh : {&object.mesh, &object.thin, &object.thick}) {
    EXPECT_TRUE(check_mesh(*mesh).solid());
    EXPECT_FALSE(check_mesh(*mesh).inward);
  }
  ASSERT_EQ(object.seen.size(), object.mesh.triangles.size());
  const double volume = signed_volume(object.mesh);
  EXPECT_NEAR(volume / shape.volume(), 1.0, volume_error);
  EXPECT_LE(signed_volume(object.thin), volume);
  EXPECT_GE(signed_volume(object.thick), volume);
  const SeenError error = seen_error(object, shape);
  EXPECT_LT(error.mean, 0.0006);  // less than half of the noise of a reading
  EXPECT_LT(error.far, 0.02);     // at edges, which windows of pixels round off
}

TEST(Reconstruct, RoundThingsAreRoundFromEachSide) {
  for (const double angle : {0.0, 1.3, 4.0}) {
    for (const ShownShape& shape : {ball(), cylinder()}) {
      const Reconstruction found = reconstruct({view_of(camera_around(angle), {shape}, kNoise)});
      expect_body(found, shape, 0.08);
      EXPECT_EQ(found.objects.front().symmetry, Symmetry::revolution);
    }
  }
}

TEST(Reconstruct, ABoxHasItsUnseenSides) {
  for (const double angle : {0.2, 1.5, 2.9}) {
    const Reconstruction found = reconstruct({view_of(camera_around(angle), {box()}, kNoise)});
    expect_body(found, box(), 0.12);
    EXPECT_EQ(found.objects.front().symmetry, Symmetry::two_mirrors);
  }
}

TEST(Reconstruct, ThreeViewsNeedNoSymmetry) {
  std::vector<DepthView> views;
  for (const double angle : {0.2, 2.3, 4.4}) {
    views.push_back(view_of(camera_around(angle), {box()}, kNoise));
  }
  ReconstructOptions options;
  options.use_symmetry = false;
  expect_body(reconstruct(views, options), box(), 0.06);
}

TEST(Reconstruct, ThePlaneIsWhereTheTableIs) {
  const Reconstruction found = reconstruct({view_of(camera_around(0.7), {box()}, kNoise)});
  ASSERT_TRUE(found.plane);
  EXPECT_NEAR(found.plane->height, 0.0, 3e-4);
  EXPECT_NEAR(found.plane->tilt, 0.0, 2e-3);
  EXPECT_GE(found.plane->outline_W.size(), 4U);
  // The same, with the world turned and moved.
  Pose X_VW = pose_from(Eigen::AngleAxisd(0.1, Vector3::UnitX()).toRotationMatrix(),
                        Vector3(0.3, -0.2, 0.7));
  DepthView view = view_of(camera_around(0.7), {box()}, kNoise);
  view.camera.X_WC = X_VW * view.camera.X_WC;
  const Reconstruction moved = reconstruct({view});
  ASSERT_TRUE(moved.plane);
  EXPECT_NEAR(moved.plane->tilt, 0.1, 2e-3);
  EXPECT_NEAR(moved.plane->normal_W.dot(X_VW.linear().col(2)), 1.0, 1e-5);
  EXPECT_NEAR(moved.plane->height, 0.7, 5e-3);  // below the box, which is 5 cm about the origin
  ASSERT_EQ(moved.objects.size(), 1U);
  EXPECT_NEAR(signed_volume(moved.objects[0].mesh) / box().volume(), 1.0, 0.12);
}

TEST(Reconstruct, ErrorsOfTheSurfaceGrowWithTheNoise) {
  for (const double factor : {0.25, 0.5, 1.0, 2.0}) {
    const double noise = factor * kNoise;
    const Reconstruction found = reconstruct({view_of(camera_around(0.2), {cylinder()}, noise)});
    ASSERT_EQ(found.objects.size(), 1U);
    // Edges that are rounded off by the grid and the window, and a third of the noise.
    EXPECT_LT(seen_error(found.objects.front(), cylinder()).mean, 3e-4 + 0.33 * noise) << factor;
  }
}

TEST(Reconstruct, WhatWasSeenThroughIsFree) {
  const DepthView view = view_of(camera_around(1.0), {box()}, 0.0);
  const Reconstruction found = reconstruct({view});
  ASSERT_EQ(found.objects.size(), 1U);
  const Pose X_CW = view.camera.X_WC.inverse();
  for (const Vector3& p_W : found.objects.front().mesh.vertices) {
    const Vector3 p_C = X_CW * p_W;
    // The farthest reading within two pixels: edges are only known to a pixel or so.
    const double u = view.camera.fx * p_C.x() / p_C.z() + view.camera.cx;
    const double v = view.camera.fy * p_C.y() / p_C.z() + view.camera.cy;
    double nearest = 1e9;
    for (int dv = -2; dv <= 2; ++dv) {
      for (int du = -2; du <= 2; ++du) {
        const auto x = static_cast<int>(std::lround(u)) + du;
        const auto y = static_cast<int>(std::lround(v)) + dv;
        ASSERT_TRUE(x >= 0 && y >= 0 && x < 640 && y < 480);
        nearest = std::min(nearest, static_cast<double>(view.depth[index(y) * 640 + index(x)]));
      }
    }
    EXPECT_GT(p_C.z(), nearest - 0.003);
  }
}

TEST(Reconstruct, HollowsThatWereSeenStayOpen) {
  const TriangleMesh bowl = generate_object("bowl", 4000);
  const ProximityMesh tree(bowl);
  const Vector3 middle = bounds(bowl).center();
  DepthView view = view_of(camera_around(0.5, middle), {}, 0.0);
  const DepthCamera& camera = view.camera;
  const Vector3 from = camera.X_WC.translation();
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const Vector3 ray_C((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
      const RayHit hit = first_hit(tree, from, (camera.X_WC.linear() * ray_C).normalized());
      float& depth = view.depth[index(v) * 640 + index(u)];
      const auto own = static_cast<float>(hit.distance / ray_C.norm());
      if (hit.triangle >= 0 && (depth == 0.0F || own < depth)) depth = own;
    }
  }
  const Reconstruction found = reconstruct({view});
  ASSERT_EQ(found.objects.size(), 1U);
  const ProximityMesh completed(found.objects.front().mesh);
  const Vector3 inside(0.0, 0.0, 0.7 * bounds(bowl).upper.z());
  EXPECT_EQ(first_hit(completed, inside, Vector3::UnitZ()).triangle, -1);
  EXPECT_GE(first_hit(completed, inside, -Vector3::UnitZ()).triangle, 0);
}

TEST(Reconstruct, ThingsApartAreTwoAndTouchingOnesAreOne) {
  ShownShape left = ball();
  ShownShape right = cylinder();
  left.X_WS.translation().y() = -0.06;
  right.X_WS.translation().y() = 0.06;
  const Reconstruction apart = reconstruct({view_of(camera_around(0.0), {left, right}, kNoise)});
  ASSERT_EQ(apart.objects.size(), 2U);
  EXPECT_GT(apart.objects[0].readings, apart.objects[1].readings);
  EXPECT_NEAR(signed_volume(apart.objects[0].mesh) / right.volume(), 1.0, 0.1);
  EXPECT_NEAR(signed_volume(apart.objects[1].mesh) / left.volume(), 1.0, 0.1);
  left.X_WS.translation().y() = -0.008;
  EXPECT_EQ(reconstruct({view_of(camera_around(0.0), {left, right}, kNoise)}).objects.size(), 1U);
}

TEST(Reconstruct, WithoutATable) {
  const Reconstruction found = reconstruct({view_of(camera_around(0.3), {ball()}, kNoise, false)});
  EXPECT_FALSE(found.plane);
  EXPECT_FALSE(found.notes.empty());
  ASSERT_EQ(found.objects.size(), 1U);
  EXPECT_LT(seen_error(found.objects.front(), ball()).mean, 0.0006);
  EXPECT_NEAR(signed_volume(found.objects.front().mesh) / ball().volume(), 1.0, 0.3);
}

TEST(Reconstruct, TheSameOnAnyNumberOfThreads) {
  const std::vector<DepthView> views = {view_of(camera_around(0.3), {box()}, kNoise)};
  const Reconstruction one = reconstruct(views, {}, {.threads = 1});
  for (const int threads : {2, 8}) {
    const Reconstruction other = reconstruct(views, {}, {.threads = threads});
    ASSERT_EQ(other.objects.size(), one.objects.size());
    EXPECT_EQ(other.objects[0].mesh.vertices, one.objects[0].mesh.vertices);
    EXPECT_EQ(other.objects[0].mesh.triangles, one.objects[0].mesh.triangles);
    EXPECT_EQ(other.objects[0].seen, one.objects[0].seen);
    EXPECT_EQ(other.objects[0].thin.vertices, one.objects[0].thin.vertices);
    EXPECT_EQ(other.objects[0].thick.vertices, one.objects[0].thick.vertices);
  }
}

TEST(Reconstruct, RefusesViewsOfNothing) {
  EXPECT_THROW(reconstruct({}), InputError);
  DepthView view = view_of(camera_around(0.0), {}, kNoise);
  EXPECT_THROW(reconstruct({view}), InputError);  // a table alone
  DepthView empty = view;
  empty.depth.assign(empty.depth.size(), 0.0F);
  EXPECT_THROW(reconstruct({empty}), InputError);
  empty.depth[1000] = 0.7F;  // one reading
  EXPECT_THROW(reconstruct({empty}), InputError);
  empty.depth.assign(empty.depth.size(), std::numeric_limits<float>::quiet_NaN());
  EXPECT_THROW(reconstruct({empty}), InputError);
}

TEST(Reconstruct, RefusesWhatCannotBeAView) {
  const DepthView good = view_of(camera_around(0.0), {ball()}, kNoise);
  DepthView bad = good;
  bad.depth.pop_back();
  EXPECT_THROW(reconstruct({bad}), InputError);
  bad = good;
  bad.camera.fx = 0.0;
  EXPECT_THROW(reconstruct({bad}), InputError);
  bad = good;
  for (float& depth : bad.depth) depth *= 1000.0F;  // millimetres
  EXPECT_THROW(reconstruct({bad}), InputError);
  ReconstructOptions options;
  options.voxel = 0.0;
  EXPECT_THROW(reconstruct({good}, options), InputError);
}

TEST(Reconstruct, ReadingsThatAreNoNumbersAreLeftOut) {
  DepthView view = view_of(camera_around(0.0), {ball()}, kNoise);
  for (std::size_t i = 0; i < view.depth.size(); i += 7) {
    view.depth[i] = i % 2 == 0 ? std::numeric_limits<float>::infinity() : -1.0F;
  }
  expect_body(reconstruct({view}), ball(), 0.1);
}

TEST(Reconstruct, StopsWhenAsked) {
  RunContext context;
  context.cancellation.request();
  EXPECT_THROW(reconstruct({view_of(camera_around(0.0), {ball()}, kNoise)}, {}, context),
               Cancelled);
}

}  // namespace
}  // namespace prehend
