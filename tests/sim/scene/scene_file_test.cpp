#include "sim/scene/scene_file.h"

#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

// A file of the running test's own: tests run side by side.
std::filesystem::path write(const std::string& text) {
  std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
  std::replace(name.begin(), name.end(), '/', '_');
  const std::filesystem::path file = testing::TempDir() + "/scene_" + name + ".json";
  std::ofstream(file) << text;
  return file;
}

const char* const kBall =
    R"("object": {"name": "ball", "generate": "ball", "triangles": 300, "material": "wood",
        "mass": 0.2, "pose": {"position": [0, 0, 0.5]}})";

TEST(SceneFile, ReadsABodyWithItsPoseMaterialAndMass) {
  const Scene scene = load_scene(write(std::string("{") + kBall + "}"));
  EXPECT_EQ(scene.object.name, "ball");
  EXPECT_EQ(scene.object.material, Material::wood);
  EXPECT_DOUBLE_EQ(scene.object.mass, 0.2);
  EXPECT_DOUBLE_EQ(scene.object.X_WO.translation().z(), 0.5);
  EXPECT_EQ(scene.hand.name, kDefaultHand);
}

TEST(SceneFile, InertiaOfACubeIsASixthOfMassTimesSideSquared) {
  const Scene scene = load_scene(write(R"({"object": {"geometry":
      [{"shape": "box", "size": [0.1, 0.1, 0.1]}], "mass": 6}})"));
  EXPECT_NEAR(scene.object.inertia(0, 0), 0.01, 1e-12);
  EXPECT_NEAR(scene.object.center_of_mass.norm(), 0.0, 1e-12);
}

TEST(SceneFile, FrictionOfAPairIsOverridden) {
  const Scene scene =
      load_scene(write(std::string("{") + kBall +
                       R"(, "friction": [{"between": ["wood", "plastic"], "static": 0.7}]})"));
  EXPECT_DOUBLE_EQ(scene.friction.between(Material::plastic, Material::wood), 0.7);
  EXPECT_DOUBLE_EQ(scene.friction.between(Material::plastic, Material::plastic), 0.3);
}

TEST(SceneFile, KineticFrictionIsReadBesideTheStatic) {
  const Scene scene = load_scene(write(std::string("{") + kBall + R"(, "friction": [
      {"between": ["wood", "plastic"], "static": 0.7, "kinetic": 0.5},
      {"between": ["glass", "glass"], "kinetic": 0.1},
      {"between": ["wood", "wood"], "static": 0.6, "kinetic": 0.2},
      {"between": ["wood", "wood"], "static": 0.5}]})"));
  EXPECT_EQ(scene.kinetic_friction.between(Material::plastic, Material::wood), 0.5);
  EXPECT_EQ(scene.kinetic_friction.between(Material::glass, Material::glass), 0.1);
  EXPECT_FALSE(scene.kinetic_friction.between(Material::wood, Material::wood));
  EXPECT_FALSE(scene.kinetic_friction.empty());
  EXPECT_EQ(scene.friction.between(Material::glass, Material::glass), 0.2);
  const FrictionTable sliding = sliding_friction(scene.friction, scene.kinetic_friction);
  EXPECT_EQ(sliding.between(Material::wood, Material::plastic), 0.5);
  EXPECT_EQ(sliding.between(Material::wood, Material::wood), 0.5);
}

TEST(SceneFile, BodiesMayBounce) {
  const Scene scene = load_scene(write(R"({"object": {"generate": "ball", "triangles": 300,
      "restitution": 0.8}, "obstacles": [
      {"name": "table", "restitution": 0.3, "geometry": [{"shape": "box", "size": [1, 1, 0.1]}]},
      {"name": "wall", "geometry": [{"shape": "box", "size": [1, 1, 0.1]}]}]})"));
  EXPECT_EQ(scene.object.restitution, 0.8);
  EXPECT_EQ(scene.obstacles[0].restitution, 0.3);
  EXPECT_EQ(scene.obstacles[1].restitution, 0.0);
}

TEST(SceneFile, PrimitivesAndObstaclesAreRead) {
  const Scene scene = load_scene(write(R"({"object": {"generate": "ball", "triangles": 300,
      "primitives": [{"shape": "sphere", "radius": 0.03, "pose": {"position": [0, 0, 0.03]}}]},
      "obstacles": [{"name": "table", "geometry": [{"shape": "box", "size": [1, 1, 0.1]}]}]})"));
  ASSERT_EQ(scene.primitives.size(), 1U);
  EXPECT_DOUBLE_EQ(std::get<Sphere>(scene.primitives[0].shape).radius, 0.03);
  ASSERT_EQ(scene.obstacles.size(), 1U);
  EXPECT_EQ(scene.obstacles[0].material, Material::wood);
}

struct BadScene {
  const char* name;
  const char* text;
  const char* complaint;
};

void PrintTo(const BadScene& bad, std::ostream* stream) { *stream << bad.name; }

class BadSceneFile : public testing::TestWithParam<BadScene> {};

