#include "planner/show/exports/result_files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace prehend {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& file) { std::ofstream(file) << "of an earlier run"; }

fs::path fresh(const std::string& name) {
  const fs::path folder = fs::path(testing::TempDir()) / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

TEST(ResultFiles, AreKnownByTheirWholeNames) {
  for (const char* name : {"grasps.json", "report.html", "path_1.csv", "path_12_moveit.yaml",
                           "grasp_10.glb", "grasp_2.xml", "grasps_isaac.yaml", "best_arm.png"}) {
    EXPECT_TRUE(is_result_file(name)) << name;
    EXPECT_FALSE(is_rendered_file(name)) << name;
  }
  for (const char* name : {"grasp_001.png", "approach_003_frame_08.png", "contact_sheet.png"}) {
    EXPECT_TRUE(is_rendered_file(name)) << name;
    EXPECT_FALSE(is_result_file(name)) << name;
  }
  for (const char* name : {"", "grasps.json.bak", "my_grasps.json", "path_.csv", "path_1.csv2",
                           "path_1b.csv", "path_#.csv", "grasp_1.png.part12", "notes.txt",
                           "Report.html", "grasp_-1.glb", "approach_1_frame_.png"}) {
    EXPECT_FALSE(is_result_file(name)) << name;
    EXPECT_FALSE(is_rendered_file(name)) << name;
  }
}

TEST(ResultFiles, OfEarlierRunsAreRemovedAndAllElseStays) {
  const fs::path folder = fresh("earlier_results");
  for (const char* name : {"grasps.json", "report.html", "best.png", "path_3.csv", "grasp_2.glb",
                           "grasp_001.png", "notes.txt", "mesh.obj"}) {
    write(folder / name);
  }
  fs::create_directories(folder / "path_4.csv");
  const fs::path elsewhere = fresh("earlier_elsewhere") / "best_arm.png";
  write(elsewhere);
  fs::create_symlink(elsewhere, folder / "best_arm.png");
  remove_earlier_results(folder, {"grasps.json"}, {});
  EXPECT_EQ(names_in(folder), (std::vector<std::string>{"best_arm.png", "grasps.json", "mesh.obj",
                                                        "notes.txt", "path_4.csv"}));
  EXPECT_TRUE(fs::exists(elsewhere));
}

TEST(ResultFiles, ThatTheRunReadStay) {
  const fs::path folder = fresh("earlier_inputs");
  for (const char* name : {"grasp_1.glb", "grasp_2.glb", "grasp_3.glb", "grasp_4.glb"}) {
    write(folder / name);
  }
  Scene scene;
  scene.object.source = MeshFileSource{(folder / "grasp_1.glb").string(), "m"};
  StaticBody table;
  table.source = MeshFileSource{(folder / "." / "grasp_2.glb").string(), "m"};
  scene.obstacles = {table};
  remove_earlier_results(folder, {}, scene, folder / "grasp_3.glb");
  EXPECT_EQ(names_in(folder),
            (std::vector<std::string>{"grasp_1.glb", "grasp_2.glb", "grasp_3.glb"}));
}

}  // namespace
}  // namespace prehend
