#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/files/mesh_readers.h"
#include "sim/shape/mass_properties.h"
#include "sim/shape/mesh_checks.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

constexpr const char* kInventorHeader = "#Inventor V2.1 ascii\n";

LoadedMesh inventor(const std::string& text) {
  return read_mesh(kInventorHeader + text, "shape.iv");
}

LoadedMesh vrml(const std::string& text) {
  return read_mesh("#VRML V2.0 utf8\n" + text, "shape.wrl");
}

void expect_box(const TriangleMesh& mesh, const Vector3& lower, const Vector3& upper) {
  const Bounds box = bounds(mesh);
  EXPECT_LT((box.lower - lower).norm(), 1e-9) << box.lower.transpose();
  EXPECT_LT((box.upper - upper).norm(), 1e-9) << box.upper.transpose();
}

void expect_closed(const TriangleMesh& mesh) {
  EXPECT_EQ(check_mesh(mesh).boundary_edges, 0);
  EXPECT_GT(signed_volume(mesh), 0.0);
}

// A tetrahedron with edges 1, 2, 3 along the axes.
constexpr const char* kCorners = "Coordinate3 { point [ 0 0 0, 1 0 0, 0 2 0, 0 0 3 ] }\n";
constexpr const char* kFaces =
    "IndexedFaceSet { coordIndex [ 0,2,1,-1, 0,1,3,-1, 0,3,2,-1, 1,2,3 ] }";

TEST(ReadInventor, ReadsFacesStripsAndShapesAsClosedSurfaces) {
  const auto volume_of = [](const std::string& text) {
    const LoadedMesh loaded = inventor(text);
    expect_closed(loaded.mesh);
    return signed_volume(loaded.mesh);
  };
  EXPECT_NEAR(volume_of(std::string(kCorners) + kFaces), 1.0, 1e-12);
  EXPECT_NEAR(
      volume_of(std::string(kCorners) + "IndexedTriangleStripSet { coordIndex [ 0 2 1 3 0 2 ] }"),
      1.0, 1e-12);
  EXPECT_NEAR(volume_of("Coordinate3 { point [ 9 9 9, 0 0 0, 0 2 0, 1 0 0, 0 0 0, 1 0 0, 0 0 3,"
                        " 0 0 0, 0 0 3, 0 2 0, 1 0 0, 0 2 0, 0 0 3 ] }"
                        "FaceSet { startIndex 1 numVertices [ 3, 3, 3, -1 ] }"),
              1.0, 1e-12);
  EXPECT_NEAR(volume_of("Cube { width 2 height 3 depth 4 }"), 24.0, 1e-12);
  // The prism over a regular polygon of 20 corners.
  const double polygon = 10.0 * std::sin(std::numbers::pi / 10.0);
  EXPECT_NEAR(volume_of("Cylinder { radius 1 height 5 }"), 5.0 * polygon, 1e-12);
  EXPECT_NEAR(volume_of("Cone { bottomRadius 1 height 6 }"), 2.0 * polygon, 1e-12);
  EXPECT_NEAR(volume_of("Sphere { radius 1 }"), 4.0 / 3.0 * std::numbers::pi, 0.2);
}

TEST(ReadInventor, LeavesPartsOutThatTheFileLeavesOut) {
  EXPECT_EQ(inventor("Cylinder { parts SIDES }").mesh.triangles.size(), 40u);
  EXPECT_EQ(inventor("Cylinder { parts (SIDES | TOP) }").mesh.triangles.size(), 58u);
  EXPECT_EQ(inventor("Cone { parts BOTTOM }").mesh.triangles.size(), 18u);
  EXPECT_EQ(vrml("Shape { geometry Cylinder { side FALSE } }").mesh.triangles.size(), 36u);
}

TEST(ReadInventor, MovesWhatFollowsATransformUntilTheSeparatorEnds) {
  const LoadedMesh loaded = inventor(
      "Separator { Translation { translation 10 0 0 } Separator { RotationXYZ { axis Z angle "
      "1.5707963267948966 } Cube { width 2 height 4 depth 6 } } Scale { scaleFactor 1 1 2 } Cube "
      "{} }"
      "Cube { }");
  expect_box(loaded.mesh, {-1, -1, -3}, {12, 1, 3});
  EXPECT_EQ(loaded.mesh.triangles.size(), 36u);
}

