// GraspIt!'s own triangles of its files, beside those that are read here.
#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/shape/files/mesh_file.h"
#include "sim/shape/triangle_mesh.h"
#include "tests/support/shared_data.h"

namespace prehend {
namespace {

nlohmann::json json_file(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return nlohmann::json::parse(stream);
}

Vector3 vector_in(const nlohmann::json& list) {
  return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

TEST(InventorReference, ObjectsHaveTheTrianglesAndBoxesOfTheManifest) {
  PREHEND_NEEDS_SHARED("data/graspit_objects");
  const nlohmann::json manifest = json_file(test::shared("data/manifest.json"));
  int compared = 0;
  for (const nlohmann::json& entry : manifest["objects"]) {
    const std::string file = entry["file"];
    if (!file.starts_with("graspit_objects/") || !file.ends_with(".iv")) continue;
    SCOPED_TRACE(file);
    const LoadedMesh loaded =
        load_mesh(test::shared("data") / file, {.metres_per_unit = entry["scale_to_m"]});
    // The manifest counts triangles of no area and repeated ones, which loading removes.
    const int removed = loaded.degenerate_removed + loaded.duplicates_removed;
    EXPECT_EQ(static_cast<int>(loaded.mesh.triangles.size()) + removed, entry["triangles"]);
    const Bounds box = bounds(loaded.mesh);
    EXPECT_LT((box.lower - vector_in(entry["bbox_min_m"])).norm(), 2e-6);
    EXPECT_LT((box.upper - vector_in(entry["bbox_max_m"])).norm(), 2e-6);
    ++compared;
  }
  EXPECT_EQ(compared, 13);
}

TEST(InventorReference, ObjectsAreTheConvertedOnes) {
  PREHEND_NEEDS_SHARED("data/graspit_objects/converted_obj");
  for (const auto& entry :
       std::filesystem::directory_iterator(test::shared("data/graspit_objects/converted_obj"))) {
    SCOPED_TRACE(entry.path().string());
    const TriangleMesh converted = load_mesh(entry.path(), {.metres_per_unit = 0.001}).mesh;
    const std::string name = entry.path().stem().string() + ".iv";
    const TriangleMesh own =
        load_mesh(test::shared("data/graspit_objects") / name, {.metres_per_unit = 0.001}).mesh;
    EXPECT_EQ(own.vertices.size(), converted.vertices.size());
    double farthest = 0.0;
    for (const Vector3& vertex : own.vertices) {
      double nearest = 1.0;
      for (const Vector3& other : converted.vertices) {
        nearest = std::min(nearest, (vertex - other).norm());
      }
      farthest = std::max(farthest, nearest);
    }
    EXPECT_LT(farthest, 1e-6);
  }
}

// Files that stand beside robots have their numbers in millimetres; those of the Fetch in metres.
TEST(InventorReference, LinksHaveTheBoxesOfGraspIt) {
  PREHEND_NEEDS_SHARED("reference/graspit/fk");
  PREHEND_NEEDS_SHARED("data/robots/graspit");
  int compared = 0;
  for (const char* robot :
       {"Barrett", "M7tool", "Puma560", "SimpleArm", "XR4000", "fetch_gripper"}) {
    const auto reference =
        json_file(test::shared("reference/graspit/fk") / (std::string(robot) + ".json"));
    std::vector<nlohmann::json> links = reference["links"];
    links.push_back(reference["palm"]);
    for (const nlohmann::json& link : links) {
      std::filesystem::path file =
          test::shared("data/robots/graspit") / link["file"].get<std::string>();
      file.replace_extension(std::string(robot) == "M7tool" ? ".wrl" : ".iv");
      SCOPED_TRACE(file.string());
      const double to_mm = std::string(robot) == "fetch_gripper" ? 1000.0 : 1.0;
      const LoadedMesh loaded = load_mesh(file, {.metres_per_unit = to_mm});
      const int all = static_cast<int>(loaded.mesh.triangles.size()) + loaded.degenerate_removed +
                      loaded.duplicates_removed;
      EXPECT_EQ(all, link["triangles"]);
      const Bounds box = bounds(loaded.mesh);
      EXPECT_LT((box.lower - vector_in(link["aabb_min"])).norm(), 2e-3);
      EXPECT_LT((box.upper - vector_in(link["aabb_max"])).norm(), 2e-3);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 27);
}

}  // namespace
}  // namespace prehend