TEST_P(BadSceneFile, IsRefusedInOneLineThatNamesFileFieldAndValue) {
  const std::filesystem::path file = write(GetParam().text);
  try {
    (void)load_scene(file);
    FAIL() << "no error";
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_EQ(what.find(file.string()), 0U) << what;
    EXPECT_NE(what.find(GetParam().complaint), std::string::npos) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Corpus, BadSceneFile,
    testing::Values(
        BadScene{"NotJson", "{", "line 1"}, BadScene{"NoObject", "{}", "object"},
        BadScene{"TwoMeshes", R"({"object": {"generate": "mug", "mesh": "a.obj"}})", "exactly one"},
        BadScene{"UnknownField", R"({"object": {"generate": "mug", "colour": 1}})", "colour"},
        BadScene{"UnknownMaterial", R"({"object": {"generate": "mug", "material": "jelly"}})",
                 "jelly"},
        BadScene{"NegativeMass", R"({"object": {"generate": "mug", "mass": -1}})", "object.mass"},
        BadScene{"UnknownObject", R"({"object": {"generate": "teacup"}})", "teacup"},
        BadScene{"NegativeFriction", R"({"object": {"generate": "mug"},
            "friction": [{"between": ["wood", "wood"], "static": -0.1}]})",
                 "-0.1"},
        BadScene{"NegativeKineticFriction", R"({"object": {"generate": "mug"},
            "friction": [{"between": ["wood", "wood"], "static": 0.1, "kinetic": -0.1}]})",
                 "friction[0].kinetic: must be from 0 to 1e6 between wood and wood (-0.1"},
        BadScene{"KineticAboveStatic", R"({"object": {"generate": "mug"},
            "friction": [{"between": ["wood", "wood"], "static": 0.1, "kinetic": 0.3}]})",
                 "friction[0].kinetic: must be at most the static coefficient of the pair (0.3)"},
        BadScene{"NoCoefficient", R"({"object": {"generate": "mug"},
            "friction": [{"between": ["wood", "wood"]}]})",
                 "friction[0].static: missing field"},
        BadScene{"BouncesHigher", R"({"object": {"generate": "mug", "restitution": 1.5}})",
                 "object.restitution: must be from 0 to 1 (1.5)"},
        BadScene{"NegativeRestitution", R"({"object": {"generate": "mug"}, "obstacles": [
            {"name": "mat", "generate": "box", "restitution": -0.1}]})",
                 "obstacles[0].restitution: must be from 0 to 1 (-0.1)"},
        BadScene{"ThreeMaterials", R"({"object": {"generate": "mug"},
            "friction": [{"between": ["wood", "wood", "wood"], "static": 0.1}]})",
                 "two materials"},
        BadScene{"NotARotation", R"({"object": {"generate": "mug",
            "pose": {"quaternion_wxyz": [0, 0, 0, 0]}}})",
                 "quaternion_wxyz"},
        BadScene{"EmptyBox", R"({"object": {"generate": "mug",
            "primitives": [{"shape": "box", "size": [1, 0, 1]}]}})",
                 "positive"},
        BadScene{"SphereWithHeight", R"({"object": {"generate": "mug",
            "primitives": [{"shape": "sphere", "radius": 1, "height": 2}]}})",
                 "no height"},
        BadScene{"ConeWithoutRadius", R"({"object": {"generate": "mug",
            "primitives": [{"shape": "cone", "radius_low": 0, "radius_high": 0, "height": 2}]}})",
                 "positive"},
        BadScene{"BarOfOnePoint", R"({"object": {"generate": "mug",
            "primitives": [{"shape": "bar", "points": [[0, 0, 1]], "width": 1, "closed": true}]}})",
                 "two points"},
        BadScene{"RimAlongItsWall", R"({"object": {"generate": "mug",
            "primitives": [{"shape": "rim", "points": [[0, 0, 1], [1, 0, 1]], "width": 1,
              "depth": 1, "closed": false, "into": [[0, 0, -1], [0, 0, -1]],
              "across": [[0, 1, 0], [0, 0, 1]]}]}})",
                 "right angle"}),
    [](const auto& bad) { return std::string(bad.param.name); });

TEST(SceneFile, AMistakeNamesItsFieldAndValue) {
  const auto refused = [](const char* text) {
    return test::refusal_of([&] { (void)load_scene(write(text)); });
  };
  const InputError object = refused(R"({"object": {"generate": "teacup"}})");
  EXPECT_EQ(object.field(), "object.generate");
  EXPECT_EQ(object.value(), "teacup");
  const InputError triangles = refused(R"({"object": {"generate": "mug", "triangles": 0}})");
  EXPECT_EQ(triangles.field(), "object.triangles");
  EXPECT_EQ(triangles.value(), "0");
  const InputError material = refused(R"({"object": {"generate": "mug"},
      "friction": [{"between": ["wood", "jelly"], "static": 0.1}]})");
  EXPECT_EQ(material.field(), "friction[0].between[1]");
  EXPECT_EQ(material.value(), "jelly");
  const InputError unit = refused(R"({"object": {"mesh": "a.obj", "unit": "furlong"}})");
  EXPECT_EQ(unit.field(), "object.unit");
  EXPECT_EQ(unit.value(), "furlong");
}

TEST(SceneFile, AMissingMeshIsNamed) {
  try {
    (void)load_scene(write(R"({"object": {"mesh": "nowhere.obj"}})"));
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("nowhere.obj"), std::string::npos) << error.what();
  }
}

TEST(SceneFile, AnUnknownUnitIsNamed) {
  const std::filesystem::path file = testing::TempDir() + "/some.obj";
  std::ofstream(file) << "v 0 0 0\n";
  try {
    (void)load_scene(file, {.hand = "", .unit = "furlong"});
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("furlong"), std::string::npos) << error.what();
  }
}

TEST(SceneFile, ANameOfTheLibraryIsEnough) {
  const Scene scene = load_scene("mug");
  EXPECT_EQ(scene.name, "mug");
  EXPECT_TRUE(std::holds_alternative<GeneratedSource>(scene.object.source));
  try {
    (void)load_scene("no_such_scene");
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.file(), "no_such_scene");
    EXPECT_NE(error.problem().find("mug_on_table"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace prehend
