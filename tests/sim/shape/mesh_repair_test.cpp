#include "sim/shape/mesh_repair.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/make_mesh.h"
#include "sim/shape/mass_properties.h"
#include "sim/shape/object_generator.h"
#include "tests/support/refusal_of.h"
#include "tests/support/test_meshes.h"
#include "tests/support/turns.h"

namespace prehend {
namespace {

bool same(const TriangleMesh& a, const TriangleMesh& b) {
  return a.vertices == b.vertices && a.triangles == b.triangles;
}

// The mesh without the triangles for which `dropped` holds of their centre.
template <typename Dropped>
TriangleMesh without(TriangleMesh mesh, const Dropped& dropped) {
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    Vector3 center = Vector3::Zero();
    for (const int v : t) center += mesh.vertices[static_cast<std::size_t>(v)] / 3.0;
    return dropped(center);
  });
  return mesh;
}

TriangleMesh without_top(const TriangleMesh& box) {
  const double top = bounds(box).upper.z();
  return without(box, [&](const Vector3& p) { return p.z() > 0.999 * top; });
}

// Every `step`-th triangle turned over.
TriangleMesh partly_turned(TriangleMesh mesh, std::size_t step) {
  for (std::size_t t = 0; t < mesh.triangles.size(); t += step) {
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
  return mesh;
}

TEST(MeshRepair, LeavesClosedMeshesAsTheyAre) {
  for (const char* name : {"mug", "wine_glass", "bowl", "phone"}) {
    const TriangleMesh mesh = generate_object(name, 3000);
    const MeshRepair repair = repair_mesh(mesh);
    EXPECT_TRUE(same(repair.mesh, mesh)) << name;
    EXPECT_FALSE(repair.changed());
    EXPECT_EQ(repair.faced, 0);
    EXPECT_EQ(repair_text(repair), "");
  }
}

TEST(MeshRepair, ClosesAMissingFaceExactly) {
  for (const int cells : {1, 2, 7}) {
    const MeshRepair repair = repair_mesh(without_top(make_box({2, 3, 4}, cells)));
    EXPECT_EQ(repair.before.boundary_edges, 4 * cells);
    EXPECT_EQ(repair.holes, 1);
    EXPECT_EQ(repair.holes_left, 0);
    EXPECT_DOUBLE_EQ(repair.patch_area, 6.0);
    test::expect_outward_solid(repair.mesh);
    EXPECT_NEAR(signed_volume(repair.mesh), 24.0, 1e-12);
  }
}

TEST(MeshRepair, ClosesAMissingTriangleExactly) {
  const TriangleMesh box = make_box({2, 3, 4}, 3);
  for (std::size_t t = 0; t < box.triangles.size(); ++t) {
    TriangleMesh open = box;
    open.triangles.erase(open.triangles.begin() + static_cast<std::ptrdiff_t>(t));
    const MeshRepair repair = repair_mesh(open);
    EXPECT_TRUE(repair.after.solid()) << t;
    EXPECT_NEAR(signed_volume(repair.mesh), 24.0, 1e-12) << t;
  }
}

TEST(MeshRepair, ClosesABentHoleInASphereNearly) {
  const TriangleMesh sphere = make_sphere(1.0, 4);
  // A cap of 12 degrees, about 1 % of the surface.
  const TriangleMesh open = without(sphere, [](const Vector3& p) { return p.z() > 0.98; });
  const MeshRepair repair = repair_mesh(open);
  test::expect_outward_solid(repair.mesh);
  // A plane instead of the cap of height h takes pi h^2 (1 - h / 3) away; the rim is not quite
  // flat.
  EXPECT_LT(signed_volume(repair.mesh), signed_volume(sphere));
  EXPECT_NEAR(signed_volume(repair.mesh), signed_volume(sphere), 4 * 0.02 * 0.02);
}

TEST(MeshRepair, TurnsTrianglesThatDisagreeWithTheirNeighbours) {
  const TriangleMesh sphere = make_sphere(1.0, 3);
  const MeshRepair repair = repair_mesh(partly_turned(sphere, 7));
  EXPECT_EQ(repair.turned, static_cast<int>((sphere.triangles.size() + 6) / 7));
  EXPECT_EQ(repair.faced, 0);
  EXPECT_DOUBLE_EQ(signed_volume(repair.mesh), signed_volume(sphere));
  EXPECT_TRUE(repair.after.solid());
}

TEST(MeshRepair, KeepsTheCavityOfAHollowBall) {
  const TriangleMesh outer = make_sphere(1.0, 3);
  const TriangleMesh inner = make_sphere(0.6, 3);
  const double hollow = signed_volume(outer) - signed_volume(inner);
  TriangleMesh ball = outer;
  append(ball, test::turned_over(inner));
  EXPECT_TRUE(same(repair_mesh(ball).mesh, ball));
  // Inside out as a whole, with turned triangles, and with a hole in both shells.
  EXPECT_NEAR(signed_volume(repair_mesh(test::turned_over(ball)).mesh), hollow, 1e-12);
  EXPECT_NEAR(signed_volume(repair_mesh(partly_turned(ball, 9)).mesh), hollow, 1e-12);
  TriangleMesh open = ball;
  open.triangles.erase(open.triangles.end() - 1);
  open.triangles.erase(open.triangles.begin());
  const MeshRepair repair = repair_mesh(open);
  EXPECT_EQ(repair.holes, 2);
  EXPECT_TRUE(repair.after.solid());
  EXPECT_NEAR(signed_volume(repair.mesh), hollow, 1e-12);
}

// A box whose top is divided more finely than its sides: the middle of each upper edge is a vertex
// of the top alone.
TriangleMesh box_with_finer_top() {
  TriangleMesh mesh = without_top(make_box({2, 2, 2}));
  append(mesh, without(make_box({2, 2, 2}, 2), [](const Vector3& p) { return p.z() < 0.999; }));
  return make_mesh(mesh.vertices, mesh.triangles);
}

TEST(MeshRepair, JoinsTrianglesWhereAVertexLiesOnAnEdge) {
  const TriangleMesh mesh = box_with_finer_top();
  EXPECT_EQ(check_mesh(mesh).boundary_edges, 12);
  const MeshRepair repair = repair_mesh(mesh);
  EXPECT_EQ(repair.cracks, 4);
  EXPECT_EQ(repair.holes, 0);
  test::expect_outward_solid(repair.mesh);
  EXPECT_DOUBLE_EQ(signed_volume(repair.mesh), 8.0);
}

TEST(MeshRepair, DropsDustOnly) {
  const TriangleMesh sphere = make_sphere(1.0, 3);
  TriangleMesh dusty = sphere;
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    const Vector3 place = random.in_box({-3, -3, 2}, {3, 3, 3});
    append(dusty, test::moved(i % 2 == 0 ? make_box({0.01, 0.01, 0.01})
                                         : without_top(make_box({0.02, 0.02, 0.02})),
                              place));
  }
  const MeshRepair repair = repair_mesh(dusty);
  EXPECT_EQ(repair.dust_shells, 20);
  EXPECT_EQ(repair.dust_triangles, 10 * 12 + 10 * 10);
  EXPECT_TRUE(same(repair.mesh, sphere));
  // Beads are as small, but they are most of the surface.
  TriangleMesh beads;
  for (int i = 0; i < 200; ++i) append(beads, test::moved(make_sphere(0.01, 1), {0.05 * i, 0, 0}));
  append(beads, make_box({10, 0.01, 0.01}));
  EXPECT_EQ(repair_mesh(beads).dust_shells, 0);
}

