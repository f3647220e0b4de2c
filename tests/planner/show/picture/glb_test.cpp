#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "planner/show/picture/glb_bytes.h"
#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/files/mesh_file.h"
#include "tests/support/glb_file.h"

namespace prehend {
namespace {

using test::at;
using test::Glb;
using test::pose_of;
using Json = nlohmann::json;

constexpr Color kPaint = {0.8, 0.4, 0.2, 1.0};
constexpr Color kGlass = {0.8, 0.4, 0.2, 0.25};

// glTF: +y is up, +z is the front. Seen from there, the world's x stays to the right.
Vector3 y_up(const Vector3& p) { return {p.x(), p.z(), -p.y()}; }

Glb read(const std::vector<DrawnBody>& bodies) { return Glb(glb_bytes(bodies, "bodies", {})); }

std::vector<DrawnBody> samples() {
  Random random(7);
  return {{make_sphere(0.1, 2), random.pose(2.0), kGlass, "ball"},
          {make_box(Vector3(0.1, 0.2, 0.3)), random.pose(2.0), kPaint, "box"},
          {make_cylinder(0.05, 0.2, 15, 3), random.pose(2.0), kPaint, "can"},
          // An odd number of 16-bit indices ends between two words.
          {TriangleMesh{{Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY()}, {{0, 1, 2}}},
           random.pose(2.0), kPaint, "leaf"}};
}

TEST(GlbTest, EveryTriangleIsWhereItsBodyHasIt) {
  const std::vector<DrawnBody> bodies = samples();
  const Glb glb = read(bodies);
  ASSERT_EQ(glb.root()["children"].size(), bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Json& node = glb.node(b);
    EXPECT_EQ(node["name"], bodies[b].name);
    const Pose X = pose_of(glb.root()) * pose_of(node);
    const std::vector<std::size_t> indices = glb.indices(node);
    const std::vector<Vector3> positions = glb.vectors(node, "POSITION");
    const TriangleMesh& mesh = *bodies[b].mesh;
    ASSERT_EQ(indices.size(), 3 * mesh.triangles.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
      const auto v = static_cast<std::size_t>(mesh.triangles[i / 3][i % 3]);
      const Vector3 expected = y_up(bodies[b].X_WB * mesh.vertices[v]);
      // Positions up to 1 m are rounded to 24 bits, poses are not.
      EXPECT_LT((X * positions.at(indices[i]) - expected).norm(), 1e-7) << b << " " << i;
    }
  }
}

TEST(GlbTest, NormalsPointOutward) {
  const Glb glb = read(samples());
  const std::vector<Vector3> positions = glb.vectors(glb.node(0), "POSITION");
  const std::vector<Vector3> normals = glb.vectors(glb.node(0), "NORMAL");
  ASSERT_EQ(normals.size(), positions.size());
  for (std::size_t v = 0; v < normals.size(); ++v) {
    EXPECT_NEAR(normals[v].norm(), 1.0, 1e-6);
    EXPECT_GT(normals[v].dot(positions[v].normalized()), 0.99);
  }
}

TEST(GlbTest, TheLibrarysReaderFindsTheSameTriangles) {
  const std::vector<DrawnBody> bodies = samples();
  std::size_t triangles = 0;
  Bounds expected;
  for (const DrawnBody& body : bodies) {
    triangles += body.mesh->triangles.size();
    for (const Vector3& p : body.mesh->vertices) {
      expected.lower = expected.lower.cwiseMin(y_up(body.X_WB * p));
      expected.upper = expected.upper.cwiseMax(y_up(body.X_WB * p));
    }
  }
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "bodies.glb";
  std::ofstream(file, std::ios::binary) << glb_bytes(bodies, "bodies", {});
  const LoadedMesh loaded = load_mesh(file);
  EXPECT_EQ(loaded.mesh.triangles.size(), triangles);
  // The reader places nodes in single precision.
  EXPECT_LT((bounds(loaded.mesh).lower - expected.lower).norm(), 3e-6);
  EXPECT_LT((bounds(loaded.mesh).upper - expected.upper).norm(), 3e-6);
}

TEST(GlbTest, DataIsAlignedBoundedAndComplete) {
  const Glb glb = read(samples());
  ASSERT_EQ(glb.document["buffers"].size(), 1U);
  EXPECT_EQ(glb.document["buffers"][0]["byteLength"], glb.data.size());
  std::size_t end = 0;
  for (const Json& view : glb.document["bufferViews"]) {
    const std::size_t start = view["byteOffset"];
    EXPECT_EQ(start % 4, 0U);
    EXPECT_GE(start, end);
    EXPECT_LT(start - end, 4U);
    end = start + view["byteLength"].get<std::size_t>();
    EXPECT_TRUE(view["target"] == 34962 || view["target"] == 34963);
  }
  EXPECT_LT(glb.data.size() - end, 4U);
  for (std::size_t b = 0; b < 4; ++b) {
    const std::vector<Vector3> positions = glb.vectors(glb.node(b), "POSITION");
    const Json& accessor =
        glb.entry("accessors", glb.primitive(glb.node(b))["attributes"]["POSITION"]);
    for (std::size_t k = 0; k < 3; ++k) {
      double lower = positions[0][static_cast<int>(k)];
      double upper = lower;
      for (const Vector3& p : positions) {
        lower = std::min(lower, p[static_cast<int>(k)]);
        upper = std::max(upper, p[static_cast<int>(k)]);
      }
      EXPECT_EQ(accessor["min"][k], lower);
      EXPECT_EQ(accessor["max"][k], upper);
    }
  }
}

TEST(GlbTest, MoreVerticesThanSixteenBitsCount) {
  const DrawnBody body{make_box(Vector3(1, 1, 1), 110), Pose::Identity(), kPaint, "box"};
  const Glb glb = read({body});
  const std::vector<std::size_t> indices = glb.indices(glb.node(0));
  ASSERT_EQ(indices.size(), 3 * body.mesh->triangles.size());
  EXPECT_EQ(*std::max_element(indices.begin(), indices.end()), 6U * 111U * 111U - 1U);
}

TEST(GlbTest, ColorsAreLightAndMaterialsAreShared) {
  const Glb glb = read(samples());
  ASSERT_EQ(glb.document["materials"].size(), 2U);
  EXPECT_EQ(glb.primitive(glb.node(1))["material"], glb.primitive(glb.node(2))["material"]);
  for (const bool glass : {false, true}) {
    const Json& material = glb.material(glb.node(glass ? 0 : 1));
    const Json& look = material["pbrMetallicRoughness"];
    const Light light = light_of(kPaint);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(look["baseColorFactor"][k].get<float>(), light[k]);
    }
    EXPECT_EQ(look["baseColorFactor"][3], glass ? 0.25 : 1.0);
    EXPECT_EQ(look["metallicFactor"], 0.0);
    EXPECT_EQ(material["doubleSided"], true);
    EXPECT_EQ(material.value("alphaMode", "OPAQUE"), glass ? "BLEND" : "OPAQUE");
  }
}

TEST(GlbTest, AMeshIsStoredOnce) {
  const TriangleMesh ball = make_sphere(0.1, 2);
  const Glb glb = read({{ball, Pose::Identity(), kPaint, "a"},
                        {ball, translation(Vector3::UnitX()), kPaint, "b"},
                        {ball, translation(Vector3::UnitY()), kGlass, "c"}});
  EXPECT_EQ(glb.document["bufferViews"].size(), 3U);
  EXPECT_EQ(glb.document["meshes"].size(), 2U);
  EXPECT_EQ(glb.node(0)["mesh"], glb.node(1)["mesh"]);
  EXPECT_NE(glb.node(0)["mesh"], glb.node(2)["mesh"]);
  EXPECT_EQ(glb.primitive(glb.node(0))["attributes"], glb.primitive(glb.node(2))["attributes"]);
}

TEST(GlbTest, NamesMayHoldAnything) {
  const std::vector<std::string> names = {"<script>alert(1)</script>",
                                          "\"},{\\",
                                          std::string("\0\n\x7f", 3),
                                          "Gl\u00e4ser \u2615",
                                          "",
                                          "cup",
                                          "cup"};
  std::vector<DrawnBody> bodies;
  for (const std::string& name : names) {
    bodies.push_back({make_box(Vector3(1, 1, 1)), Pose::Identity(), kPaint, name});
  }
  bodies.push_back({make_box(Vector3(1, 1, 1)), Pose::Identity(), kPaint, "a\xff\xc3(b\xe2\x82"});
  const Glb glb = read(bodies);
  for (std::size_t b = 0; b < names.size(); ++b) EXPECT_EQ(glb.node(b)["name"], names[b]);
  const std::string replaced = glb.node(names.size())["name"];
  EXPECT_EQ(replaced.find("a\uFFFD"), 0U) << replaced;
  EXPECT_NE(replaced.find("(b\uFFFD"), std::string::npos) << replaced;
}

TEST(GlbTest, TheRootSaysWhatItIs) {
  const Glb glb(glb_bytes(samples(), "grasp 3", {{"rank", 3}, {"outcome", "st\xff"}}));
  EXPECT_EQ(glb.root()["name"], "grasp 3");
  EXPECT_EQ(glb.root()["extras"]["rank"], 3);
  EXPECT_EQ(glb.root()["extras"]["outcome"], "st\uFFFD");
  EXPECT_EQ(glb.document["asset"]["version"], "2.0");
  EXPECT_EQ(glb.document["asset"]["generator"], "prehend");
  EXPECT_FALSE(read(samples()).root().contains("extras"));
}

TEST(GlbTest, WhatHasNoAreaIsLeftOut) {
  const TriangleMesh thin{{Vector3::Zero(), Vector3::UnitX(), 2.0 * Vector3::UnitX()},
                          {{0, 1, 2}, {0, 0, 1}}};
  const DrawnBody box{make_box(Vector3(1, 1, 1)), Pose::Identity(), kPaint, "box"};
  const Glb glb = read({{{}, Pose::Identity(), kGlass, "nothing"},
                        {thin, Pose::Identity(), kGlass, "thin"},
                        box,
                        {thin, Pose::Identity(), kGlass, "thin again"}});
  ASSERT_EQ(glb.root()["children"].size(), 1U);
  EXPECT_EQ(glb.node(0)["name"], "box");
  EXPECT_EQ(glb.document["meshes"].size(), 1U);
  EXPECT_EQ(glb.document["materials"].size(), 1U);
}

TEST(GlbTest, NothingIsAFileWithoutLists) {
  const Glb glb = read({});
  EXPECT_EQ(glb.document["nodes"].size(), 1U);
  EXPECT_FALSE(glb.root().contains("children"));
  for (const char* list : {"meshes", "materials", "accessors", "bufferViews", "buffers"}) {
    EXPECT_FALSE(glb.document.contains(list)) << list;
  }
  EXPECT_TRUE(glb.data.empty());
}

TEST(GlbTest, SameBytesTwice) {
  EXPECT_EQ(glb_bytes(samples(), "bodies", {{"rank", 1}}),
            glb_bytes(samples(), "bodies", {{"rank", 1}}));
}

TEST(GlbTest, WhatIsNotFiniteIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<DrawnBody> bodies = samples();
  TriangleMesh mesh = *bodies[1].mesh;
  mesh.vertices[2].z() = nan;
  bodies[1].mesh = mesh;
  EXPECT_THROW(glb_bytes(bodies, "", {}), InputError);
  bodies = samples();
  bodies[2].X_WB.translation().x() = nan;
  EXPECT_THROW(glb_bytes(bodies, "", {}), InputError);
  bodies = samples();
  bodies[0].color = {nan, -1.0, 2.0, nan};
  const Json color =
      read(bodies).document["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"];
  EXPECT_EQ(color, (Json{0.0, 0.0, 1.0, 0.0}));
}

}  // namespace
}  // namespace prehend