TEST(ReadInventor, AppliesTheTransformInTheOrderOfTheStandard) {
  // Scaled about the centre, turned about it, then moved.
  const LoadedMesh loaded = inventor(
      "Transform { translation 0 0 5 rotation 0 0 1 1.5707963267948966 scaleFactor 3 1 1 center 1 "
      "0 "
      "0 } Cube { }");
  expect_box(loaded.mesh, {0, -6, 4}, {2, 0, 6});
}

TEST(ReadInventor, MatrixTransformHasItsTranslationInTheLastRow) {
  const LoadedMesh loaded =
      inventor("MatrixTransform { matrix 0 1 0 0 -1 0 0 0 0 0 1 0 7 8 9 1 } Cube { width 4 }");
  expect_box(loaded.mesh, {6, 6, 8}, {8, 10, 10});
}

TEST(ReadInventor, TurnsClockwiseFacesAndMirroredOnesRound) {
  const std::string clockwise = "ShapeHints { vertexOrdering CLOCKWISE }";
  const std::string mirror = "Scale { scaleFactor -1 1 1 }";
  const auto volume_of = [](const std::string& text) {
    return signed_volume(inventor(text + kCorners + kFaces).mesh);
  };
  EXPECT_NEAR(volume_of(""), 1.0, 1e-12);
  EXPECT_NEAR(volume_of(clockwise), -1.0, 1e-12);
  EXPECT_NEAR(volume_of(mirror), 1.0, 1e-12);
}

TEST(ReadInventor, UsesNamedNodesAgain) {
  const LoadedMesh loaded = inventor(
      "Separator { DEF arm+0 Cube { } Translation { translation 5 0 0 } USE arm+0 DEF deep "
      "Separator { Translation { translation 5 0 0 } USE arm+0 } USE deep }");
  expect_box(loaded.mesh, {-1, -1, -1}, {11, 1, 1});
}

TEST(ReadInventor, UnitsScaleWhatFollowsFromTheUnitsBefore) {
  const LoadedMesh loaded = inventor(
      "Separator { Units { units MILLIMETERS } Cube { } Units { units CENTIMETERS } Translation { "
      "translation 5 0 0 } Cube { } }");
  expect_box(loaded.mesh, {-0.001, -0.01, -0.01}, {0.06, 0.01, 0.01});
}

TEST(ReadInventor, FollowsSwitches) {
  EXPECT_EQ(inventor("Cube {} Switch { Cylinder {} }").mesh.triangles.size(), 12u);
  EXPECT_EQ(inventor("Switch { whichChild 1 Cylinder {} Cube {} }").mesh.triangles.size(), 12u);
  EXPECT_EQ(inventor("Switch { whichChild -3 Cylinder {} Cube {} }").mesh.triangles.size(), 88u);
}

TEST(ReadInventor, ReadsVrml2) {
  const LoadedMesh loaded = vrml(
      "Viewpoint { position 0 0 9 }\n"
      "DEF a Transform { translation 10 0 0 rotation 0 0 1 1.5707963267948966 scale 2 1 1 children "
      "[\n"
      "  DEF TIMER TimeSensor { loop TRUE },\n"
      "  Shape { appearance Appearance { material Material { } } geometry Box { size 2 4 6 } }\n"
      "  Group { children Shape { geometry IndexedFaceSet { ccw FALSE coord DEF c Coordinate {\n"
      "    point [ 0 0 0, 1 0 0, 0 2 0, 0 0 3 ] } coordIndex [ 0 1 2 -1 0 3 1 -1 0 2 3 -1 1 3 2 "
      "-1]\n"
      "  } } } ] }\n"
      "ROUTE TIMER.fraction_changed TO a.set_scale\n");
  expect_box(loaded.mesh, {8, -2, -3}, {12, 2, 3});
  EXPECT_EQ(loaded.mesh.triangles.size(), 16u);
  EXPECT_NEAR(signed_volume(loaded.mesh), 98.0, 1e-9);
}

TEST(ReadInventor, SkipsWhatHasNoSurface) {
  const LoadedMesh loaded = inventor(
      "# a comment with { and \"\nInfo { string \"x = {\n 0 } # \" } Material { diffuseColor [ .1 "
      ".2 "
      ".3 ] } NormalBinding { value PER_FACE } EventCallback { } SomethingOfSomebody { size 3 } "
      "PackedColor { rgba 0xff00ffff } IndexedLineSet { coordIndex [ 0, 1 ] } Cube { }");
  EXPECT_EQ(loaded.mesh.triangles.size(), 12u);
}