TEST(MeshRepair, LeavesOpenWhatCannotBeClosed) {
  const auto expect_open = [](const TriangleMesh& mesh, int rims) {
    const MeshRepair repair = repair_mesh(mesh);
    EXPECT_EQ(repair.holes, 0);
    EXPECT_EQ(repair.holes_left, rims);
    EXPECT_EQ(repair.mesh.triangles.size(), mesh.triangles.size());
  };
  const TriangleMesh box = make_box({1, 1, 1}, 2);
  // A square, half a box, a square tube, and a vessel of two walls without its rim.
  expect_open(without(box, [](const Vector3& p) { return p.z() < 0.499; }), 1);
  expect_open(without(box, [](const Vector3& p) { return p.z() < 0.01; }), 1);
  const TriangleMesh tube =
      without(make_box({1, 1, 8}), [](const Vector3& p) { return std::abs(p.z()) > 3.99; });
  expect_open(tube, 2);
  TriangleMesh vessel = without_top(make_box({1, 1, 2}));
  append(vessel, test::turned_over(without_top(make_box({0.9, 0.9, 2}))));
  expect_open(vessel, 2);
}

TEST(MeshRepair, KeepsADoubledSquareAsOneSheet) {
  const std::vector<Vector3> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const TriangleMesh sheet = make_mesh(corners, {{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 3, 2}});
  const MeshRepair repair = repair_mesh(sheet);
  EXPECT_EQ(repair.mesh.triangles.size(), 2u);
  EXPECT_EQ(repair.holes_left, 1);
  EXPECT_EQ(mass_properties(repair.mesh).source, MassSource::surface);
}

