#include "sim/shape/weld.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "sim/shape/object_generator.h"
#include "tests/support/test_meshes.h"

namespace prehend {
namespace {

// Every triangle with its own three vertices, as STL has them.
TriangleMesh exploded(const TriangleMesh& mesh) {
  TriangleMesh soup;
  for (const Triangle& t : mesh.triangles) {
    const int first = static_cast<int>(soup.vertices.size());
    for (const int v : t) soup.vertices.push_back(mesh.vertices[static_cast<std::size_t>(v)]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

TEST(Weld, PutsAnExplodedMeshTogether) {
  const TriangleMesh mug = generate_object("mug", 5000);
  const TriangleMesh soup = exploded(mug);
  const WeldedMesh welded = weld(soup, 1e-7);
  EXPECT_EQ(welded.mesh.vertices.size(), mug.vertices.size());
  EXPECT_EQ(welded.mesh.triangles.size(), mug.triangles.size());
  EXPECT_EQ(welded.vertices_merged, static_cast<int>(soup.vertices.size() - mug.vertices.size()));
  EXPECT_EQ(welded.degenerate_removed, 0);
  EXPECT_EQ(welded.duplicates_removed, 0);
  test::expect_outward_solid(welded.mesh);
}

TEST(Weld, KeepsOrderAndTheFirstOfEachGroup) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1.0005, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                          {{0, 1, 2}, {3, 5, 4}}};
  const WeldedMesh welded = weld(mesh, 1e-3);
  ASSERT_EQ(welded.mesh.vertices.size(), 4u);
  EXPECT_EQ(welded.mesh.vertices[1], Vector3(1, 0, 0));
  EXPECT_EQ(welded.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}}));
  EXPECT_EQ(welded.vertices_merged, 2);
}

TEST(Weld, FindsPairsAcrossCellBordersAtAnyPlace) {
  // Pairs just within the tolerance, spread over many cells; each must merge, nothing else.
  const double tolerance = 1e-3;
  TriangleMesh mesh;
  for (int i = 0; i < 300; ++i) {
    const Vector3 p(0.0137 * i, 0.0071 * i, -0.0093 * i);
    const int first = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(),
                         {p, p + Vector3(0.5e-3, -0.5e-3, 0.6e-3), p + Vector3(0, 0.005, 0)});
    mesh.vertices.push_back(p + Vector3(0.005, 0, 0));
    mesh.triangles.push_back({first, first + 2, first + 3});
    mesh.triangles.push_back({first + 1, first + 3, first + 2});
  }
  const WeldedMesh welded = weld(mesh, tolerance);
  EXPECT_EQ(welded.vertices_merged, 300);
}

// By comparing each vertex with all that are kept.
std::size_t kept_one_by_one(const TriangleMesh& mesh, double tolerance) {
  std::vector<Vector3> kept;
  for (const Vector3& p : mesh.vertices) {
    const bool merged = std::any_of(kept.begin(), kept.end(), [&](const Vector3& q) {
      return (q - p).squaredNorm() <= tolerance * tolerance;
    });
    if (!merged) kept.push_back(p);
  }
  return kept.size();
}

// From far below the distance of neighbours to a large part of the mesh.
TEST(Weld, MergesTheSameVerticesWhateverTheirDistance) {
  const TriangleMesh mug = generate_object("mug", 2000);
  for (const double part : {1e-6, 1e-4, 3e-3, 0.01, 0.03, 0.1, 0.3}) {
    const double tolerance = part * bounds(mug).diagonal();
    EXPECT_EQ(static_cast<std::size_t>(weld(mug, tolerance).vertices_merged),
              mug.vertices.size() - kept_one_by_one(mug, tolerance))
        << part;
  }
}

TEST(Weld, CountsDegenerateTriangles) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0, 0}, {0, 1e-9, 0}},
                          {{0, 1, 2}, {0, 3, 1}, {0, 1, 1}, {0, 4, 2}}};
  const WeldedMesh welded = weld(mesh, 1e-6);
  EXPECT_EQ(welded.degenerate_removed, 3);  // in a line, a repeated vertex, one that welding makes
  EXPECT_EQ(welded.mesh.triangles.size(), 1u);
  EXPECT_EQ(welded.mesh.vertices.size(), 3u);
}

TEST(Weld, LeavesOutRepeatedTrianglesWhicheverWayTheyAreWound) {
  TriangleMesh box = make_box({1, 1, 1});
  box.triangles.push_back(box.triangles[3]);
  box.triangles.push_back({box.triangles[5][2], box.triangles[5][1], box.triangles[5][0]});
  const WeldedMesh welded = weld(box, 1e-6);
  EXPECT_EQ(welded.duplicates_removed, 2);
  test::expect_outward_solid(welded.mesh);
}

TEST(Weld, LeavesOutFinsButKeepsTwoSidedSheets) {
  TriangleMesh box = make_box({1, 1, 1});
  const int tip = static_cast<int>(box.vertices.size());
  box.vertices.push_back({2, 2, 2});
  const Triangle& t = box.triangles.front();
  box.triangles.push_back({t[0], t[1], tip});
  box.triangles.push_back({t[1], t[0], tip});
  const WeldedMesh welded = weld(box, 1e-6);
  EXPECT_EQ(welded.duplicates_removed, 2);
  test::expect_outward_solid(welded.mesh);

  const TriangleMesh sheet{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                           {{0, 1, 2}, {0, 2, 3}, {2, 1, 0}, {3, 2, 0}}};
  EXPECT_EQ(weld(sheet, 1e-6).mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Weld, TwiceIsTheSameAsOnce) {
  const WeldedMesh once = weld(exploded(generate_object("bowl", 2000)), 1e-3);
  const WeldedMesh twice = weld(once.mesh, 1e-3);
  EXPECT_EQ(twice.mesh.vertices, once.mesh.vertices);
  EXPECT_EQ(twice.mesh.triangles, once.mesh.triangles);
}

TEST(Degenerate, IsJudgedWithoutAScale) {
  for (const double scale : {1e-9, 1.0, 1e9}) {
    const TriangleMesh mesh = test::scaled(
        {{{0, 0, 0}, {1, 0, 0}, {0.5, 1e-5, 0}, {0.5, 1e-8, 0}}, {{0, 1, 2}, {0, 1, 3}}}, scale);
    EXPECT_FALSE(is_degenerate(mesh, 0));
    EXPECT_TRUE(is_degenerate(mesh, 1));
  }
}

}  // namespace
}  // namespace prehend
