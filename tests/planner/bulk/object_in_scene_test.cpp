// Objects that take the place of a scene's own.
#include "planner/bulk/object_in_scene.h"

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/scene/scene_file.h"
#include "sim/shape/object_generator.h"

namespace prehend {
namespace {

Bounds world_bounds(const GraspableBody& object) {
  TriangleMesh mesh = object.mesh;
  for (Vector3& vertex : mesh.vertices) vertex = object.X_WO * vertex;
  return bounds(mesh);
}

TEST(ReplaceObject, StandsWhereTheFormerStood) {
  Random random(11);
  for (int i = 0; i < 20; ++i) {
    Scene scene = load_scene("mug_on_table");
    scene.object.X_WO = random.pose(0.5);
    const Bounds former = world_bounds(scene.object);
    TriangleMesh mesh = generate_object("bottle", 500);
    const Vector3 shift = random.in_box(2.0);
    for (Vector3& vertex : mesh.vertices) vertex += shift;
    replace_object(scene, make_graspable("bottle", mesh, Material::plastic));
    const Bounds now = world_bounds(scene.object);
    EXPECT_EQ(scene.object.name, "bottle");
    EXPECT_NEAR(now.lower.z(), former.lower.z(), 1e-12);
    EXPECT_NEAR(now.center().x(), former.center().x(), 1e-12);
    EXPECT_NEAR(now.center().y(), former.center().y(), 1e-12);
    EXPECT_TRUE(scene.primitives.empty());
  }
}

}  // namespace
}  // namespace prehend
