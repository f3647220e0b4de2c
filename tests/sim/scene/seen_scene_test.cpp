// Scenes of what a depth camera saw.
#include "sim/scene/seen_scene.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/json/json_field.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_text.h"
#include "sim/scene/seen_surface.h"
#include "tests/support/depth_images.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

namespace fs = std::filesystem;
using test::refusal_of;

const std::vector<test::StandingBox> kBoxes = {{{0.06, 0.05, 0.10}, 0.0, 0.0},
                                               {{0.04, 0.04, 0.05}, 0.14, 0.02}};
const DepthCamera kCamera =
    test::camera_at({0.45, -0.35, 0.45}, {0.05, 0.0, 0.03}, test::kSmallImage);

fs::path written_views(const std::string& name) {
  const fs::path folder = fs::path(testing::TempDir()) / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  test::write_png(folder / "a.png", test::view_of(kBoxes, kCamera));
  std::ofstream(folder / "a.json") << test::camera_json(kCamera);
  std::ofstream(folder / "views.json") << R"({"depth": "a.png", "camera": "a.json"})";
  return folder;
}

TEST(SeenScene, OneThingIsTheObjectAndAllElseIsInTheWay) {
  const fs::path folder = written_views("seen_scene");
  const Scene scene = load_scene(folder / "views.json", {.hand = "franka_hand"});
  EXPECT_EQ(scene.object.name, "object1");
  ASSERT_EQ(scene.obstacles.size(), 2U);
  EXPECT_EQ(scene.obstacles[0].name, "object2");
  EXPECT_EQ(scene.obstacles[1].name, "support");
  ASSERT_TRUE(scene.object.completion);
  const Completion& completion = *scene.object.completion;
  EXPECT_EQ(completion.seen.size(), scene.object.mesh.triangles.size());
  EXPECT_GT(std::count(completion.seen.begin(), completion.seen.end(), 1), 0);
  EXPECT_GT(std::count(completion.seen.begin(), completion.seen.end(), 0), 0);
  EXPECT_NO_THROW(compile(scene));
  const std::string& last = scene.notes.back();
  EXPECT_FALSE(scene.notes.empty());
  EXPECT_NE(std::find_if(scene.notes.begin(), scene.notes.end(),
                         [](const std::string& note) {
                           return note.starts_with("the support is a plane at z = ");
                         }),
            scene.notes.end())
      << last;
}

TEST(SeenScene, TheSupportIsBelowTheObject) {
  const fs::path folder = written_views("seen_support");
  const Scene scene = load_scene(folder / "views.json");
  const StaticBody& support = scene.obstacles.back();
  double top = -1.0;
  for (const Vector3& v : support.mesh.vertices) top = std::max(top, (support.X_WB * v).z());
  double low = 1.0;
  for (const Vector3& v : scene.object.mesh.vertices) {
    low = std::min(low, (scene.object.X_WO * v).z());
  }
  EXPECT_GE(low - top, 0.0001);
  EXPECT_NEAR(top, 0.0, 0.006);  // two cells of the grid
}

TEST(SeenScene, ContactsAreOnWhatWasSeenOrCompleted) {
  const fs::path folder = written_views("seen_contacts");
  const CompiledScene scene = compile(load_scene(folder / "views.json"));
  const Pose X_OW = scene.scene.object.X_WO.inverse();
  // The top is seen, the side away from the camera is not.
  EXPECT_EQ(is_seen_at(scene, X_OW * Vector3(0.0, 0.0, 0.10)), true);
  const Bounds box = bounds(scene.scene.object.mesh);
  const Vector3 behind(box.lower.x(), 0.0, 0.0);
  EXPECT_EQ(is_seen_at(scene, behind), false);
  EXPECT_EQ(is_seen_at(compile(load_scene("mug")), Vector3::Zero()), std::nullopt);
}

TEST(SeenScene, EachThingCanBeChosen) {
  const fs::path folder = written_views("seen_choice");
  EXPECT_EQ(scene_objects(folder / "views.json"), (std::vector<std::string>{"object1", "object2"}));
  const std::vector<Scene> all = load_each_scene(folder / "a.png");
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[1].object.name, "object2");
  EXPECT_EQ(all[1].obstacles.front().name, "object1");
  for (const char* asked : {"2", "object2"}) {
    const Scene scene =
        load_scene(folder / "views.json", {.hand = "", .choice = {.object = asked}});
    EXPECT_EQ(scene.object.name, "object2");
    EXPECT_EQ(scene.object.mesh.vertices, all[1].object.mesh.vertices);
  }
  EXPECT_EQ(refusal_of([&] {
              load_scene(folder / "views.json", {.hand = "", .choice = {.object = "3"}});
            }).problem(),
            "no such thing was seen; there is object1, object2");
}

TEST(SeenScene, ASceneFileNamesViewsAndANumber) {
  const fs::path folder = written_views("seen_in_scene");
  std::ofstream(folder / "scene.json") << R"({"hand": "franka_hand",
    "object": {"views": "views.json", "number": 2, "mass": 0.5, "material": "wood"},
    "obstacles": [{"name": "wall", "geometry": [{"shape": "box", "size": [0.1, 1, 1]}],
                   "pose": {"position": [-0.5, 0, 0.5]}}]})";
  const Scene scene = load_scene(folder / "scene.json");
  EXPECT_EQ(scene.object.name, "object2");
  EXPECT_EQ(scene.object.mass, 0.5);
  EXPECT_EQ(scene.object.material, Material::wood);
  ASSERT_EQ(scene.obstacles.size(), 3U);
  EXPECT_EQ(scene.obstacles[2].name, "wall");
  // Written, it has the shapes themselves.
  const Scene again = read_scene(JsonFile(folder / "again.json", scene_text(scene)));
  EXPECT_EQ(again.object.mesh.triangles.size(), scene.object.mesh.triangles.size());
  EXPECT_EQ(again.obstacles.size(), 3U);
  std::ofstream(folder / "none.json") << R"({"object": {"views": "views.json", "number": 3}})";
  EXPECT_EQ(refusal_of([&] { load_scene(folder / "none.json"); }).field(), "object.number");
  std::ofstream(folder / "both.json") << R"({"object": {"views": "views.json", "mesh": "a.obj"}})";
  EXPECT_EQ(refusal_of([&] { load_scene(folder / "both.json"); }).field(), "object.mesh");
}

TEST(SeenScene, WithoutAPlaneNothingIsBelow) {
  const fs::path folder = written_views("seen_no_plane");
  std::ofstream(folder / "views.json")
      << R"({"depth": "a.png", "camera": "a.json", "plane": false})";
  const ViewsInput input = load_views(folder / "views.json");
  EXPECT_FALSE(input.steps.find_plane);
}

}  // namespace
}  // namespace prehend
