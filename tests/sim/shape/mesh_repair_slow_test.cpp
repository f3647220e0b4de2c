#include <gtest/gtest.h>

#include "sim/shape/basic_shapes.h"
#include "sim/shape/mesh_repair.h"

namespace prehend {
namespace {

// A sphere of a million triangles without a hundred of them: comparing all edges of rims with each
// other would already be seen here.
TEST(MeshRepair, RepairsAMillionTriangles) {
  TriangleMesh sphere = make_geodesic_sphere(1.0, 224);
  ASSERT_GT(sphere.triangles.size(), 1'000'000u);
  const double volume = signed_volume(sphere);
  for (std::size_t i = 0; i < 100; ++i) {
    sphere.triangles.erase(sphere.triangles.begin() + static_cast<std::ptrdiff_t>(9000 * (i + 1)));
  }
  const MeshRepair repair = repair_mesh(sphere);
  EXPECT_EQ(repair.holes, 100);
  EXPECT_TRUE(repair.after.solid());
  EXPECT_NEAR(signed_volume(repair.mesh), volume, 1e-12);
}

}  // namespace
}  // namespace prehend
