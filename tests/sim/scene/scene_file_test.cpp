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

// Friction of the object, whatever touches it; the friction of pairs without it stays.
TEST(SceneFile, AnObjectMayHaveAFrictionOfItsOwn) {
  const Scene scene = load_scene(write(R"({"object": {"generate": "ball", "triangles": 300,
      "material": "glass", "friction": 0.85}, "friction": [
      {"between": ["glass", "rubber"], "static": 0.3}, {"between": ["wood", "rubber"], "static": 0.4}]})"));
  for (const Material material : kAll<Material>) {
    EXPECT_EQ(scene.friction.between(Material::glass, material), 0.85);
  }
  EXPECT_EQ(scene.friction.between(Material::wood, Material::rubber), 0.4);
  const InputError refusal = test::refusal_of([&] {
    load_scene(write(R"({"object": {"generate": "ball", "triangles": 300, "friction": -1}})"));
  });
  EXPECT_NE(std::string(refusal.what()).find("object.friction"), std::string::npos);
}

// A ball of 50 mm radius (mesh: inscribed) on a table, on a board between two, above a shelf, and
// turned boxes: the lowest point is 0.1 mm above what it stands on.
TEST(SceneFile, BodiesArePutDownOnWhatTheyStandOn) {
  const std::string shelf = R"("obstacles": [{"name": "shelf", "geometry": [
      {"shape": "box", "size": [1, 1, 0.02], "pose": [{"translate": [0, 0, 0.39]}]},
      {"shape": "box", "size": [1, 1, 0.02], "pose": [{"translate": [0, 0, 0.79]}]}]}])";
  const auto lowest = [&](const std::string& pose) {
    const Scene scene = load_scene(write(R"({"object": {"geometry": [{"shape": "box",
        "size": [0.1, 0.06, 0.04]}], "stands_on": "shelf", "pose": )" +
                                         pose + "}, " + shelf + "}"));
    double z = 1e9;
    for (const Vector3& p : scene.object.mesh.vertices) {
      z = std::min(z, (scene.object.X_WO * p).z());
    }
    return z;
  };
  EXPECT_NEAR(lowest(R"({"position": [0.1, 0.2, 2]})"), 0.8001, 2e-5);
  EXPECT_NEAR(lowest(R"({"position": [0.1, 0.2, 0.6]})"), 0.4001, 2e-5);
  EXPECT_NEAR(lowest(R"({"position": [0.1, 0.2, 0]})"), 0.8001, 2e-5);
  EXPECT_NEAR(lowest(R"({"position": [0.1, 0.2, 0.79]})"), 0.8001, 2e-5);
  EXPECT_NEAR(lowest(R"({"position": [0, 0, 2], "quaternion_wxyz": [0.8, 0.4, 0.4, 0.2]})"), 0.8001,
              2e-5);
  for (const auto& [where, what] :
       {std::pair(R"("shelf", "pose": {"position": [5, 0, 2]})", "must have shelf below"),
        std::pair(R"("shelv")", "did you mean shelf")}) {
    const InputError refusal = test::refusal_of([&, where = where] {
      load_scene(
          write(std::string(R"({"object": {"generate": "ball", "triangles": 300, "stands_on": )") +
                where + "}, " + shelf + "}"));
    });
    EXPECT_NE(std::string(refusal.what()).find("object.stands_on"), std::string::npos);
    EXPECT_NE(std::string(refusal.what()).find(what), std::string::npos) << refusal.what();
  }
}

TEST(SceneFile, ARobotIsPutDownOnWhatItStandsOn) {
  const Scene scene = load_scene(write(R"({"object": {"generate": "ball", "triangles": 300,
      "pose": {"position": [0.5, 0, 1]}}, "robot": {"platform": "panda", "stands_on": "table",
      "pose": {"position": [0.1, 0, 0]}}, "obstacles": [
      {"name": "table", "geometry": [{"shape": "box", "size": [1, 1, 0.1], "pose":
      [{"translate": [0, 0, 0.65]}]}]}]})"));
  const Link& base = scene.carrier->platform.robots[0].robot.links[0];
  ASSERT_LT(base.joint, 0);
  double z = 1e9;
  for (const Vector3& p : base.mesh.vertices) {
    z = std::min(z, (scene.carrier->X_WB * scene.carrier->platform.robots[0].X_MR * p).z());
  }
  EXPECT_NEAR(z, 0.7001, 2e-5);
  EXPECT_DOUBLE_EQ(scene.carrier->X_WB.translation().x(), 0.1);
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