// Everything at once: a ball with a few holes, turned triangles and dust.
TriangleMesh damaged_ball() {
  TriangleMesh ball = partly_turned(make_sphere(0.05, 4), 11);
  for (const std::size_t t : {std::size_t{3}, std::size_t{500}, std::size_t{501}}) {
    ball.triangles.erase(ball.triangles.begin() + static_cast<std::ptrdiff_t>(t));
  }
  append(ball, test::moved(make_box({1e-4, 1e-4, 1e-4}), {0.1, 0, 0}));
  return ball;
}

TEST(MeshRepair, RepairsNothingTwice) {
  for (const TriangleMesh& mesh :
       {damaged_ball(), box_with_finer_top(), without_top(make_box({1, 2, 3}, 3))}) {
    const MeshRepair first = repair_mesh(mesh);
    EXPECT_TRUE(first.changed());
    const MeshRepair second = repair_mesh(first.mesh);
    EXPECT_FALSE(second.changed());
    EXPECT_TRUE(same(second.mesh, first.mesh));
  }
}

TEST(MeshRepair, DoesTheSameAtAnyPoseAndSize) {
  const TriangleMesh ball = damaged_ball();
  const MeshRepair expected = repair_mesh(ball);
  ASSERT_TRUE(expected.after.solid());
  const double volume = signed_volume(expected.mesh);
  Random random(9);
  for (const double scale : {0.03, 0.3, 1.0, 3.0, 30.0}) {
    const Vector3 axis = random.in_box(1.0).normalized();
    const Pose X = translation({1, -2, 0.5}) * test::turned(random.uniform(0, 3), axis);
    const MeshRepair repair = repair_mesh(test::scaled(transformed(ball, X), scale));
    EXPECT_EQ(repair.holes, expected.holes);
    EXPECT_EQ(repair.turned, expected.turned);
    EXPECT_EQ(repair.dust_shells, expected.dust_shells);
    EXPECT_EQ(repair.after.triangles, expected.after.triangles);
    EXPECT_TRUE(repair.after.solid());
    // Ears of equal shape may be cut in another order, which changes nothing in a flat hole and the
    // volume by far less than this in these bent ones.
    EXPECT_NEAR(signed_volume(repair.mesh) / (scale * scale * scale), volume, 1e-6 * volume);
  }
}

TEST(MeshRepair, TakesOptionsThatSwitchItOff) {
  const RepairOptions none{.dust_area = 0.0, .crack = 0.0, .hole_area = 0.0};
  const TriangleMesh open = without_top(make_box({1, 1, 1}));
  EXPECT_EQ(repair_mesh(open, none).holes, 0);
  EXPECT_EQ(repair_mesh(damaged_ball(), none).dust_shells, 0);
}

TEST(MeshRepair, SaysWhatItDid) {
  EXPECT_EQ(repair_text(repair_mesh(without_top(make_box({1, 1, 1})))),
            "1 hole closed (16.7 % of the surface)");
  EXPECT_EQ(repair_text(repair_mesh(partly_turned(make_box({1, 1, 1}), 12))),
            "1 triangle turned that disagreed with those around");
}

TEST(MeshRepair, RefusesWhatIsNotAMesh) {
  TriangleMesh box = make_box({1, 1, 1});
  box.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(test::refusal_of([&] { (void)repair_mesh(box); }).problem(),
            "has vertices that are not finite");
  box.triangles[2][1] = 99;
  EXPECT_THROW((void)repair_mesh(box), InputError);
}

TEST(MeshRepair, CanBeCancelled) {
  const RunContext context;
  context.cancellation.request();
  EXPECT_THROW((void)repair_mesh(damaged_ball(), {}, context), Cancelled);
}

}  // namespace
}  // namespace prehend
