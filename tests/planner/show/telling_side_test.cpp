// Which side of a grasp is shown.
#include "planner/show/telling_side.h"

#include <set>

#include <gtest/gtest.h>

#include "tests/support/held_cube.h"

namespace prehend {
namespace {

using test::held_cube;
using test::HeldCube;

// How many cones show in a picture with one flat colour a cone, where all but the object is solid.
int cones_seen(const HeldCube& held, const Vector3& direction) {
  std::vector<DrawnBody> bodies = grasp_bodies(held.scene, held.grasp);
  const DrawOptions options{.width = 200,
                            .height = 160,
                            .samples = 1,
                            .lighting = {.sky = 1, .ground = 1, .key = 0, .fill = 0, .gloss = 0},
                            .line_width = 0.0};
  const Camera camera = camera_around(bodies, direction, options);
  bodies.erase(bodies.begin());
  const std::size_t links = held.scene.scene.hand.links.size();
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const double red = b < links ? 0.0 : static_cast<double>(b - links + 1) / 100.0;
    bodies[b].color = {red, 0.0, 0.0, 1.0};
  }
  for (DrawnBody body : surrounding_bodies(held.scene, held.grasp)) {
    body.color = {0.0, 0.0, 0.0, 1.0};
    bodies.push_back(body);
  }
  const Image image = draw(bodies, camera, options);
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
  const Vector3 side = telling_side(held.scene, held.grasp);
  EXPECT_EQ(cones_seen(held, side), contacts);
  EXPECT_LT(std::abs(side.x()), 0.5);  // across the fingers' way
}

TEST(TellingSide, IsNotBehindAWall) {
  const Vector3 size(1.0, 0.02, 1.0);
  for (const double y : {0.15, -0.15}) {
    const HeldCube held = held_cube({test::obstacle(make_box(size), {0, y, 0})});
    const Vector3 side = telling_side(held.scene, held.grasp);
    EXPECT_LT(side.y() * y, 0.0);
    EXPECT_EQ(cones_seen(held, side), static_cast<int>(held.grasp.contacts.size()));
  }
}

TEST(TellingSide, IsThereInAClosedBoxAndWithoutContacts) {
  HeldCube held = held_cube({test::obstacle(make_box({0.26, 0.26, 0.02}), {0, 0, 0.18}),
                             test::obstacle(make_box({0.26, 0.26, 0.02}), {0, 0, -0.18}),
                             test::obstacle(make_box({0.02, 0.26, 0.34}), {0.12, 0, 0}),
                             test::obstacle(make_box({0.02, 0.26, 0.34}), {-0.12, 0, 0}),
                             test::obstacle(make_box({0.22, 0.02, 0.34}), {0, 0.12, 0}),
                             test::obstacle(make_box({0.22, 0.02, 0.34}), {0, -0.12, 0})});
  const Vector3 side = telling_side(held.scene, held.grasp);
  EXPECT_EQ(cones_seen(held, side), 0);
  EXPECT_LT(std::abs(side.x()), 0.5);
  held.grasp.contacts.clear();
  EXPECT_NEAR(telling_side(held.scene, held.grasp).norm(), 1.0, 1e-12);
}

}  // namespace
}  // namespace prehend
