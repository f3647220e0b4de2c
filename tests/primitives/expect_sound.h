// What every decomposition promises, whatever the mesh.
#pragma once

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "primitives/decompose.h"
#include "primitives/surface_sample.h"

namespace prehend::test {

// The fraction of the area that is explained, on points of its own.
inline double explained(const TriangleMesh& mesh, const std::vector<Primitive>& primitives,
                        double tolerance) {
  constexpr int kPoints = 4000;
  const double reach = tolerance * bounds(mesh).diagonal();
  int near = 0;
  const std::vector<SurfacePoint> points = sample_surface(mesh, kPoints, 99);
  for (const SurfacePoint& s : points) {
    near += std::any_of(primitives.begin(), primitives.end(), [&](const Primitive& p) {
      return std::abs(signed_distance(p, s.p_O)) <= reach;
    });
  }
  return static_cast<double>(near) / static_cast<double>(points.size());
}

inline void expect_sound(const Decomposition& result, const TriangleMesh& mesh,
                         const DecomposeOptions& options = {}) {
  ASSERT_FALSE(result.primitives.empty());
  ASSERT_EQ(result.primitives.size(), result.share.size());
  EXPECT_LE(result.primitives.size(), static_cast<std::size_t>(options.max_primitives));
  EXPECT_TRUE(std::is_sorted(result.share.rbegin(), result.share.rend()));
  EXPECT_NEAR(std::accumulate(result.share.begin(), result.share.end(), 0.0), result.explained,
              1e-9);
  EXPECT_LE(result.explained, 1.0 + 1e-9);
  const double diagonal = bounds(mesh).diagonal();
  for (const Primitive& primitive : result.primitives) {
    EXPECT_TRUE(primitive.X_OP.matrix().allFinite());
    EXPECT_TRUE(primitive.X_OP.linear().isUnitary(1e-9));
    EXPECT_GT(primitive.X_OP.linear().determinant(), 0.0);
    EXPECT_GT(surface_area(primitive.shape), 0.0);
    EXPECT_LT(surface_area(primitive.shape), 100.0 * diagonal * diagonal);
  }
}

}  // namespace prehend::test
