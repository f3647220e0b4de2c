// Clouds become views in which their points are seen.
#include "sim/shape/cloud/files/cloud_views.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "tests/support/depth_images.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

using test::refusal_of;

PointCloud cloud_of(const std::vector<Vector3>& points) {
  PointCloud cloud;
  for (const Vector3& p : points) cloud.points.push_back(p.cast<float>());
  cloud.width = points.size();
  return cloud;
}

std::vector<Vector3> points_in(const std::vector<DepthView>& views) {
  std::vector<Vector3> points;
  for (const DepthView& view : views) {
    EXPECT_EQ(view.depth.size(), static_cast<std::size_t>(view.camera.width) *
                                     static_cast<std::size_t>(view.camera.height));
    const std::vector<Vector3> some = test::points_of(view);
    points.insert(points.end(), some.begin(), some.end());
  }
  return points;
}

// The largest distance of a point of `a` from the nearest of `b`.
double farthest(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
  double most = 0.0;
  for (const Vector3& p : a) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vector3& q : b) least = std::min(least, (p - q).squaredNorm());
    most = std::max(most, least);
  }
  return std::sqrt(most);
}

const DepthCamera kCamera = test::camera_at({0.5, -0.3, 0.6}, {0.0, 0.0, 0.0}, {80, 60, 75.0});

TEST(CloudViews, FromTheViewpointThePointsAreWhereTheyWere) {
  const DepthView view = test::view_of({{}}, kCamera);
  const std::vector<Vector3> points = test::points_of(view);
  std::vector<std::string> notes;
  const std::vector<DepthView> views =
      views_of_cloud(cloud_of(points), {.viewpoint = kCamera.X_WC.translation()}, notes);
  ASSERT_EQ(views.size(), 1U);
  EXPECT_TRUE(notes.empty());
  // Points are 0.8 m / 75 = 11 mm apart across, three times that along a table that is seen at 45
  // degrees or less steeply. A pixel is sqrt(1.5) times that.
  const std::vector<Vector3> seen = points_in(views);
  EXPECT_LT(farthest(seen, points), 0.02);
  EXPECT_LT(farthest(points, seen), 0.06);
  EXPECT_GT(seen.size(), points.size() / 3);
}