const char* const kHammer = R"("name": "hammer", "geometry": [
    {"shape": "box", "size": [0.02, 0.3, 0.02]},
    {"shape": "box", "size": [0.1, 0.03, 0.03], "pose": [{"translate": [0, 0.165, 0]}]}])";

Scene hammer_with(const std::string& fields) {
  return load_scene(write(std::string(R"({"object": {)") + kHammer + fields + "}}"));
}

// Boxes take little more memory than their text; rounder shapes take much more.
TEST(SceneFile, ThousandsOfBoxesAreReadAndNotThousandsOfSpheres) {
  const auto scene_of = [](const std::string& shape, int count) {
    std::string text = std::string("{") + kBall + R"(, "obstacles": [)";
    for (int i = 0; i < count; ++i) {
      text += std::string(i == 0 ? "" : ", ") + R"({"name": "o)" + std::to_string(i) +
              R"(", "geometry": [)" + shape + R"(], "pose": {"position": [)" +
              std::to_string(1 + i) + ", 0, 0]}}";
    }
    return text + "]}";
  };
  const Scene scene =
      load_scene(write(scene_of(R"({"shape": "box", "size": [0.1, 0.1, 0.1]})", 5000)));
  EXPECT_EQ(scene.obstacles.size(), 5000U);
  const InputError refusal = test::refusal_of(
      [&] { (void)load_scene(write(scene_of(R"({"shape": "sphere", "radius": 0.1})", 5000))); });
  EXPECT_NE(refusal.problem().find("at most 50000 triangles"), std::string::npos) << refusal.what();
}

TEST(SceneFile, PartsSayWhereTheMassIs) {
  const double handle = 0.02 * 0.3 * 0.02;
  const double head = 0.1 * 0.03 * 0.03;
  const double mass = 700.0 * handle + 7800.0 * head;
  const double center = 0.165 * 7800.0 * head / mass;
  for (const char* region :
       {R"("component": 1)", R"("beyond": {"point": [0, 0.15, 0], "normal": [0, 3, 0]})",
        R"("inside": {"shape": "box", "size": [1, 1, 1], "pose": {"position": [0, 0.65, 0]}})"}) {
    const std::string part =
        std::string(R"(, "parts": [{"name": "head", "density": 7800, )") + region + "}]";
    const Scene scene = hammer_with(R"(, "density": 700)" + part);
    EXPECT_NEAR(scene.object.mass, mass, 1e-12);
    EXPECT_LT((scene.object.center_of_mass - Vector3(0, center, 0)).norm(), 1e-12);
    EXPECT_EQ(scene.object.mass_basis, MassBasis::parts);
    EXPECT_TRUE(scene.notes.empty());
    const Scene scaled = hammer_with(R"(, "density": 700, "mass": 1)" + part);
    EXPECT_EQ(scaled.object.mass, 1.0);
    EXPECT_LT((scaled.object.inertia - scene.object.inertia / mass).norm(), 1e-12);
    const Scene left = hammer_with(R"(, "mass": 1)" + part);
    EXPECT_NEAR(left.object.center_of_mass.y(), 0.165 * 7800.0 * head, 1e-12);
  }
  const Scene weighted = hammer_with(R"(, "mass": 1, "parts": [{"at": [0, 0.1, 0], "mass": 0.4}])");
  const Scene uniform = hammer_with(R"(, "mass": 1)");
  EXPECT_NEAR(weighted.object.center_of_mass.y(), 0.04 + 0.6 * uniform.object.center_of_mass.y(),
              1e-12);
}

TEST(SceneFile, ADensityAloneSaysTheMass) {
  const Scene scene = hammer_with(R"(, "density": 1000)");
  EXPECT_NEAR(scene.object.mass, 1000.0 * (0.02 * 0.3 * 0.02 + 0.1 * 0.03 * 0.03), 1e-12);
  EXPECT_EQ(scene.object.mass_basis, MassBasis::uniform);
}

