#include "sim/scene/object_mesh.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/base/input_file.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_text.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/mesh_checks.h"

namespace prehend {
namespace {

// A box of this longest side as an OBJ file, without its last two triangles (a face) if `open`.
std::filesystem::path box_file(const std::string& name, double size, bool open) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / name;
  TriangleMesh box = make_box({size, 0.5 * size, 0.5 * size});
  if (open)
    std::erase_if(box.triangles, [&](const Triangle& t) {
      return box.vertices[static_cast<std::size_t>(t[0])].x() > 0.0 &&
             box.vertices[static_cast<std::size_t>(t[1])].x() > 0.0 &&
             box.vertices[static_cast<std::size_t>(t[2])].x() > 0.0;
    });
  std::ofstream out(file);
  for (const Vector3& p : box.vertices) out << "v " << p.transpose() << "\n";
  for (const Triangle& t : box.triangles) {
    out << "f " << t[0] + 1 << " " << t[1] + 1 << " " << t[2] + 1 << "\n";
  }
  return file;
}

TEST(ObjectMesh, KnowsTheLikelyUnitOfASize) {
  for (const double size : {1e-4, 0.09, 1.0, 1.5}) EXPECT_EQ(likely_unit(size), "m") << size;
  for (const double size : {1.6, 2.9}) EXPECT_EQ(likely_unit(size), "in") << size;
  for (const double size : {3.1, 9.0, 29.0}) EXPECT_EQ(likely_unit(size), "cm") << size;
  for (const double size : {30.5, 90.0, 499.0, 999.0}) EXPECT_EQ(likely_unit(size), "mm") << size;
  for (const double size : {1001.0, 1e6}) EXPECT_EQ(likely_unit(size), "m") << size;
  for (const double size : {1.6, 3.1, 20.0, 999.0})
    EXPECT_EQ(likely_unit(size, true), "mm") << size;
  for (const double size : {0.1, 1001.0}) EXPECT_EQ(likely_unit(size, true), "m") << size;
}

TEST(ObjectMesh, OfACadProgramIsInMillimetres) {
  const std::filesystem::path file = box_file("part.obj", 8.0, false);
  const std::string text = read_file(file);
  EXPECT_NEAR(bounds(load_scene(file).object.mesh).size().x(), 0.08, 1e-8);
  std::ofstream(file) << "# made with FreeCAD 0.21\n" << text;
  EXPECT_NEAR(bounds(load_scene(file).object.mesh).size().x(), 0.008, 1e-8);
  // Only in the comments at the head.
  std::ofstream(file) << "o freecad\n" << text;
  EXPECT_NEAR(bounds(load_scene(file).object.mesh).size().x(), 0.08, 1e-8);
}

TEST(ObjectMesh, AUnitMayBeANumberOfMetres) {
  const std::filesystem::path file = box_file("scaled.obj", 3.0, false);
  const Scene scene = load_scene(file, {.hand = "", .unit = "0.02"});
  EXPECT_NEAR(bounds(scene.object.mesh).size().x(), 0.06, 1e-8);
  EXPECT_EQ(unit_of_source(file, scene), "0.02");
  for (const char* unit : {"0", "-1", "1e9", "nan", "1 m", "0x1", ""}) {
    EXPECT_THROW((void)metres_per_unit(unit), InputError) << unit;
  }
}

TEST(ObjectMesh, IsReadInTheLikelyUnitWithANote) {
  const std::filesystem::path file = box_file("likely.obj", 90.0, false);
  const Scene scene = load_scene(file);
  EXPECT_NEAR(bounds(scene.object.mesh).size().x(), 0.09, 1e-8);
  EXPECT_EQ(unit_of_source(file, scene), "mm");
  ASSERT_EQ(scene.notes.size(), 1u);
  EXPECT_EQ(scene.notes[0],
            "90 long in the file, whose unit nobody says: read in mm, which makes it 90 mm; --unit "
            "m reads it in metres");
  // With the unit stated, the same bytes and no note.
  const Scene stated = load_scene(file, {.hand = "", .unit = "mm"});
  EXPECT_EQ(stated.object.mesh.vertices, scene.object.mesh.vertices);
  EXPECT_TRUE(stated.notes.empty());
}

TEST(ObjectMesh, IsReadInTheStatedUnitWhateverItsSize) {
  const std::filesystem::path file = box_file("stated.obj", 90.0, false);
  const Scene scene = load_scene(file, {.hand = "", .unit = "m"});
  EXPECT_NEAR(bounds(scene.object.mesh).size().x(), 90.0, 1e-5);
  ASSERT_EQ(scene.notes.size(), 1u);
  EXPECT_EQ(scene.notes[0], "9e+04 mm large in the stated unit (900 mm if its unit were cm)");
}

TEST(ObjectMesh, IsRepairedUnlessToldNotTo) {
  const std::filesystem::path file = box_file("open.obj", 0.1, true);
  const Scene scene = load_scene(file);
  EXPECT_TRUE(check_mesh(scene.object.mesh).solid());
  EXPECT_EQ(scene.object.mass_source, MassSource::signed_volume);
  ASSERT_EQ(scene.notes.size(), 1u);
  EXPECT_EQ(scene.notes[0],
            "1 hole closed (10 % of the surface); volume, centre of mass and inside are those of "
            "the solid; --no-repair keeps the surface as it is in the file");
  const Scene as_it_is = load_scene(file, {.hand = "", .unit = "", .repair = false});
  EXPECT_EQ(check_mesh(as_it_is.object.mesh).boundary_edges, 4);
  EXPECT_TRUE(as_it_is.notes.empty());
  EXPECT_NE(scene_text(as_it_is).find("\"repair\": false"), std::string::npos);
  EXPECT_EQ(scene_text(scene).find("\"repair\""), std::string::npos);
}

}  // namespace
}  // namespace prehend
