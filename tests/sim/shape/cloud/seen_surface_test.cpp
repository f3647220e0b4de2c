// Planes of windows, axes and mirrors, from readings of known shapes.
#include "sim/shape/cloud/seen_surface.h"

#include <gtest/gtest.h>

#include "sim/shape/cloud/cluster_readings.h"
#include "sim/shape/cloud/fit_axis.h"
#include "sim/shape/cloud/support_plane.h"
#include "tests/support/shown_shapes.h"

namespace prehend {
namespace {

TEST(SeenSurface, NoiseIsFound) {
  for (const double noise : {0.0005, 0.001, 0.003}) {
    const DepthView view = view_of(camera_around(0.0), {}, noise);
    EXPECT_NEAR(noise_of(view) / noise, 1.0, 0.05);
  }
  EXPECT_LE(noise_of(view_of(camera_around(0.0), {}, 0.0)), 1.01e-4);
}

TEST(SeenSurface, WindowsAverageTheNoise) {
  const double noise = 0.0013;
  const DepthView view = view_of(camera_around(0.0), {}, noise);
  const PlaneFitter fitter(view, noise);
  double sum = 0.0;
  double tilts = 0.0;
  int count = 0;
  for (int v = 200; v < 280; v += 8) {
    for (int u = 280; u < 360; u += 8) {
      const LocalPlane plane = fitter.at(u, v);
      ASSERT_TRUE(plane.exists());
      const Eigen::Vector3f ray = pixel_ray(view.camera, u, v);
      const Vector3 p_W = view.camera.X_WC * (ray / plane.inverse.dot(ray)).cast<double>();
      sum += p_W.z() * p_W.z();
      const Vector3 normal = view.camera.X_WC.linear() * plane.normal().cast<double>();
      tilts += 1.0 - normal.z();
      ++count;
    }
  }
  // Of 49 readings, along a ray that meets the table at 40 degrees, the mean deviates by a seventh.
  EXPECT_LT(std::sqrt(sum / count), 1.3 * noise * 0.643 / 7.0);
  EXPECT_LT(std::acos(1.0 - tilts / count), 0.12);
}

TEST(SupportPlane, NeedsSomethingOnIt) {
  const DepthView empty = view_of(camera_around(0.0), {}, 0.001);
  EXPECT_TRUE(find_support({empty}, 0.001, 1).plane_only);
  const ShownShape ball{ShownShape::Kind::ball, Vector3::Constant(0.03),
                        translation({0.0, 0.0, 0.03})};
  EXPECT_FALSE(find_support({view_of(camera_around(0.0), {ball}, 0.001, false)}, 0.001, 1).found);
  const PlaneSearch something =
      find_support({view_of(camera_around(0.0), {ball}, 0.001)}, 0.001, 1);
  ASSERT_TRUE(something.found);
  EXPECT_TRUE(above_outline(something.found->plane, Vector3(0.0, 0.0, 0.1), 0.0));
  EXPECT_FALSE(above_outline(something.found->plane, Vector3(2.0, 0.0, 0.1), 0.0));
}

TEST(ReadingClusters, JoinWhatIsNear) {
  ReadingClusters clusters(0.01);
  for (int i = 0; i < 100; ++i) clusters.add(Vector3(0.001 * i, 0.0, 0.0));
  for (int i = 0; i < 50; ++i) clusters.add(Vector3(0.15 + 0.001 * i, 0.0, 0.0));
  for (int i = 0; i < 2; ++i) clusters.add(Vector3(1.0, 1.0, 1.0));
  clusters.join(5);
  ASSERT_EQ(clusters.count(), 2);
  EXPECT_EQ(clusters.readings(0), 100U);
  EXPECT_EQ(clusters.readings(1), 50U);
  EXPECT_EQ(clusters.left_out(), 1);
  EXPECT_EQ(clusters.cluster_at(Vector3(0.05, 0.0, 0.0)), 0);
  EXPECT_EQ(clusters.cluster_at(Vector3(0.17, 0.0, 0.0)), 1);
  EXPECT_EQ(clusters.cluster_at(Vector3(1.0, 1.0, 1.0)), -1);
  EXPECT_EQ(clusters.cluster_at(Vector3(0.125, 0.0, 0.0)), -1);
}

TEST(ReadingClusters, CellsOfASingleReadingJoinNothing) {
  for (const int each : {1, 2}) {
    ReadingClusters clusters(0.01);
    for (int i = 0; i < 100; ++i) clusters.add(Vector3(0.001 * i, 0.0, 0.0));
    for (int i = 0; i < 50; ++i) clusters.add(Vector3(0.2 + 0.001 * i, 0.0, 0.0));
    for (int i = 0; i < 10 * each; ++i) {
      clusters.add(Vector3(0.105 + 0.01 * (i / each), 0.0, 0.0));
    }
    clusters.join(5);
    EXPECT_EQ(clusters.count(), each == 1 ? 2 : 1);
    EXPECT_EQ(clusters.left_out(), 0);
  }
}

TEST(FitAxis, OfHalfACylinder) {
  Random random(5);
  for (int round = 0; round < 10; ++round) {
    const Pose X_WA = random.pose(0.2);
    std::vector<SeenPoint> points;
    for (int i = 0; i < 200; ++i) {
      const double angle = random.uniform(0.0, 2.5);
      const double along = random.uniform(-0.08, 0.08);
      SeenPoint point;
      point.normal_P = X_WA.linear() * Vector3(std::cos(angle), std::sin(angle), 0.0);
      point.p_P = X_WA * Vector3(0.03 * std::cos(angle), 0.03 * std::sin(angle), along);
      points.push_back(point);
    }
    const Vector3 axis = X_WA.linear().col(2);
    const AxisFit fit = fit_axis(points, axis);
    EXPECT_LT(fit.misfit, 1e-6);
    EXPECT_LT((fit.point - X_WA.translation()).cross(axis).norm(), 1e-5);
    // Of directions that are 10 degrees apart, the best is near the axis.
    EXPECT_GT(std::abs(find_axes(points, 1).front().direction.dot(axis)), std::cos(0.25));
  }
}

}  // namespace
}  // namespace prehend
