#include "sim/shape/files/mesh_text.h"

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/mass_properties.h"
#include "sim/shape/mesh_checks.h"

namespace prehend {
namespace {

// Readers have single precision.
constexpr double kSingle = 1e-6;

TEST(MeshText, ReadsBackAsTheSameSolid) {
  const Pose X = translation({0.1, -0.2, 0.3}) * Eigen::AngleAxisd(0.7, Vector3::UnitX());
  const TriangleMesh mesh = transformed(make_cylinder(0.05, 0.2, 17, 3), X);
  const MassProperties wanted = mass_properties(mesh);
  for (const char* name : {"a.obj", "a.STL", "a.ply", "a.off"}) {
    ASSERT_TRUE(is_written_mesh_name(name));
    const LoadedMesh read = read_mesh(mesh_text(mesh, name), name);
    EXPECT_EQ(read.mesh.vertices.size(), mesh.vertices.size()) << name;
    EXPECT_EQ(read.mesh.triangles.size(), mesh.triangles.size()) << name;
    EXPECT_TRUE(check_mesh(read.mesh).solid()) << name;
    EXPECT_NEAR(mass_properties(read.mesh).volume / wanted.volume, 1.0, 10.0 * kSingle) << name;
    EXPECT_LT((bounds(read.mesh).lower - bounds(mesh).lower).norm(), kSingle) << name;
    EXPECT_LT((bounds(read.mesh).upper - bounds(mesh).upper).norm(), kSingle) << name;
  }
}

TEST(MeshText, OtherFormatsAreRefused) {
  EXPECT_FALSE(is_written_mesh_name("a.dae"));
  EXPECT_THROW((void)mesh_text(make_box({1.0, 1.0, 1.0}), "a.dae"), InputError);
}

}  // namespace
}  // namespace prehend