struct Refused {
  std::string text;
  std::string line;
  std::string phrase;
};

TEST(ReadInventor, RefusesWithTheLine) {
  const std::vector<Refused> all = {
      {"Cube {", "line 2", "not closed"},
      {"Separator {\nText3 { string \"a\" } }", "line 3", "'Text3'"},
      {"\nNurbsSurface { }", "line 3", "'NurbsSurface'"},
      {"MyKit { Separator { Cube { } } }", "line 2", "'MyKit'"},
      {"USE a DEF a Cube { }", "line 2", "no node of this name"},
      {"DEF a Separator { USE a }", "line 2", "no node of this name"},
      {"PROTO X [ ] { }", "line 2", "defined in the file"},
      {"Cube { width -1 }", "line 2", "must be positive"},
      {"Cube { width nan }", "line 2", "not a number"},
      {"Cube { width 1e999 }", "line 2", "not a finite number"},
      {"Cube { width 1 2 }", "line 2", "must be 1 number"},
      {"Cube { width }", "line 2", "without a value"},
      {"Cube { 3 }", "line 2", "where a field begins"},
      {"} Cube { }", "line 2", "missing"},
      {"Info { string \"abc", "line 2", "not closed"},
      {"Cylinder { parts LEFT }", "line 2", "'LEFT'"},
      {std::string(kCorners) + "\nIndexedFaceSet { coordIndex [ 0, 1, 4 ] }", "line 4",
       "vertex 4 of 4"},
      {std::string(kCorners) + "IndexedFaceSet { coordIndex [ 0, 1, -2 ] }", "line 3", "vertex -2"},
      {std::string(kCorners) + "IndexedFaceSet { coordIndex [ 0, 1, 1.5 ] }", "line 3", "whole"},
      {std::string(kCorners) + "FaceSet { numVertices [ 3, 3 ] }", "line 3", "more vertices"},
      {"Coordinate3 { point [ 0 0 0 1 ] }\nFaceSet { }", "line 2", "three numbers each"},
      {"Coordinate3 { point [ 0 0 0, 1 x 1, 0 1 0 ] }\nFaceSet { }", "line 2", "'x'"},
      {"Units { units PARSECS }", "line 2", "'PARSECS'"},
      {"Rotation { rotation 0 0 0 1 } Cube { }", "line 2", "axis of length 0"},
      {"MatrixTransform { matrix 1 0 0 1 0 1 0 0 0 0 1 0 0 0 0 1 } Cube { }", "line 2", "0 0 0 1"},
  };
  for (const Refused& refused : all) {
    SCOPED_TRACE(refused.text);
    const InputError error = test::refusal_of([&] { (void)inventor(refused.text); });
    EXPECT_EQ(error.field(), refused.line) << error.what();
    EXPECT_NE(error.problem().find(refused.phrase), std::string::npos) << error.what();
    EXPECT_EQ(error.file(), "shape.iv");
  }
}

TEST(ReadInventor, RefusesOtherFiles) {
  for (const char* text : {"Cube { }", "#Inventor V2.1 binary\nxxx", "#VRML V3.0 utf8\nCube { }"}) {
    EXPECT_THROW((void)read_mesh(text, "a.iv"), InputError) << text;
  }
  EXPECT_THROW((void)inventor("Info { string \"nothing\" }"), InputError);
}

// Every group uses the one before it twice: 2^60 cubes.
TEST(ReadInventor, RefusesNodesThatMultiply) {
  std::string text = "DEF a0 Cube { }\n";
  for (int k = 1; k <= 60; ++k) {
    const std::string before = "a" + std::to_string(k - 1);
    text += "DEF a" + std::to_string(k) + " Group { USE " + before + " USE " + before + " }\n";
  }
  const InputError error = test::refusal_of([&] { (void)inventor(text); });
  EXPECT_NE(error.problem().find("millions"), std::string::npos) << error.what();
}

TEST(ReadInventor, RefusesDeepNesting) {
  std::string text;
  for (int k = 0; k < 100'000; ++k) text += "Separator { ";
  const InputError error = test::refusal_of([&] { (void)inventor(text); });
  EXPECT_NE(error.problem().find("nested"), std::string::npos) << error.what();
}

}  // namespace
}  // namespace prehend
