// Sets of grasps that others published, evaluated. tests/python/test_datasets.py has those in HDF5.
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.h"

namespace prehend::test {
namespace {

// A cube with edges of two units, about the origin.
const std::string kTwoUnitCube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 1 3 2\nf 1 4 3\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\n"
    "f 4 1 5\nf 4 5 8\n";

// From below at three distances: with the cube between the fingers, in the hand, and far away.
const std::string kThreeGrasps = R"({
  "object": {"file": "cube.obj", "scale": 0.02},
  "grasps": {"transforms": [
    [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, -0.11], [0, 0, 0, 1]],
    [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, -0.05], [0, 0, 0, 1]],
    [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, -1.0], [0, 0, 0, 1]]],
    "object_in_gripper": [true, false, true]}})";

class DataSetProgram : public testing::Test {
 protected:
  DataSetProgram() {
    write("cube.obj", kTwoUnitCube);
    write("set.json", kThreeGrasps);
  }

  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }

  ProgramRun evaluate(const std::string& file, const std::string& words) const {
    return run_program("evaluate '" + (folder_ / file).string() + "' " + words +
                       " --no-report --accuracy draft --volumes 0 --out '" +
                       (folder_ / "out").string() + "'");
  }

  nlohmann::json grasps() const {
    return nlohmann::json::parse(content(folder_ / "out" / "grasps.json")).at("grasps");
  }

  std::filesystem::path folder_ = fresh_folder("data_set_program");
};

TEST_F(DataSetProgram, IsTriedInItsSizeAndComparedWithItsLabels) {
  const ProgramRun run = evaluate("set.json", "--hand franka_hand");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("labels of the file: 2 of 3 agree (66.7 %); held there and here 1, there "
                         "only 1, here only 0, neither 1\n"),
            std::string::npos)
      << run.out;
  const nlohmann::json first = grasps();
  ASSERT_EQ(first.size(), 3U);
  EXPECT_EQ(first[0]["outcome"], "stable");
  EXPECT_EQ(first[1]["outcome"], "hand_blocked");
  EXPECT_EQ(first[2]["outcome"], "no_contact");
  // grasps.json stands for itself: its scene has the object in its size.
  const ProgramRun again = evaluate("out/grasps.json", "");
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(grasps()[0]["epsilon"], first[0]["epsilon"]);
  EXPECT_EQ(again.out.find("labels"), std::string::npos);
}

TEST_F(DataSetProgram, TakesASceneInThePlaceOfTheMesh) {
  const std::string mesh = "--hand franka_hand --scene '" + (folder_ / "cube.obj").string() + "'";
  ASSERT_EQ(evaluate("set.json", mesh).status, 0);
  const nlohmann::json first = grasps();
  write("scene.json",
        R"({"object": {"geometry": [{"shape": "box", "size": [0.04, 0.04, 0.04]}]}})");
  const std::string scene =
      "--hand franka_hand --scene '" + (folder_ / "scene.json").string() + "'";
  ASSERT_EQ(evaluate("set.json", scene).status, 0);
  EXPECT_EQ(grasps()[0]["outcome"], first[0]["outcome"]);
  EXPECT_NEAR(grasps()[0]["epsilon"], first[0]["epsilon"], 1e-9);
}

TEST_F(DataSetProgram, SaysWhatIsMissing) {
  expect_refused(evaluate("set.json", ""), "names no hand: name one with --hand");
  std::filesystem::remove(folder_ / "cube.obj");
  expect_refused(evaluate("set.json", "--hand franka_hand"), "name it with --scene (cube.obj)");
  write("set.h5", "\x89HDF\r\n\x1a\n and nothing that HDF5 knows");
  expect_refused(evaluate("set.h5", "--hand franka_hand"), "is no HDF5 file, or a damaged one");
}

}  // namespace
}  // namespace prehend::test
