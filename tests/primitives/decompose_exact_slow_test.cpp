// Meshes of one box, sphere or cylinder come back as exactly that.
#include <algorithm>
#include <sstream>
#include <tuple>

#include <gtest/gtest.h>

#include "primitives/decompose.h"
#include "sim/shape/object_generator.h"
#include "tests/primitives/test_meshes.h"

namespace prehend {
namespace {

constexpr double kOnePercent = 0.01;

// Axis lengths that grow, so that boxes compare whichever axis comes first.
Vector3 sorted_size(const Box& box) {
  Vector3 size = box.size;
  std::sort(size.data(), size.data() + 3);
  return size;
}

struct Known {
  Primitive primitive;  // what must come back
  TriangleMesh mesh;    // in its own frame, before it is moved
  double size = 0.0;    // the smallest extent: what noise is a fraction of
};

void expect_shape(const Shape& found, const Shape& known) {
  ASSERT_EQ(shape_name(found), shape_name(known));
  if (const auto* box = std::get_if<Box>(&known)) {
    const Vector3 a = sorted_size(std::get<Box>(found));
    const Vector3 b = sorted_size(*box);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i] / b[i], 1.0, kOnePercent) << "side " << i;
  } else if (const auto* sphere = std::get_if<Sphere>(&known)) {
    EXPECT_NEAR(std::get<Sphere>(found).radius / sphere->radius, 1.0, kOnePercent);
  } else {
    const auto& cylinder = std::get<Cylinder>(known);
    EXPECT_NEAR(std::get<Cylinder>(found).radius / cylinder.radius, 1.0, kOnePercent);
    EXPECT_NEAR(std::get<Cylinder>(found).height / cylinder.height, 1.0, kOnePercent);
  }
}

// Axes of symmetry within 0.01 rad, whatever their order and sign.
void expect_axes(const Primitive& found, const Primitive& known) {
  if (std::holds_alternative<Sphere>(known.shape)) return;
  const Matrix3 dots = (found.X_OP.linear().transpose() * known.X_OP.linear()).cwiseAbs();
  const int first = std::holds_alternative<Cylinder>(known.shape) ? 2 : 0;
  for (int i = first; i < 3; ++i) {
    const double aligned = first == 2 ? dots(2, 2) : dots.col(i).maxCoeff();
    EXPECT_GT(aligned, std::cos(0.01)) << "axis " << i;
  }
}

void expect_recovered(const Known& known, double noise, double scale, std::uint64_t seed) {
  std::ostringstream what;
  what << shape_name(known.primitive.shape) << ", " << known.mesh.triangles.size()
       << " triangles, noise " << noise << ", scale " << scale << ", seed " << seed;
  SCOPED_TRACE(what.str());
  Random random(seed);
  const Pose X_WO = random.pose(3.0);
  const TriangleMesh noisy = test::disturbed(known.mesh, noise * known.size, random);
  const TriangleMesh mesh = test::scaled(transformed(noisy, X_WO), scale);
  const Decomposition result = decompose(mesh);
  ASSERT_EQ(result.primitives.size(), 1U);
  EXPECT_GT(result.explained, 0.99);
  EXPECT_NEAR(result.share.front(), result.explained, 1e-12);
  Primitive found = result.primitives.front();
  found.X_OP.translation() /= scale;
  std::visit(
      [scale](auto& s) {
        using S = std::decay_t<decltype(s)>;
        if constexpr (std::is_same_v<S, Box>) s.size /= scale;
        if constexpr (requires { s.radius; }) s.radius /= scale;
        if constexpr (std::is_same_v<S, Cylinder>) s.height /= scale;
      },
      found.shape);
  const Primitive moved{known.primitive.shape, X_WO * known.primitive.X_OP};
  expect_shape(found.shape, moved.shape);
  expect_axes(found, moved);
  const double off = (found.X_OP.translation() - moved.X_OP.translation()).norm();
  EXPECT_LT(off, kOnePercent * bounds(known.mesh).diagonal());
}

// Noise as a fraction of the size, scale to metres.
class DecomposeExact : public testing::TestWithParam<std::tuple<double, double>> {
 protected:
  void expect_all_recovered(const std::vector<Known>& all) {
    const auto [noise, scale] = GetParam();
    std::uint64_t seed = 1;
    for (const Known& known : all) expect_recovered(known, noise, scale, seed++);
  }
};

TEST_P(DecomposeExact, Box) {
  std::vector<Known> all;
  for (const Vector3& size :
       {Vector3(1.0, 1.0, 1.0), Vector3(1.0, 2.0, 3.0), Vector3(0.3, 1.0, 2.0),
        Vector3(1.0, 1.0, 4.0), Vector3(0.1, 1.0, 1.5), Vector3(1.0, 1.1, 1.2)}) {
    for (const int cells : {1, 4, 40}) {
      all.push_back({{Box{size}, Pose::Identity()}, make_box(size, cells), size.minCoeff()});
    }
  }
  expect_all_recovered(all);
}

TEST_P(DecomposeExact, Sphere) {
  std::vector<Known> all;
  const Primitive unit{Sphere{1.0}, Pose::Identity()};
  for (const int subdivisions : {2, 3, 5}) {
    all.push_back({unit, make_sphere(1.0, subdivisions), 2.0});
  }
  all.push_back({unit, test::uv_sphere(1.0, 12, 24), 2.0});
  all.push_back({unit, test::uv_sphere(1.0, 60, 90), 2.0});
  expect_all_recovered(all);
}

TEST_P(DecomposeExact, Cylinder) {
  std::vector<Known> all;
  for (const Cylinder& shape : {Cylinder{1.0, 2.0}, Cylinder{1.0, 1.0}, Cylinder{1.0, 0.3},
                                Cylinder{0.2, 2.0}, Cylinder{1.0, std::sqrt(3.0)}}) {
    for (const int sides : {24, 48, 100}) {
      for (const int rings : {1, 20}) {
        all.push_back({{shape, Pose::Identity()},
                       make_cylinder(shape.radius, shape.height, sides, rings),
                       std::min(2.0 * shape.radius, shape.height)});
      }
    }
  }
  expect_all_recovered(all);
}

INSTANTIATE_TEST_SUITE_P(NoiseAndScale, DecomposeExact,
                         testing::Combine(testing::Values(0.0, 0.005),
                                          testing::Values(1e-3, 1.0, 10.0)));

}  // namespace
}  // namespace prehend
