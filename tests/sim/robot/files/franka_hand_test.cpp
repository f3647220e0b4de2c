// The Franka hand against the published gripper: every vertex and points all over both surfaces.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "sim/robot/files/robot_file.h"
#include "sim/shape/files/mesh_file.h"
#include "tests/sim/robot/files/hand_shape.h"
#include "tests/support/brute_force.h"
#include "tests/support/shared_data.h"

namespace prehend {
namespace {

constexpr const char* kPublished = "data/robots/franka_hand/franka_gripper_open_80mm.stl";
constexpr double kTrueTo = 1e-3;
constexpr double kSpacing = 3e-3;  // of the points on a surface [m]

// The triangles that are connected to the vertex `from` by shared vertices.
std::vector<test::Corners> piece_at(const TriangleMesh& mesh, std::size_t from) {
  std::vector<bool> reached(mesh.vertices.size(), false);
  reached[from] = true;
  const auto is_reached = [&](int v) { return reached[static_cast<std::size_t>(v)]; };
  for (bool grows = true; grows;) {
    grows = false;
    for (const Triangle& t : mesh.triangles) {
      if (std::none_of(t.begin(), t.end(), is_reached)) continue;
      if (std::all_of(t.begin(), t.end(), is_reached)) continue;
      for (const int v : t) reached[static_cast<std::size_t>(v)] = true;
      grows = true;
    }
  }
  TriangleMesh piece{mesh.vertices, {}};
  for (const Triangle& t : mesh.triangles) {
    if (is_reached(t[0])) piece.triangles.push_back(t);
  }
  return test::soup(piece);
}

// The piece of the published gripper that reaches farthest in a direction of the hand's frame.
std::vector<test::Corners> published_piece(const Vector3& direction) {
  const TriangleMesh mesh = load_mesh(test::shared(kPublished)).mesh;
  const auto farthest = std::max_element(
      mesh.vertices.begin(), mesh.vertices.end(),
      [&](const Vector3& a, const Vector3& b) { return direction.dot(a) < direction.dot(b); });
  return piece_at(mesh, static_cast<std::size_t>(farthest - mesh.vertices.begin()));
}

// Corners and a grid between them.
std::vector<Vector3> points_on(const std::vector<test::Corners>& surface) {
  std::vector<Vector3> points;
  for (const auto& [a, b, c] : surface) {
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    const int steps = 1 + static_cast<int>(longest / kSpacing);
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; i + j <= steps; ++j) {
        points.emplace_back(a + (i * (b - a) + j * (c - a)) / steps);
      }
    }
  }
  return points;
}

double distance_from(const std::vector<test::Corners>& surface, const Vector3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const test::Corners& t : surface) least = std::min(least, test::point_to_triangle(p, t));
  return least;
}

// How far the point of `points` that is farthest from the surface is from it.
double farthest_from(const std::vector<test::Corners>& surface,
                     const std::vector<Vector3>& points) {
  double most = 0.0;
  for (const Vector3& p : points) most = std::max(most, distance_from(surface, p));
  return most;
}

TEST(FrankaHand, BodyIsThePublishedOneToAMillimetre) {
  PREHEND_NEEDS_SHARED(kPublished);
  const std::vector<test::Corners> published = published_piece(-Vector3::UnitZ());
  ASSERT_EQ(published.size(), 200U);
  const std::vector<test::Corners> ours = test::soup(find_robot("franka_hand").links[0].mesh);
  EXPECT_LT(farthest_from(ours, points_on(published)), kTrueTo);
  EXPECT_LT(farthest_from(published, points_on(ours)), kTrueTo);
}

// How far the point of `points` that is farthest outside of a convex surface is above its faces.
double farthest_above(const std::vector<test::Corners>& convex,
                      const std::vector<Vector3>& points) {
  double most = 0.0;
  for (const Vector3& p : points) {
    for (const auto& [a, b, c] : convex) {
      most = std::max(most, (p - a).dot((b - a).cross(c - a).normalized()));
    }
  }
  return most;
}

// The published fingers are the convex hulls of the real ones, which are hollow behind the tip:
// only their corners have to be points of ours, and ours must not stand out of the hulls.
TEST(FrankaHand, FingersHaveThePublishedCornersToAMillimetre) {
  PREHEND_NEEDS_SHARED(kPublished);
  const Robot robot = find_robot("franka_hand");
  const std::vector<Pose> X_BL = test::poses_at(robot, {0.04});
  for (const double side : {-1.0, 1.0}) {
    const std::vector<test::Corners> published = published_piece({0.1 * side, 0.0, 1.0});
    ASSERT_EQ(published.size(), 32U);
    std::vector<test::Corners> ours;
    for (std::size_t l = 1; l < robot.links.size(); ++l) {
      const std::vector<test::Corners> link = test::soup(robot.links[l].mesh, X_BL[l]);
      if (link[0][0].x() * side > 0.0) ours.insert(ours.end(), link.begin(), link.end());
    }
    std::vector<Vector3> corners;
    for (const test::Corners& t : published) corners.insert(corners.end(), t.begin(), t.end());
    EXPECT_LT(farthest_from(ours, corners), kTrueTo);
    EXPECT_LT(farthest_above(published, points_on(ours)), kTrueTo);
  }
}

}  // namespace
}  // namespace prehend
