#include "sim/scene/scene_text.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/scene/object_mass.h"
#include "sim/scene/scene_file.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

std::filesystem::path written(const std::string& text) {
  std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
  std::replace(name.begin(), name.end(), '/', '_');
  const std::filesystem::path file = testing::TempDir() + "/scene_text_" + name + ".json";
  std::ofstream(file) << text;
  return file;
}

Scene read_back(const Scene& scene) { return load_scene(written(scene_text(scene))); }

template <typename Body>
void expect_same_body(const Body& a, const Pose& X_WA, const Body& b, const Pose& X_WB) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.material, b.material);
  EXPECT_EQ(a.mesh.vertices, b.mesh.vertices);
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
  EXPECT_TRUE(X_WA.isApprox(X_WB, 1e-14));
}

void expect_same_scene(const Scene& a, const Scene& b) {
  EXPECT_EQ(a.name, b.name);
  expect_same_body(a.object, a.object.X_WO, b.object, b.object.X_WO);
  EXPECT_EQ(a.object.mass, b.object.mass);
  EXPECT_EQ(a.object.center_of_mass, b.object.center_of_mass);
  EXPECT_EQ(a.object.restitution, b.object.restitution);
  ASSERT_EQ(a.obstacles.size(), b.obstacles.size());
  for (std::size_t i = 0; i < a.obstacles.size(); ++i) {
    expect_same_body(a.obstacles[i], a.obstacles[i].X_WB, b.obstacles[i], b.obstacles[i].X_WB);
    EXPECT_EQ(a.obstacles[i].restitution, b.obstacles[i].restitution);
  }
  for (const Material one : kAll<Material>) {
    EXPECT_EQ(a.compliant_depths.of(one), b.compliant_depths.of(one));
    for (const Material other : kAll<Material>) {
      EXPECT_EQ(a.friction.between(one, other), b.friction.between(one, other));
      EXPECT_EQ(a.kinetic_friction.between(one, other), b.kinetic_friction.between(one, other));
    }
  }
  EXPECT_EQ(a.hand.name, b.hand.name);
  ASSERT_EQ(a.carrier.has_value(), b.carrier.has_value());
  if (!a.carrier) return;
  EXPECT_TRUE(a.carrier->X_WB.isApprox(b.carrier->X_WB, 1e-14));
  EXPECT_EQ(a.carrier->start, b.carrier->start);
  for (std::size_t r = 0; r < a.carrier->platform.robots.size(); ++r) {
    const Robot& robot_a = a.carrier->platform.robots[r].robot;
    const Robot& robot_b = b.carrier->platform.robots[r].robot;
    ASSERT_EQ(robot_a.dofs.size(), robot_b.dofs.size());
    for (std::size_t d = 0; d < robot_a.dofs.size(); ++d) {
      EXPECT_EQ(robot_a.dofs[d].lower, robot_b.dofs[d].lower);
      EXPECT_EQ(robot_a.dofs[d].upper, robot_b.dofs[d].upper);
    }
  }
}

class LibraryScene : public testing::TestWithParam<const char*> {};

TEST_P(LibraryScene, ReadsBackAsItWas) {
  const std::filesystem::path file = std::filesystem::path(PREHEND_SOURCE_DIR) / "benchmarks" /
                                     "scenes" / (std::string(GetParam()) + ".json");
  const Scene scene = load_scene(file);
  expect_same_scene(scene, read_back(scene));
}

INSTANTIATE_TEST_SUITE_P(All, LibraryScene,
                         testing::Values("mug", "mug_on_table", "cluttered_table", "shelf",
                                         "living_room"),
                         [](const auto& name) { return std::string(name.param); });

TEST(SceneText, KeepsWhatAProgramChanged) {
  Scene scene = load_scene(std::filesystem::path(PREHEND_SOURCE_DIR) / "benchmarks" / "scenes" /
                           "living_room.json");
  scene.name = "changed";
  scene.obstacles.erase(scene.obstacles.begin());
  StaticBody board{
      "board", make_box({0.3, 0.2, 0.01}, 2), translation({1.0, 2.0, 0.3}), Material::metal, {}};
  scene.obstacles.push_back(board);
  scene.friction.set(Material::metal, Material::glass, 0.123);
  scene.kinetic_friction.set(Material::metal, Material::glass, 0.1);
  scene.kinetic_friction.set(Material::wood, Material::wood, 0.25);
  scene.object.restitution = 0.6;
  scene.obstacles[0].restitution = 0.4;
  scene.compliant_depths.set(Material::wood, 2e-4);
  scene.carrier->start[0] += 0.1;
  scene.primitives = {{Cylinder{0.04, 0.1}, translation({0.0, 0.0, 0.05})}};
  const Scene again = read_back(scene);
  expect_same_scene(scene, again);
  ASSERT_EQ(again.primitives.size(), 1U);
  EXPECT_EQ(std::get<Cylinder>(again.primitives[0].shape).radius, 0.04);
}

