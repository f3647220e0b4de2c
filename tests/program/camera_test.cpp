// Plans from what a depth camera saw, and what is refused of it.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.h"
#include "tests/sim/shape/cloud/files/written_cloud.h"
#include "tests/support/depth_images.h"

namespace prehend::test {
namespace {

using nlohmann::json;

const std::vector<StandingBox> kTable = {{{0.05, 0.05, 0.12}, 0.0, 0.0},
                                         {{0.04, 0.04, 0.06}, 0.18, 0.05}};

json json_in(const std::filesystem::path& file) { return json::parse(content(file)); }

// The folder, with views.json of one image.
std::filesystem::path seen_table(const std::string& name) {
  const std::filesystem::path folder = fresh_folder(name);
  const DepthCamera camera = camera_at({0.45, -0.35, 0.45}, {0.05, 0.0, 0.03}, kSmallImage);
  const DepthView view = view_of(kTable, camera);
  write_png(folder / "a.png", view);
  std::ofstream(folder / "a.json") << camera_json(camera);
  std::ofstream(folder / "views.json") << R"({"depth": "a.png", "camera": "a.json"})";
  const Vector3 p = camera.X_WC.translation();
  std::ofstream(folder / "a.pcd", std::ios::binary)
      << pcd_file(columns_of(points_of(view)), "binary_compressed", 0,
                  std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
                      std::to_string(p.z()) + " 1 0 0 0");
  return folder;
}

const std::string kFew =
    " --hand franka_hand --no-report --trials 150 --top 5 --accuracy draft --out ";

TEST(CameraProgram, PlansFromOneImage) {
  const std::filesystem::path folder = seen_table("camera_image");
  const std::string words = "plan " + (folder / "views.json").string() + kFew;
  const ProgramRun run = run_program(words + (folder / "out").string() + " --threads 1");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.err.find("the support is a plane"), std::string::npos) << run.err;
  EXPECT_NE(run.out.find("also hold on the thin and the thick shape"), std::string::npos)
      << run.out;
  const json grasps = json_in(folder / "out/grasps.json");
  ASSERT_FALSE(grasps["grasps"].empty());
  const json& best = grasps["grasps"][0];
  EXPECT_TRUE(best["shapes"]["likely"]);
  EXPECT_GE(best["shapes"]["held"], 1);
  for (const json& contact : best["contacts"]) EXPECT_TRUE(contact["seen"].is_boolean());
  const ProgramRun again = run_program(words + (folder / "two").string() + " --threads 2");
  EXPECT_EQ(content(folder / "out/grasps.json"), content(folder / "two/grasps.json"));
  // The file can be judged again, with the same scene.
  const ProgramRun judged = run_program("evaluate " + (folder / "out/grasps.json").string() +
                                        " --no-report --out " + (folder / "judged").string());
  EXPECT_EQ(judged.status, 0) << judged.err;
}

TEST(CameraProgram, PlansFromACloudTheThingThatIsAskedFor) {
  const std::filesystem::path folder = seen_table("camera_cloud");
  const ProgramRun run = run_program("plan " + (folder / "a.pcd").string() + " --object 2" + kFew +
                                     (folder / "out").string());
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(json_in(folder / "out/grasps.json")["object"]["name"], "object2");
}

TEST(CameraProgram, PlansWhicheverThing) {
  const std::filesystem::path folder = seen_table("camera_any");
  const ProgramRun run = run_program("plan " + (folder / "a.png").string() + " --any" + kFew +
                                     (folder / "out").string());
  ASSERT_EQ(run.status, 0) << run.err;
  const json any = json_in(folder / "out/any.json");
  EXPECT_EQ(any["objects"].size(), 2U);
  EXPECT_TRUE(std::filesystem::exists(folder / "out/object2/grasps.json"));
}

void expect_plan_refused(const std::filesystem::path& file, const std::string& complaint,
                         const std::string& options = "") {
  const std::filesystem::path out = file.parent_path() / "out";
  expect_refused(run_program("plan " + file.string() + options + " --out " + out.string()),
                 complaint);
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(CameraProgram, WhatIsNoViewIsRefused) {
  const std::filesystem::path folder = seen_table("camera_bad");
  const auto cloud = [&](const std::vector<Vector3>& points) {
    std::ofstream(folder / "bad.pcd", std::ios::binary)
        << pcd_file(columns_of(points), "binary", points.size(), "0 0 0 1 0 0 0");
    return folder / "bad.pcd";
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_plan_refused(cloud({{0.0, 0.0, 1.0}}), "bad.pcd: only 1 readings");
  expect_plan_refused(cloud(std::vector<Vector3>(50, {nan, nan, nan})),
                      "bad.pcd: no reading: none of the 50 points is finite");
  std::vector<Vector3> plane;
  std::vector<Vector3> in_millimetres;
  for (int i = 0; i < 100; ++i) {
    for (int k = 0; k < 100; ++k) plane.emplace_back(0.005 * i - 0.25, 0.005 * k - 0.25, 0.8);
  }
  for (const Vector3& p : plane) in_millimetres.push_back(1000.0 * p);
  expect_plan_refused(cloud(plane), "bad.pcd: ");
  expect_plan_refused(cloud(in_millimetres), "bad.pcd: unit: distances look like millimetres");
  expect_plan_refused(folder / "views.json", "no such thing was seen", " --object 7");
  expect_plan_refused(folder / "views.json",
                      "views.json: unit: a scene says the units of its meshes itself",
                      " --unit mm");
  std::ofstream(folder / "large.pcd")
      << "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 20000000\n"
         "HEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 20000000\nDATA binary\n";
  expect_plan_refused(folder / "large.pcd",
                      "large.pcd: more points than the 10,000,000 that are read together");
  std::ofstream(folder / "empty.ply") << "ply\nformat ascii 1.0\nelement vertex 0\nproperty float "
                                         "x\nproperty float y\nproperty float z\nend_header\n";
  expect_plan_refused(folder / "empty.ply", "empty.ply: only 0 readings");
}

}  // namespace
}  // namespace prehend::test
