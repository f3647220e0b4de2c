#include "sim/scene/make_scene.h"

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/robot/files/robot_file.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_library.h"
#include "sim/scene/scene_text.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/object_generator.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

Scene boxed_scene(const std::string& hand = "parallel_jaw") {
  return make_scene(make_graspable("box", make_box({0.03, 0.04, 0.05}), Material::wood), hand);
}

template <typename Call>
std::string complaint(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// The scene of the library, word for word.
TEST(MakeScene, SaysTheSameAsASceneFile) {
  const Scene read = load_scene(find_scene("mug_on_table"));
  GraspableBody mug =
      make_graspable("mug", generate_object("mug", 5000), read.object.material, read.object.mass);
  mug.X_WO = read.object.X_WO;
  mug.source = read.object.source;
  Scene made = make_scene(mug, "barrett");
  made.name = read.name;
  for (const StaticBody& body : read.obstacles) {
    add_obstacle(made, body.name, body.mesh, body.X_WB, body.material);
    made.obstacles.back().source = body.source;
  }
  mount(made, "puma560_barrett", read.carrier->X_WB);
  EXPECT_EQ(scene_text(made), scene_text(read));
}

TEST(MakeScene, AHandIsMountedInThePlaceOfThePlatformsOwn) {
  Scene scene = boxed_scene();
  mount(scene, "puma560_barrett", translation({1.0, 0.0, 0.0}), "franka_hand");
  scene.object.X_WO = translation({1.6, 0.0, 0.5});
  EXPECT_EQ(scene.hand.name, find_robot("franka_hand").name);
  const CompiledScene ready = compile(scene);
  EXPECT_EQ(ready.links.size(), scene.hand.links.size());
  ASSERT_TRUE(ready.arm.has_value());
}

TEST(MakeScene, MistakesAreRefused) {
  Scene scene = boxed_scene();
  EXPECT_NE(complaint([] { boxed_scene("nobody"); }).find("parallel_jaw"), std::string::npos);
  add_obstacle(scene, "wall", make_box({0.1, 0.1, 0.1}), translation({0.3, 0.0, 0.0}));
  EXPECT_NE(complaint([&] {
              add_obstacle(scene, "wall", make_box({1, 1, 1}));
            }).find("wall"),
            std::string::npos);
  EXPECT_NE(complaint([&] { add_obstacle(scene, "air", {}); }).find("air"), std::string::npos);
  EXPECT_NE(complaint([&] { mount(scene, "puma560"); }), "");       // no hand
  EXPECT_NE(complaint([&] { mount(scene, "parallel_jaw"); }), "");  // nothing carries it
  EXPECT_FALSE(scene.carrier.has_value());
  EXPECT_EQ(scene.obstacles.size(), 1U);
}

TEST(MakeScene, AMistakeNamesSceneFieldAndValue) {
  Scene scene = boxed_scene();
  const InputError no_mesh = test::refusal_of([&] { add_obstacle(scene, "air", {}); });
  EXPECT_EQ(no_mesh.file(), scene.name);
  EXPECT_EQ(no_mesh.field(), "obstacles");
  EXPECT_EQ(no_mesh.value(), "air");
  const InputError no_arm = test::refusal_of([&] { mount(scene, "parallel_jaw"); });
  EXPECT_EQ(no_arm.field(), "robot");
  EXPECT_EQ(no_arm.problem(), "nothing carries the hand");
  EXPECT_EQ(no_arm.value(), "parallel_jaw");
  const InputError no_hand = test::refusal_of([&] { mount(scene, "puma560"); });
  EXPECT_EQ(no_hand.field(), "robot");
  EXPECT_EQ(no_hand.problem(), find_robot("puma560").name + ": robots: none is a hand");
}

TEST(UnitHint, NamesAUnitThatWouldBePlausible) {
  GraspableBody object = make_graspable("pear", make_box({1e-4, 5e-5, 5e-5}), Material::plastic);
  EXPECT_EQ(unit_hint(object), "");
  object.source = MeshFileSource{"/pear.obj", "mm"};
  EXPECT_EQ(unit_hint(object), " (100 mm if its unit were m)");
  object.mesh = make_box({90.0, 20.0, 20.0});
  object.source = MeshFileSource{"/pear.obj", "m"};
  EXPECT_EQ(unit_hint(object), " (900 mm if its unit were cm)");
  object.mesh = make_box({0.09, 0.02, 0.02});
  EXPECT_EQ(unit_hint(object), "");
}

TEST(Compile, RefusesWhatContactsCannotResolve) {
  const auto compiled = [](double size) {
    return compile(make_scene(
        make_graspable("pear", make_box({size, size, size}), Material::plastic), "barrett"));
  };
  EXPECT_NO_THROW(compiled(0.0021));
  EXPECT_EQ(test::refusal_of([&] { compiled(0.0019); }).field(), "object");
}

}  // namespace
}  // namespace prehend
