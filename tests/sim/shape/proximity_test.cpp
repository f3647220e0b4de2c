// Gaps and intersections against trying every pair of triangles.
#include "sim/shape/proximity.h"

#include <cmath>
#include <set>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/object_generator.h"
#include "tests/support/brute_force.h"

namespace prehend {
namespace {

// Coordinates of up to a metre: products and their cancellation leave 1e-12 m.
constexpr double kDistanceRounding = 1e-12;

struct MeshPair {
  std::string name;
  ProximityMesh a;
  ProximityMesh b;
};

std::vector<MeshPair> mesh_pairs() {
  const ProximityMesh box(make_box({0.04, 0.06, 0.1}));
  const ProximityMesh plate(make_box_grid({0.1, 0.08, 0.002}, {6, 5, 1}));
  const ProximityMesh mug(generate_object("mug", 400));
  const ProximityMesh ball(make_sphere(0.03, 2));
  const ProximityMesh glass(generate_object("wine_glass", 400));
  TriangleMesh two = make_box({0.02, 0.02, 0.02});
  append(two, transformed(make_sphere(0.01, 1), translation({0.05, 0.0, 0.0})));
  const ProximityMesh islands(two);
  return {{"box box", box, box},        {"mug plate", mug, plate},
          {"ball box", ball, box},      {"glass mug", glass, mug},
          {"ball ball", ball, ball},    {"islands plate", islands, plate},
          {"mug islands", mug, islands}};
}

// Poses from overlapping to well apart.
Pose random_pose(Random& random) { return random.pose(random.uniform(0.02, 0.15)); }

TEST(FindGap, IsTheBruteForceGapWithoutRelativeError) {
  Random random(11);
  int apart = 0;
  int meeting = 0;
  for (const MeshPair& pair : mesh_pairs()) {
    for (int i = 0; i < 40; ++i) {
      const Pose X_AB = random_pose(random);
      const double expected =
          test::surface_gap(test::soup(pair.a.mesh()), test::soup(pair.b.mesh(), X_AB));
      const Gap gap = find_gap(pair.a, pair.b, X_AB);
      ASSERT_NEAR(gap.upper, expected, kDistanceRounding) << pair.name << " pose " << i;
      ASSERT_NEAR(gap.lower, expected, kDistanceRounding) << pair.name << " pose " << i;
      ASSERT_NEAR(triangle_gap(pair.a, pair.b, X_AB, gap.pair).distance, expected,
                  kDistanceRounding);
      ASSERT_EQ(surfaces_cross(pair.a, pair.b, X_AB), expected == 0.0)
          << pair.name << " pose " << i;
      ++(expected > 0.0 ? apart : meeting);
    }
  }
  // Both cases have to be there for the test to mean something.
  EXPECT_GT(apart, 80);
  EXPECT_GT(meeting, 80);
}

TEST(FindGap, BracketsTheGapWithinTheRelativeErrorAndTheCap) {
  Random random(12);
  for (const MeshPair& pair : mesh_pairs()) {
    for (int i = 0; i < 30; ++i) {
      const Pose X_AB = random_pose(random);
      const double expected = find_gap(pair.a, pair.b, X_AB).upper;
      GapOptions options;
      options.relative_error = random.uniform(0.0, 1.0);
      options.cap = random.uniform(0.0, 0.1);
      if (i % 3 == 0) {
        options.hint = {static_cast<int>(random.index(pair.a.mesh().triangles.size())),
                        static_cast<int>(random.index(pair.b.mesh().triangles.size()))};
      }
      const Gap gap = find_gap(pair.a, pair.b, X_AB, options);
      ASSERT_LE(gap.lower, expected + kDistanceRounding) << pair.name;
      ASSERT_GE(gap.upper, expected - kDistanceRounding) << pair.name;
      const double wanted = std::min(options.cap, gap.upper / (1.0 + options.relative_error));
      ASSERT_GE(gap.lower, wanted - kDistanceRounding) << pair.name;
      if (std::isinf(gap.upper)) {
        ASSERT_GE(expected, options.cap - kDistanceRounding);
        ASSERT_EQ(gap.pair.a, -1);
      }
    }
  }
}

TEST(FindPairsWithin, IsTheBruteForceSet) {
  Random random(13);
  std::vector<ClosePair> found;
  std::vector<TrianglePair> maybe;
  for (const MeshPair& pair : mesh_pairs()) {
    for (int i = 0; i < 10; ++i) {
      const Pose X_AB = random_pose(random);
      const double limit = find_gap(pair.a, pair.b, X_AB).upper + random.uniform(1e-4, 0.02);
      const auto a = test::soup(pair.a.mesh());
      const auto b = test::soup(pair.b.mesh(), X_AB);
      std::vector<std::pair<int, int>> expected;
      test::each_pair(
          a, b, [&] { return limit; },
          [&](std::size_t s, std::size_t t) {
            if (test::triangle_to_triangle(a[s], b[t]) > limit) return;
            expected.emplace_back(static_cast<int>(s), static_cast<int>(t));
          });
      find_pairs_within(pair.a, pair.b, X_AB, limit, found);
      std::vector<std::pair<int, int>> sorted;
      for (const ClosePair& p : found) {
        sorted.emplace_back(p.pair.a, p.pair.b);
        ASSERT_NEAR(p.distance, triangle_gap(pair.a, pair.b, X_AB, p.pair).distance, 1e-12);
        if (p.distance > 0.0) ASSERT_NEAR((p.on_a_A - p.on_b_A).norm(), p.distance, 1e-12);
      }
      std::sort(sorted.begin(), sorted.end());
      ASSERT_EQ(sorted, expected) << pair.name << " pose " << i;
      find_pairs_maybe_within(pair.a, pair.b, X_AB, limit, maybe);
      std::vector<std::pair<int, int>> among;
      for (const TrianglePair& p : maybe) among.emplace_back(p.a, p.b);
      std::sort(among.begin(), among.end());
      ASSERT_TRUE(std::includes(among.begin(), among.end(), expected.begin(), expected.end()));
    }
  }
}

// Whether the list has every pair that is closer than `limit`, and no bound exceeds a distance.
void expect_lists_near_pairs(const MeshPair& pair, const Pose& X_AB, const NearPairs& near,
                             double limit) {
  std::set<std::pair<int, int>> listed;
  for (const NearPair& p : near.pairs) {
    ASSERT_LE(p.at_least, triangle_gap(pair.a, pair.b, X_AB, p.pair).distance + kDistanceRounding);
    listed.emplace(p.pair.a, p.pair.b);
  }
  ASSERT_EQ(listed.size(), near.pairs.size());
  std::vector<ClosePair> expected;
  find_pairs_within(pair.a, pair.b, X_AB, limit, expected);
  for (const ClosePair& p : expected) ASSERT_TRUE(listed.contains({p.pair.a, p.pair.b}));
}

TEST(FindNearPairs, ListsWhatIsNearAndBoundsTheRest) {
  Random random(14);
  NearPairs near;
  for (const MeshPair& pair : mesh_pairs()) {
    for (int i = 0; i < 20; ++i) {
      SCOPED_TRACE(pair.name + " pose " + std::to_string(i));
      const Pose X_AB = random_pose(random);
      const double gap = find_gap(pair.a, pair.b, X_AB).upper;
      NearPairsOptions options;
      options.reach = random.uniform(1.0, 2.0);
      options.least_reach = random.uniform(1e-4, 5e-3);
      if (i % 3 == 0) {
        options.hint = {static_cast<int>(random.index(pair.a.mesh().triangles.size())),
                        static_cast<int>(random.index(pair.b.mesh().triangles.size()))};
      }
      ASSERT_TRUE(find_near_pairs(pair.a, pair.b, X_AB, options, near));
      ASSERT_NEAR(near.beyond, std::max(options.reach * gap, gap + options.least_reach),
                  kDistanceRounding);
      expect_lists_near_pairs(pair, X_AB, near, near.beyond - kDistanceRounding);
      // A hint at the nearest pair leaves nothing in the list for a while that is dropped later.
      options.hint = find_gap(pair.a, pair.b, X_AB).pair;
      ASSERT_TRUE(find_near_pairs(pair.a, pair.b, X_AB, options, near));
      const std::size_t count = near.pairs.size();
      options.most = count;
      EXPECT_TRUE(find_near_pairs(pair.a, pair.b, X_AB, options, near));
      options.most = count - 1;
      EXPECT_FALSE(find_near_pairs(pair.a, pair.b, X_AB, options, near));
    }
  }
}

// The list is asked while the second mesh moves, until it may no longer hold the nearest pair.
TEST(GapOfPairs, IsTheGapWhileTheListReaches) {
  Random random(15);
  NearPairs near;
  int compared = 0;
  for (const MeshPair& pair : mesh_pairs()) {
    const double radius = pair.b.ball_center().norm() + pair.b.ball_radius();
    for (int i = 0; i < 20; ++i) {
      SCOPED_TRACE(pair.name + " pose " + std::to_string(i));
      Pose X_AB = random_pose(random);
      ASSERT_TRUE(find_near_pairs(pair.a, pair.b, X_AB,
                                  {.reach = 1.0, .least_reach = 5e-3, .hint = {}}, near));
      double moved = 0.0;
      while (near.beyond > moved) {
        const double beyond = near.beyond - moved;
        const Gap gap = gap_of_pairs(pair.a, pair.b, X_AB, moved, near);
        EXPECT_EQ(near.beyond, beyond);
        const double expected = find_gap(pair.a, pair.b, X_AB).upper;
        ASSERT_EQ(gap.lower, gap.upper);
        ASSERT_GE(gap.upper, std::min(expected, near.beyond) - kDistanceRounding);
        if (gap.upper <= near.beyond) {
          ASSERT_NEAR(gap.upper, expected, kDistanceRounding);
          ++compared;
        }
        for (const NearPair& p : near.pairs) {
          ASSERT_LE(p.at_least,
                    triangle_gap(pair.a, pair.b, X_AB, p.pair).distance + kDistanceRounding);
        }
        const double angle = random.uniform(0.0, 1e-3) / radius;
        const Vector3 shift = random.vector(0.0, 5e-4);
        moved = angle * radius + shift.norm() + kDistanceRounding;
        const Matrix3 turn = Eigen::AngleAxisd(angle, random.direction()).toRotationMatrix();
        X_AB = pose_from(turn * X_AB.linear(), X_AB.translation() + shift);
      }
    }
  }
  EXPECT_GT(compared, 300);
}

// Two triangles as meshes; sizes in metres.
ProximityMesh one_triangle(const test::Corners& corners) {
  return ProximityMesh({{corners[0], corners[1], corners[2]}, {{0, 1, 2}}});
}

test::Corners random_triangle(Random& random) {
  test::Corners corners = {random.in_box(0.05), random.in_box(0.05), random.in_box(0.05)};
  const std::size_t kind = random.index(4);
  // Needles down to nanometres wide, caps whose third corner is on the opposite side, specks.
  if (kind == 1)
    corners[2] = corners[1] + random.in_box(std::pow(10.0, random.uniform(-9.0, -3.0)));
  if (kind == 2) {
    const double part = random.uniform(0.1, 0.9);
    corners[2] = corners[0] + part * (corners[1] - corners[0]) +
                 random.in_box(std::pow(10.0, random.uniform(-9.0, -3.0)));
  }
  if (kind == 3) {
    const double size = std::pow(10.0, random.uniform(-7.0, -3.0));
    corners[1] = corners[0] + random.in_box(size);
    corners[2] = corners[0] + random.in_box(size);
  }
  return corners;
}

TEST(TriangleGap, IsRightForNeedlesCapsAndSpecks) {
  Random random(14);
  for (int i = 0; i < 100000; ++i) {
    const test::Corners s = random_triangle(random);
    test::Corners t = random_triangle(random);
    if (i % 2 == 0) {  // close to each other, where it matters
      const Vector3 at = s[0] + random.in_box(1e-3);
      const Vector3 shift = at - t[random.index(3)];
      for (Vector3& p : t) p += shift;
    }
    const double expected = test::triangle_to_triangle(s, t);
    const TriangleGap gap =
        triangle_gap(one_triangle(s), one_triangle(t), Pose::Identity(), {0, 0});
    // The plane of a triangle a nanometre wide is known to a nanometre's rounding only.
    ASSERT_NEAR(gap.distance, expected, 1e-9) << "pair " << i;
    if (expected > 1e-9) {
      ASSERT_NEAR((gap.p_A - gap.p_B).norm(), expected, 1e-9) << "pair " << i;
      ASSERT_LT(test::point_to_triangle(gap.p_A, s), 1e-9) << "pair " << i;
      ASSERT_LT(test::point_to_triangle(gap.p_B, t), 1e-9) << "pair " << i;
    }
  }
}

// Large parallel faces a few hundredths of a millimetre apart: what contacts are made of.
TEST(TriangleGap, IsRightBetweenParallelFacesAndEdges) {
  Random random(15);
  const test::Corners s = {Vector3(-0.05, -0.04, 0.0), Vector3(0.06, -0.03, 0.0),
                           Vector3(0.0, 0.05, 0.0)};
  for (int i = 0; i < 2000; ++i) {
    const double height = random.uniform(1e-5, 1e-4);
    const Pose turned(Eigen::AngleAxisd(random.uniform(0.0, 6.2), Vector3::UnitZ()));
    const Pose X = translation({random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05), height}) *
                   (i % 2 == 0 ? turned : Pose::Identity());
    const Pose X_W = random.pose(0.3);
    const test::Corners t = {X * s[0], X * s[1], X * s[2]};
    test::Corners u;
    test::Corners v;
    for (std::size_t k = 0; k < 3; ++k) {
      u[k] = X_W * s[k];
      v[k] = X_W * t[k];
    }
    const TriangleGap gap =
        triangle_gap(one_triangle(u), one_triangle(v), Pose::Identity(), {0, 0});
    ASSERT_NEAR(gap.distance, test::triangle_to_triangle(s, t), kDistanceRounding) << "pair " << i;
  }
}

TEST(IsInside, AgreesWithCountingCrossings) {
  Random random(16);
  for (const char* name : {"mug", "wine_glass", "bottle", "bowl"}) {
    const ProximityMesh mesh(generate_object(name, 1000));
    const auto surface = test::soup(mesh.mesh());
    int inside = 0;
    for (int i = 0; i < 400; ++i) {
      const Vector3 p = mesh.ball_center() + random.in_box(mesh.ball_radius());
      const bool expected = test::winding(p, surface) > 0;
      ASSERT_EQ(is_inside(mesh, p), expected) << name << " " << p.transpose();
      inside += expected;
    }
    EXPECT_GT(inside, 0) << name;
  }
}

TEST(ProximityMesh, KnowsTheTrianglesAroundAVertexAndABallAroundAll) {
  const TriangleMesh mesh = generate_object("mug", 500);
  const ProximityMesh proximity(mesh);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    std::vector<int> around;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Triangle& corners = mesh.triangles[t];
      if (std::find(corners.begin(), corners.end(), static_cast<int>(v)) != corners.end()) {
        around.push_back(static_cast<int>(t));
      }
    }
    const auto found = proximity.triangles_at(static_cast<int>(v));
    EXPECT_EQ(std::vector<int>(found.begin(), found.end()), around) << v;
    EXPECT_LE((mesh.vertices[v] - proximity.ball_center()).norm(), proximity.ball_radius());
  }
}

TEST(ProximityMesh, RefusesAMeshWithoutTriangles) {
  try {
    ProximityMesh mesh(TriangleMesh{});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "mesh: has no triangles");
  }
}

}  // namespace
}  // namespace prehend
