// The bodies of a picture.
#include "planner/show/grasp_bodies.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace prehend {
namespace {

// A part of a surface is drawn as a skin with its area, just outside, whose border cuts triangles.
TEST(GraspBodies, PartsOfOtherMaterialsAreSkins) {
  const Vector3 size(0.03, 0.04, 0.15);
  Scene scene = test::scene_with(find_robot("parallel_jaw"), make_box(size));
  SurfaceRegion upper;
  upper.beyond = BeyondPlane{{0.0, 0.0, 0.03}, Vector3::UnitZ()};
  scene.object.X_WO = translation({1.0, 0.0, 0.0});
  PosedGrasp grasp;
  grasp.joints = joint_values(scene.hand, initial_dofs(scene.hand));
  EXPECT_TRUE(grasp_bodies(compile(scene), grasp).surfaces.empty());
  scene.object.surfaces = {{upper, {Material::rubber}}};
  const CompiledScene compiled = compile(scene);
  const GraspBodies bodies = grasp_bodies(compiled, grasp);
  ASSERT_EQ(bodies.surfaces.size(), 1U);
  const DrawnBody& skin = bodies.surfaces[0];
  EXPECT_EQ(skin.name, "rubber");
  EXPECT_EQ(skin.X_WB.translation(), scene.object.X_WO.translation());
  const double height = 0.5 * size.z() - 0.03;
  const double area = size.x() * size.y() + 2.0 * height * (size.x() + size.y());
  EXPECT_NEAR(surface_area(*skin.mesh), area, 0.05 * area);
  const Bounds around = bounds(*skin.mesh);
  EXPECT_GT(around.upper.z(), 0.5 * size.z());
  // A piece is a 40th of the radius.
  EXPECT_NEAR(around.lower.z(), 0.03, 0.003);
}

}  // namespace
}  // namespace prehend