TEST(SceneFile, ALongObjectOfUniformMassIsNoted) {
  ASSERT_EQ(hammer_with("").notes.size(), 1U);
  EXPECT_EQ(hammer_with("").notes[0],
            "330 mm long and its mass is taken as uniform: state center_of_mass or parts if it is "
            "heavier at one end");
  const Scene stated = hammer_with(R"(, "center_of_mass": [0, 0.13, 0])");
  EXPECT_TRUE(stated.notes.empty());
  EXPECT_EQ(stated.object.mass_basis, MassBasis::center);
  for (const char* name :
       {"mug", "wine_glass", "phone", "flask", "bottle", "bowl", "box", "ball", "cylinder"}) {
    const Scene scene = load_scene(
        write(std::string(R"({"object": {"triangles": 500, "generate": ")") + name + "\"}}"));
    EXPECT_TRUE(scene.notes.empty()) << name;
  }
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
        BadScene{"NegativeDensity", R"({"object": {"generate": "mug", "parts": [
            {"component": 0, "density": -5}]}})",
                 "object.parts[0].density: must be at least 0 (-5)"},
        BadScene{"RegionBeside", R"({"object": {"generate": "mug", "density": 1000, "parts": [
            {"inside": {"shape": "sphere", "radius": 0.01, "pose": {"position": [1, 0, 0]}},
             "density": 5}]}})",
                 "object.parts[0].inside: must meet the object"},
        BadScene{"NoSuchComponent", R"({"object": {"generate": "mug", "density": 1000, "parts": [
            {"component": 3, "density": 5}]}})",
                 "object.parts[0].component: the mesh has only one, 0 (3)"},
        BadScene{"UnknownFieldOfAPart", R"({"object": {"generate": "mug", "parts": [
            {"component": 0, "weight": 5}]}})",
                 "object.parts[0].weight: unknown field"},
        BadScene{"PartInTwoPlaces", R"({"object": {"generate": "mug", "parts": [
            {"component": 0, "at": [0, 0, 0], "mass": 5}]}})",
                 "object.parts[0]: needs exactly one of component, inside, beyond, at"},
        BadScene{"PartOfAConeIsNone", R"({"object": {"generate": "mug", "density": 1, "parts": [
            {"inside": {"shape": "cone", "radius_low": 1, "radius_high": 0, "height": 1},
             "mass": 5}]}})",
                 "object.parts[0].inside.shape: must be box, cylinder or sphere (cone)"},
        BadScene{"PartsHeavierThanTheWhole", R"({"object": {"generate": "mug", "mass": 0.2,
            "parts": [{"at": [0, 0, 0], "mass": 0.3}]}})",
                 "object.mass: must be more than what the parts weigh, 0.3 kg (0.2)"},
        BadScene{"NoParts", R"({"object": {"generate": "mug", "parts": []}})",
                 "object.parts: must have at least one part"},
        BadScene{"PartsAndCentre", R"({"object": {"generate": "mug", "center_of_mass": [0, 0, 0],
            "parts": [{"at": [0, 0, 0], "mass": 0.3}]}})",
                 "object.center_of_mass: not beside parts, from which it follows"},
        BadScene{"MassAndDensity", R"({"object": {"generate": "mug", "mass": 1, "density": 5}})",
                 "object.density: not beside mass, where there are no parts (5)"},
        BadScene{"MassUnknown", R"({"object": {"generate": "mug", "parts": [
            {"at": [0, 0, 0], "mass": 0.3}]}})",
                 "object.mass: needed, or density of what no part covers"},
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
                 "friction[0].static: must be given"},
        BadScene{"BouncesHigher", R"({"object": {"generate": "mug", "restitution": 1.5}})",
                 "object.restitution: must be at least 0 and at most 1 (1.5)"},
        BadScene{"NegativeRestitution", R"({"object": {"generate": "mug"}, "obstacles": [
            {"name": "mat", "generate": "box", "restitution": -0.1}]})",
                 "obstacles[0].restitution: must be at least 0 and at most 1 (-0.1)"},
        BadScene{"ThreeMaterials", R"({"object": {"generate": "mug"},
            "friction": [{"between": ["wood", "wood", "wood"], "static": 0.1}]})",
                 "two materials"},
        BadScene{"NotARotation", R"({"object": {"generate": "mug",
            "pose": {"quaternion_wxyz": [0, 0, 0, 0]}}})",
                 "quaternion_wxyz"},
        BadScene{"EmptyBox", R"({"object": {"generate": "mug",
            "primitives": [{"shape": "box", "size": [1, 0, 1]}]}})",
                 "above 0"},
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
