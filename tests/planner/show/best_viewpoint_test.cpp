// Which side of a grasp is shown.
#include "planner/show/best_viewpoint.h"

#include <set>

#include <gtest/gtest.h>

#include "planner/show/grasp_bodies.h"
#include "planner/show/picture/draw.h"
#include "tests/support/held_cube.h"

namespace prehend {
namespace {

using test::held_cube;
using test::HeldCube;

// How many cones show in a picture with one flat colour a cone, where all but the object is solid.
int cones_seen(const HeldCube& held, const Vector3& direction) {
  const GraspBodies bodies = grasp_bodies(held.scene, held.grasp);
  const DrawOptions options{.width = 200,
                            .height = 160,
                            .samples = 1,
                            .lighting = {.sky = 1, .ground = 1, .key = 0, .fill = 0, .gloss = 0},
                            .line_width = 0.0};
  const Camera camera = camera_around(bodies.grasp(), direction, options);
  std::vector<DrawnBody> drawn = bodies.hand;
  for (const DrawnBody& body : bodies.surroundings()) drawn.push_back(body);
  for (DrawnBody& body : drawn) body.color = {0.0, 0.0, 0.0, 1.0};
  for (std::size_t c = 0; c < bodies.contacts.size(); ++c) {
    drawn.push_back(bodies.contacts[c]);
    drawn.back().color = {static_cast<double>(c + 1) / 100.0, 0.0, 0.0, 1.0};
  }
  const Image image = draw(drawn, camera, options);
  std::set<int> reds;
  for (std::size_t at = 0; at < image.rgb.size(); at += 3) {
    if (image.rgb[at] > 0 && image.rgb[at + 1] == 0) reds.insert(image.rgb[at]);
  }
  return static_cast<int>(reds.size());
}

TEST(TellingSide, SeesAllContactsOfACubeWhereOtherSidesHideSome) {
  const HeldCube held = held_cube();
  const int contacts = static_cast<int>(held.grasp.contacts.size());
  ASSERT_EQ(held.trial.outcome, Outcome::stable);
  ASSERT_GE(contacts, 4);
  EXPECT_LT(cones_seen(held, Vector3::UnitX()), contacts);  // from behind a finger
  EXPECT_LT(cones_seen(held, Vector3::UnitZ()), contacts);  // from behind the palm
  const Vector3 side = best_viewpoint(held.scene, held.grasp);
  EXPECT_EQ(cones_seen(held, side), contacts);
  EXPECT_LT(std::abs(side.x()), 0.5);  // across the fingers' way
}

TEST(TellingSide, IsNotBehindAWall) {
  const Vector3 size(1.0, 0.02, 1.0);
  for (const double y : {0.15, -0.15}) {
    const HeldCube held = held_cube({test::obstacle(make_box(size), {0, y, 0})});
    const Vector3 side = best_viewpoint(held.scene, held.grasp);
    EXPECT_LT(side.y() * y, 0.0);
    EXPECT_EQ(cones_seen(held, side), static_cast<int>(held.grasp.contacts.size()));
  }
}

// Both boards leave all cones to be seen. The links alone are seen a little better past the larger
// one, but it covers more of the hand.
TEST(TellingSide, PrefersTheSideOnWhichLessStandsBeforeTheHand) {
  for (const double side : {1.0, -1.0}) {
    const HeldCube held = held_cube(
        {test::obstacle(make_box({0.0232, 0.02, 0.0279}), {-0.0094 * side, 0.12 * side, 0.0691}),
         test::obstacle(make_box({0.0588, 0.02, 0.0378}), {0.0146 * side, -0.12 * side, 0.1028})});
    EXPECT_GT(best_viewpoint(held.scene, held.grasp).y() * side, 0.9);
  }
}

// Whose triangles are fewer where pixels are counted.
TEST(TellingSide, OfMeshesWithManyTrianglesIsTheSame) {
  const Vector3 size(1.0, 0.02, 1.0);
  for (const double y : {0.15, -0.15}) {
    const HeldCube plain = held_cube({test::obstacle(make_box(size), {0, y, 0})});
    const HeldCube fine = held_cube({test::obstacle(make_box(size, 60), {0, y, 0})});
    const Vector3 side = best_viewpoint(plain.scene, plain.grasp);
    EXPECT_EQ(best_viewpoint(fine.scene, fine.grasp), side);
    // Nor does it depend on what was looked at before.
    const ViewpointSearch search(fine.scene);
    PosedGrasp turned = fine.grasp;
    turned.X_OH = turned.X_OH * Eigen::AngleAxisd(1.0, Vector3::UnitZ());
    search.best(turned);
    EXPECT_EQ(search.best(fine.grasp), side);
  }
}

TEST(TellingSide, IsThereInAClosedBoxAndWithoutContacts) {
  HeldCube held = held_cube({test::obstacle(make_box({0.26, 0.26, 0.02}), {0, 0, 0.18}),
                             test::obstacle(make_box({0.26, 0.26, 0.02}), {0, 0, -0.18}),
                             test::obstacle(make_box({0.02, 0.26, 0.34}), {0.12, 0, 0}),
                             test::obstacle(make_box({0.02, 0.26, 0.34}), {-0.12, 0, 0}),
                             test::obstacle(make_box({0.22, 0.02, 0.34}), {0, 0.12, 0}),
                             test::obstacle(make_box({0.22, 0.02, 0.34}), {0, -0.12, 0})});
  const Vector3 side = best_viewpoint(held.scene, held.grasp);
  EXPECT_EQ(cones_seen(held, side), 0);
  EXPECT_LT(std::abs(side.x()), 0.5);
  held.grasp.contacts.clear();
  EXPECT_NEAR(best_viewpoint(held.scene, held.grasp).norm(), 1.0, 1e-12);
}

}  // namespace
}  // namespace prehend