TEST(CloudViews, AnOrganisedCloudKeepsItsImage) {
  const DepthView view = test::view_of({{}}, kCamera);
  PointCloud cloud;
  for (int v = 0; v < kCamera.height; ++v) {
    for (int u = 0; u < kCamera.width; ++u) {
      const double z = view.depth[static_cast<std::size_t>(v * kCamera.width + u)];
      const Vector3 p((u - kCamera.cx) / kCamera.fx * z, (v - kCamera.cy) / kCamera.fy * z, z);
      const bool read = z > 0.0;
      cloud.points.push_back(
          read ? Eigen::Vector3f(p.cast<float>())
               : Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
    }
  }
  cloud.width = static_cast<std::size_t>(kCamera.width);
  cloud.height = static_cast<std::size_t>(kCamera.height);
  cloud.X_FV = Pose::Identity();
  std::vector<std::string> notes;
  const std::vector<DepthView> views = views_of_cloud(cloud, {.X_WF = kCamera.X_WC}, notes);
  ASSERT_EQ(views.size(), 1U);
  const DepthCamera& camera = views[0].camera;
  EXPECT_EQ(camera.width, kCamera.width);
  EXPECT_EQ(camera.height, kCamera.height);
  // Points have single precision.
  EXPECT_NEAR(camera.fx, kCamera.fx, 1e-3);
  EXPECT_NEAR(camera.fy, kCamera.fy, 1e-3);
  EXPECT_NEAR(camera.cx, kCamera.cx, 1e-3);
  EXPECT_NEAR(camera.cy, kCamera.cy, 1e-3);
  EXPECT_TRUE(camera.X_WC.isApprox(kCamera.X_WC));
  EXPECT_EQ(views[0].depth, view.depth);
}

TEST(CloudViews, AllAroundTheViewpointIsSeen) {
  Random random(1);
  std::vector<Vector3> points;
  for (int i = 0; i < 4000; ++i) points.push_back(0.5 * random.direction());
  std::vector<std::string> notes;
  const std::vector<DepthView> views =
      views_of_cloud(cloud_of(points), {.viewpoint = Vector3::Zero()}, notes);
  EXPECT_EQ(views.size(), 6U);
  EXPECT_LT(farthest(points, points_in(views)), 0.05);
}

TEST(CloudViews, NormalsChooseCamerasThatTheyFace) {
  Random random(2);
  std::vector<Vector3> points;
  for (int i = 0; i < 3000; ++i) points.push_back(0.05 * random.direction());
  PointCloud cloud = cloud_of(points);
  for (const Vector3& p : points) cloud.normals.push_back((60.0 * p).cast<float>());  // length 3
  std::vector<std::string> notes;
  const std::vector<DepthView> views = views_of_cloud(cloud, {}, notes);
  EXPECT_GE(views.size(), 6U);
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_EQ(notes[0], "3000 normals are not unit: normalised");
  const std::vector<Vector3> seen = points_in(views);
  EXPECT_LT(farthest(points, seen), 0.008);
  EXPECT_LT(farthest(seen, points), 0.006);
  // Of a ball, what a camera sees is on its side.
  for (const DepthView& view : views) {
    for (const Vector3& p : test::points_of(view)) {
      EXPECT_GT((view.camera.X_WC.translation() - p).dot(p), 0.0);
    }
  }
}

std::string why(const PointCloud& cloud, const CloudPlace& place = {}) {
  std::vector<std::string> notes;
  return refusal_of([&] { views_of_cloud(cloud, place, notes); }).what();
}

TEST(CloudViews, WhatIsNoCloudIsRefused) {
  const std::vector<Vector3> points = test::points_of(test::view_of({{}}, kCamera));
  EXPECT_EQ(why({}), "only 0 readings; at least 10 are needed");
  EXPECT_EQ(why(cloud_of({{0.0, 0.0, 1.0}})), "only 1 readings; at least 10 are needed");
  EXPECT_EQ(why(cloud_of(std::vector<Vector3>(20, Vector3::Zero()))),
            "only 0 readings; at least 10 are needed");
  PointCloud nothing = cloud_of(std::vector<Vector3>(20, Vector3(0.0, 0.0, std::nan(""))));
  EXPECT_EQ(why(nothing), "no reading: none of the 20 points is finite");
  EXPECT_EQ(why(cloud_of({{0.0, 0.0, 2e6}})), "point 0 is farther out than 1e6 m");
  const std::string in_millimetres =
      why(cloud_of(points), {.metres_per_unit = 1000.0, .viewpoint = kCamera.X_WC.translation()});
  EXPECT_EQ(in_millimetres.find("unit: distances look like millimetres that were read in metres: "
                                "state the unit (middle distance "),
            0U)
      << in_millimetres;
  EXPECT_EQ(why(cloud_of(points), {.metres_per_unit = 1e-3}).find("unit: distances are smaller"),
            0U);
}

TEST(CloudViews, PointsThatAreNoNumbersAreCounted) {
  std::vector<Vector3> points = test::points_of(test::view_of({{}}, kCamera));
  points[5].x() = std::numeric_limits<double>::quiet_NaN();
  points[7].y() = std::numeric_limits<double>::infinity();
  std::vector<std::string> notes;
  views_of_cloud(cloud_of(points), {}, notes);
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_EQ(notes[0], "2 points are not finite: no readings");
  EXPECT_EQ(notes[1],
            "nobody says where the camera stood: at the origin, unless viewpoint is stated");
}

}  // namespace
}  // namespace prehend