TEST(SceneText, KeepsPartsOfTheMass) {
  Scene scene =
      load_scene(std::filesystem::path(PREHEND_SOURCE_DIR) / "benchmarks" / "scenes" / "mug.json");
  const MassPart handle{
      .name = "handle", .where = BeyondPlane{{0.05, 0, 0}, {1, 0, 0}}, .density = 900.0};
  const MassPart foot{.where = InsideShape{{Cylinder{0.03, 0.01}, Pose::Identity()}}, .mass = 0.2};
  const MassPart spoon{.where = AtPoint{{0, 0, 0.1}}, .mass = 0.03};
  for (const StatedMass& stated :
       {StatedMass{.mass = 0.5, .density = 2000.0, .parts = {handle, foot, spoon}},
        StatedMass{.mass = 0.5, .parts = {foot, spoon}},
        StatedMass{.density = 2000.0, .parts = {handle}},
        StatedMass{.parts = {{.where = MeshComponent{0}, .density = 2000.0}}}}) {
    state_mass(scene.object, stated);
    const Scene again = read_back(scene);
    EXPECT_EQ(again.object.mass_basis, MassBasis::parts);
    EXPECT_EQ(again.object.mass, scene.object.mass);
    EXPECT_LT((again.object.center_of_mass - scene.object.center_of_mass).norm(), 1e-14);
    EXPECT_LT((again.object.inertia - scene.object.inertia).norm(), 1e-14);
    EXPECT_EQ(again.object.stated_mass->parts.size(), stated.parts.size());
    EXPECT_EQ(again.object.stated_mass->parts[0].name, stated.parts[0].name);
  }
}

// A centre of mass that was not stated does not become one by being written.
TEST(SceneText, TellsAStatedCentreOfMassFromThatOfUniformDensity) {
  Scene scene =
      load_scene(std::filesystem::path(PREHEND_SOURCE_DIR) / "benchmarks" / "scenes" / "mug.json");
  EXPECT_EQ(read_back(scene).object.mass_basis, MassBasis::uniform);
  scene.object.center_of_mass.z() += 0.01;
  EXPECT_EQ(read_back(scene).object.mass_basis, MassBasis::center);
  EXPECT_EQ(read_back(scene).object.center_of_mass, scene.object.center_of_mass);
}

TEST(SceneText, SaysNothingOfWhatASceneDoesNotHave) {
  const std::string text = scene_text(
      load_scene(std::filesystem::path(PREHEND_SOURCE_DIR) / "benchmarks" / "scenes" / "mug.json"));
  EXPECT_EQ(text.find("kinetic"), std::string::npos);
  EXPECT_EQ(text.find("restitution"), std::string::npos);
}

TEST(SceneText, KeepsPrimitivesOfEveryShape) {
  Scene scene =
      load_scene(std::filesystem::path(PREHEND_SOURCE_DIR) / "benchmarks" / "scenes" / "mug.json");
  const Vector3 x = Vector3::UnitX();
  const Vector3 z = Vector3::UnitZ();
  scene.primitives = {{Box{{0.1, 0.2, 0.3}}, Pose::Identity()},
                      {Sphere{0.1}, Pose::Identity()},
                      {Cylinder{0.04, 0.1}, Pose::Identity()},
                      {Cone{0.04, 0.0, 0.1}, translation({0.0, 0.0, 0.05})},
                      {Rim{{{x, z, x}, {2.0 * x, z, x}}, 0.003, 0.02, true}, Pose::Identity()},
                      {Bar{{x, 2.0 * x, 3.0 * z}, 0.01, false}, Pose::Identity()}};
  const Scene again = read_back(scene);
  ASSERT_EQ(again.primitives.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(again.primitives[i].shape.index(), scene.primitives[i].shape.index());
    for (const Vector3& p : {Vector3(0.01, 0.02, 0.03), Vector3(1.0, 0.5, 0.2)}) {
      EXPECT_NEAR(signed_distance(again.primitives[i], p), signed_distance(scene.primitives[i], p),
                  1e-12);
    }
  }
  const Rim& rim = std::get<Rim>(again.primitives[4].shape);
  EXPECT_EQ(rim.points[1].into, z);
  EXPECT_EQ(rim.points[1].across, x);
  EXPECT_EQ(rim.depth, 0.02);
  EXPECT_TRUE(rim.closed);
}

TEST(SceneText, AnotherHandOnTheArmStaysThere) {
  const Scene scene = load_scene(
      std::filesystem::path(PREHEND_SOURCE_DIR) / "benchmarks" / "scenes" / "mug_on_table.json",
      {.hand = "franka_hand"});
  const Scene again = read_back(scene);
  EXPECT_EQ(again.hand.name, "franka_hand");
  expect_same_scene(scene, again);
}

TEST(SceneText, AHandThatNoFileNamesIsRefused) {
  Scene scene =
      load_scene(std::filesystem::path(PREHEND_SOURCE_DIR) / "benchmarks" / "scenes" / "mug.json");
  scene.hand_source.clear();
  EXPECT_THROW((void)scene_text(scene), InputError);
}

}  // namespace
}  // namespace prehend
