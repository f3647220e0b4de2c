// Surfaces of grids, compared with the shapes that the values are distances from.
#include "sim/shape/cloud/surface_net.h"

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/cloud/distance_transform.h"
#include "sim/shape/mesh_checks.h"

namespace prehend {
namespace {

template <typename Distance>
DistanceGrid grid_of(const std::array<int, 3>& size, const Distance& distance) {
  DistanceGrid grid{Vector3::Constant(-0.05), 0.004, size, {}};
  for (int z = 0; z < size[2]; ++z) {
    for (int y = 0; y < size[1]; ++y) {
      for (int x = 0; x < size[0]; ++x) {
        grid.value.push_back(static_cast<float>(distance(grid.corner(x, y, z))));
      }
    }
  }
  return grid;
}

TEST(SurfaceNet, OfABall) {
  DistanceGrid grid = grid_of({27, 26, 28}, [](const Vector3& p) { return p.norm() - 0.03; });
  make_well_composed(grid);
  const TriangleMesh mesh = surface_net(grid);
  EXPECT_TRUE(check_mesh(mesh).solid());
  EXPECT_NEAR(signed_volume(mesh) / (4.0 / 3.0 * 3.14159265 * 0.03 * 0.03 * 0.03), 1.0, 0.03);
  for (const Vector3& p : mesh.vertices) EXPECT_NEAR(p.norm(), 0.03, 4e-4);
}

TEST(SurfaceNet, IsClosedForAnyValues) {
  Random random(3);
  for (int round = 0; round < 20; ++round) {
    DistanceGrid grid =
        grid_of({14, 12, 13}, [&](const Vector3&) { return random.uniform(-1.0, 1.0); });
    make_well_composed(grid);
    const TriangleMesh mesh = surface_net(grid);
    const MeshChecks checks = check_mesh(mesh);
    EXPECT_EQ(checks.boundary_edges, 0);
    EXPECT_EQ(checks.nonmanifold_edges, 0);
    EXPECT_EQ(checks.misoriented_edges, 0);
    EXPECT_EQ(checks.degenerate_triangles, 0);
    EXPECT_FALSE(checks.inward);
  }
}

TEST(DistanceTransform, IsTheLeastOfAllDistances) {
  Random random(8);
  const std::array<int, 3> size = {9, 7, 6};
  for (int round = 0; round < 10; ++round) {
    std::vector<char> from(9 * 7 * 6);
    for (char& is : from) is = random.uniform() < 0.03 ? 1 : 0;
    const std::vector<float> found = distance_transform(from, size, 100.0F);
    const auto place = [&](std::size_t i) {
      return Vector3(static_cast<double>(i % 9), static_cast<double>(i / 9 % 7),
                     static_cast<double>(i / 63));
    };
    for (std::size_t i = 0; i < from.size(); ++i) {
      double least = 100.0;
      for (std::size_t j = 0; j < from.size(); ++j) {
        if (from[j] != 0) least = std::min(least, (place(i) - place(j)).norm());
      }
      EXPECT_NEAR(static_cast<double>(found[i]), least, 1e-4);
    }
  }
}

}  // namespace
}  // namespace prehend
