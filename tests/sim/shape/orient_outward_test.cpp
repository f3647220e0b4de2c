
#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/mesh_checks.h"
#include "sim/shape/object_generator.h"
#include "tests/support/test_meshes.h"

namespace prehend {
namespace {

using test::moved;
using test::turned_over;

TEST(OrientOutward, LeavesAnOutwardSolidAlone) {
  TriangleMesh mug = generate_object("mug", 2000);
  const TriangleMesh before = mug;
  EXPECT_EQ(orient_outward(mug), 0);
  EXPECT_EQ(mug.triangles, before.triangles);
}

TEST(OrientOutward, TurnsAnInsideOutSolid) {
  TriangleMesh mug = turned_over(generate_object("mug", 2000));
  EXPECT_EQ(orient_outward(mug), static_cast<int>(mug.triangles.size()));
  test::expect_outward_solid(mug);
}

TEST(OrientOutward, PutsAShuffledSolidInOrder) {
  TriangleMesh mug = generate_object("mug", 2000);
  Random random(3);
  int shuffled = 0;
  for (Triangle& t : mug.triangles) {
    if (random.index(2) == 0) continue;
    std::swap(t[0], t[1]);
    ++shuffled;
  }
  EXPECT_EQ(orient_outward(mug), shuffled);
  test::expect_outward_solid(mug);
}

TEST(OrientOutward, TurnsEachPartOnItsOwn) {
  TriangleMesh parts = turned_over(make_sphere(0.1));
  append(parts, moved(make_box({0.1, 0.1, 0.1}), {1, 0, 0}));
  orient_outward(parts);
  EXPECT_NEAR(signed_volume(parts), signed_volume(make_sphere(0.1)) + 0.001, 1e-12);
}

TEST(OrientOutward, KeepsACavityInward) {
  TriangleMesh hollow = make_box({1, 1, 1});
  append(hollow, turned_over(make_box({0.5, 0.5, 0.5})));
  EXPECT_EQ(orient_outward(hollow), 0);
  EXPECT_NEAR(signed_volume(hollow), 0.875, 1e-12);
}

TEST(OrientOutward, TurnsAnInsideOutHollowAsAWhole) {
  TriangleMesh hollow = turned_over(make_box({1, 1, 1}));
  append(hollow, make_box({0.5, 0.5, 0.5}));
  EXPECT_EQ(orient_outward(hollow), 24);
  EXPECT_NEAR(signed_volume(hollow), 0.875, 1e-12);
}

TEST(OrientOutward, TakesAnInnerPartOfTheSameWindingForASolid) {
  TriangleMesh nested = make_box({1, 1, 1});
  append(nested, make_box({0.5, 0.5, 0.5}));
  EXPECT_EQ(orient_outward(nested), 0);
  EXPECT_NEAR(signed_volume(nested), 1.125, 1e-12);
}

TEST(OrientOutward, KnowsASolidInsideACavity) {
  TriangleMesh nested = make_box({1, 1, 1});
  append(nested, turned_over(make_box({0.5, 0.5, 0.5})));
  append(nested, make_box({0.2, 0.2, 0.2}));
  EXPECT_EQ(orient_outward(nested), 0);
  EXPECT_NEAR(signed_volume(nested), 1.0 - 0.125 + 0.008, 1e-12);
}

TEST(OrientOutward, DoesNotTakeANeighbourForACavity) {
  // Inside the bounds of the mug, not inside its material.
  TriangleMesh parts = generate_object("mug", 2000);
  const double mug = signed_volume(parts);
  append(parts, moved(turned_over(make_box({0.02, 0.02, 0.02})), {0, 0, 0.06}));
  EXPECT_EQ(orient_outward(parts), 12);
  EXPECT_NEAR(signed_volume(parts), mug + 8e-6, 1e-12);
}

TEST(OrientOutward, TurnsAnOpenBoxOutward) {
  TriangleMesh open = turned_over(make_box({1, 1, 1}));
  open.triangles.resize(10);
  EXPECT_EQ(orient_outward(open), 10);
  TriangleMesh again = open;
  EXPECT_EQ(orient_outward(again), 0);
}

TEST(OrientOutward, LeavesAFlatSheetAsItsFirstTriangleIs) {
  TriangleMesh sheet{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 3, 2}}};
  EXPECT_EQ(orient_outward(sheet), 1);
  EXPECT_EQ(check_mesh(sheet).misoriented_edges, 0);
  EXPECT_GT(doubled_area_vector(sheet, 0).z(), 0.0);
}

TEST(OrientOutward, EndsOnAMoebiusStrip) {
  TriangleMesh strip;
  constexpr int kSteps = 24;
  for (int i = 0; i < kSteps; ++i) {
    const double turn = 2.0 * 3.14159265358979 * i / kSteps;
    const Vector3 out(std::cos(turn), std::sin(turn), 0.0);
    const Vector3 across =
        0.3 * (std::cos(0.5 * turn) * out + std::sin(0.5 * turn) * Vector3::UnitZ());
    strip.vertices.push_back(out - across);
    strip.vertices.push_back(out + across);
  }
  for (int i = 0; i < kSteps; ++i) {
    const bool last = i + 1 == kSteps;
    const int a = 2 * i;
    const int b = 2 * i + 1;
    const int c = last ? 1 : a + 2;
    const int d = last ? 0 : a + 3;
    strip.triangles.push_back({a, c, b});
    strip.triangles.push_back({b, c, d});
  }
  orient_outward(strip);
  EXPECT_GT(check_mesh(strip).misoriented_edges, 0);
}

}  // namespace
}  // namespace prehend
