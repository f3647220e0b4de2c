#include "sim/scene/named_mass.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "sim/scene/object_mass.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_text.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

// A head of 0.1 x 0.03 x 0.03 m on the end of a handle of 0.02 x 0.02 x 0.3 m whose middle is 0.
const Vector3 kHead{0.1, 0.03, 0.03};
const Vector3 kHandle{0.02, 0.02, 0.3};
constexpr double kHeadAt = 0.17;  // along z

void write_box(std::ofstream& out, const Vector3& size, double z, int first) {
  const TriangleMesh box = make_box(size);
  for (const Vector3& p : box.vertices) {
    out << "v " << p.x() << " " << p.y() << " " << p.z() + z << "\n";
  }
  for (const Triangle& t : box.triangles) {
    out << "f " << t[0] + first << " " << t[1] + first << " " << t[2] + first << "\n";
  }
}

// As an OBJ file, with statements before each.
std::filesystem::path hammer_file(const std::string& of_head, const std::string& of_handle) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / (std::string(test->name()) + ".obj");
  std::ofstream out(file);
  out << of_head << "\n";
  write_box(out, kHead, kHeadAt, 1);
  out << of_handle << "\n";
  write_box(out, kHandle, 0.0, 9);
  return file;
}

TEST(NamedMaterial, IsAWordOfTheName) {
  for (const char* name :
       {"steel", "Steel.001 head", "HammerSteel", "brushed_steel-2", "a STEEL"}) {
    ASSERT_TRUE(material_in(name)) << name;
    EXPECT_EQ(material_in(name)->name, "steel");
    EXPECT_EQ(material_in(name)->density, 7850.0);
  }
  for (const char* name : {"", "steely", "Material.001", "head", "\xff\xfe"}) {
    EXPECT_FALSE(material_in(name)) << name;
  }
}

TEST(NamedMass, OfASteelHeadLiesNearIt) {
  const auto file = hammer_file("usemtl Steel.001\no Head", "o Handle\nusemtl oak_wood");
  const Scene scene = load_scene(file);
  const double head = 7850.0 * kHead.prod();
  const double handle = 740.0 * kHandle.prod();
  EXPECT_NEAR(scene.object.mass, head + handle, 1e-6);
  EXPECT_NEAR(scene.object.center_of_mass.z(), head * kHeadAt / (head + handle), 1e-6);
  EXPECT_EQ(scene.object.mass_basis, MassBasis::materials);
  ASSERT_EQ(scene.notes.size(), 1U);
  EXPECT_EQ(scene.notes[0],
            "0.795 kg, spread by the materials that the file names: state center_of_mass or parts "
            "if they are others");
}

TEST(NamedMass, IsWhatItIsToldAsAWhole) {
  const auto file = hammer_file("usemtl steel", "usemtl wood");
  GraspableBody object = load_scene(file).object;
  const double z = object.center_of_mass.z();
  std::ofstream(file.parent_path() / "hammer.json")
      << R"({"object": {"mesh": ")" << file.filename().string() << R"(", "mass": 0.5}})";
  object = load_scene(file.parent_path() / "hammer.json").object;
  EXPECT_NEAR(object.mass, 0.5, 1e-12);
  EXPECT_NEAR(object.center_of_mass.z(), z, 1e-9);
  EXPECT_EQ(object.mass_basis, MassBasis::materials);
}

TEST(NamedMass, GivesWayToWhatTheSceneSays) {
  const auto file = hammer_file("usemtl steel", "usemtl wood");
  for (const char* said : {R"("density": 500)", R"("center_of_mass": [0, 0, 0.02])",
                           R"("parts": [{"component": 0, "density": 900}], "density": 500)"}) {
    std::ofstream(file.parent_path() / "hammer.json")
        << R"({"object": {"mesh": ")" << file.filename().string() << R"(", )" << said << "}}";
    const GraspableBody object = load_scene(file.parent_path() / "hammer.json").object;
    EXPECT_NE(object.mass_basis, MassBasis::materials) << said;
  }
}

// Without the material of a piece nothing is known, of one material all over nothing new.
TEST(NamedMass, StaysEvenWhereMaterialsDoNotTell) {
  for (const auto& [head, handle] :
       std::vector<std::pair<std::string, std::string>>{{"o head", "o handle"},
                                                        {"usemtl steel", "usemtl Material.002"},
                                                        {"usemtl steel", "usemtl Steel.002"},
                                                        {"", ""}}) {
    const GraspableBody object = load_scene(hammer_file(head, handle)).object;
    EXPECT_EQ(object.mass_basis, MassBasis::uniform) << head << ", " << handle;
    EXPECT_EQ(object.mass, kDefaultObjectMass);
  }
}

TEST(NamedMass, IsReadAgainFromTheFileOfAWrittenScene) {
  const auto file = hammer_file("usemtl steel", "usemtl wood");
  const Scene scene = load_scene(file);
  const std::filesystem::path copy = file.parent_path() / "named_copy.json";
  std::ofstream(copy) << scene_text(scene);
  const Scene again = load_scene(copy);
  EXPECT_NEAR(again.object.mass, scene.object.mass, 1e-12);
  EXPECT_TRUE(again.object.center_of_mass.isApprox(scene.object.center_of_mass, 1e-12));
  EXPECT_EQ(again.object.mass_basis, MassBasis::materials);
}

}  // namespace
}  // namespace prehend
