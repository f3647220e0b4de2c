// No body that reaches into a region is missed, and far ones are not looked at.
#include "sim/scene/body_tree.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"
#include "tests/support/brute_force.h"

namespace prehend {
namespace {

std::vector<PlacedBody> random_bodies(Random& random, int count) {
  std::vector<PlacedBody> bodies;
  for (int b = 0; b < count; ++b) {
    const Vector3 size = Vector3::Constant(0.02) + random.in_box(0.1).cwiseAbs();
    bodies.push_back({make_collision_body("body", make_box(size), true), random.pose(0.4)});
  }
  return bodies;
}

// Whether a body reaches into the region, from points along it; with `slack` [m] to spare.
bool reaches_into(const PlacedBody& body, const SweptBall& region, double slack) {
  const auto triangles = test::soup(body.mesh.mesh(), body.X_RB);
  for (int k = 0; k <= 40; ++k) {
    const Vector3 p = region.from + k / 40.0 * (region.to - region.from);
    if (test::point_to_surface(p, triangles) <= region.radius - slack) return true;
  }
  return false;
}

TEST(BodyTree, FindsAllObstaclesInTheRegionInOrderAndNotTheObject) {
  Random random(71);
  int found_in_all = 0;
  for (const int count : {2, 3, 6, 30, 120}) {
    const std::vector<PlacedBody> bodies = random_bodies(random, count);
    const BodyTree tree(bodies);
    NearBodies near;
    const std::vector<BodyId>& found = near.found;
    for (int run = 0; run < 20; ++run) {
      const Vector3 from = random.in_box(0.4);
      const SweptBall region{from, run % 4 == 0 ? from : from + random.in_box(0.2).eval(),
                             random.uniform(0.0, 0.15)};
      tree.find(region, near);
      found_in_all += static_cast<int>(found.size());
      EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
      EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
      EXPECT_EQ(std::count(found.begin(), found.end(), BodyId::object()), 0);
      for (std::size_t b = 1; b < bodies.size(); ++b) {
        if (!reaches_into(bodies[b], region, 1e-12)) continue;
        EXPECT_EQ(std::count(found.begin(), found.end(), BodyId::at(b)), 1);
      }
    }
  }
  // 156 obstacles and 20 regions each, of which few meet.
  EXPECT_LT(found_in_all, 20 * 156 / 4);
  EXPECT_GT(found_in_all, 20);
}

TEST(BodyTree, OfNoObstaclesFindsNone) {
  Random random(72);
  NearBodies near{.found = {BodyId::obstacle(3)}, .in_box = {3}};
  BodyTree(random_bodies(random, 1)).find({Vector3::Zero(), Vector3::Zero(), 10.0}, near);
  EXPECT_TRUE(near.found.empty());
  near.found = {BodyId::obstacle(3)};
  BodyTree().find({Vector3::Zero(), Vector3::Zero(), 10.0}, near);
  EXPECT_TRUE(near.found.empty());
}

}  // namespace
}  // namespace prehend
