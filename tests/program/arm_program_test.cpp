// The program on scenes with an arm: what it writes reads back and says the same in every format,
// and what it refuses.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>
#include <yaml-cpp/yaml.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.h"

namespace prehend::test {
namespace {

using nlohmann::json;

json library_scene(const std::string& name) {
  return json::parse(content(std::filesystem::path(PREHEND_SOURCE_DIR) / "benchmarks" / "scenes" /
                             (name + ".json")));
}

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

// Rows of a file without quoted cells.
std::vector<std::vector<std::string>> csv(const std::filesystem::path& file) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream stream(content(file));
  for (std::string line; std::getline(stream, line);) rows.push_back(cells(line));
  return rows;
}

// One plan for all tests of what was written; each process makes its own, in its own folder.
struct Written {
  std::filesystem::path folder = fresh_folder(
      std::string("arm_") + testing::UnitTest::GetInstance()->current_test_info()->name());
  ProgramRun run = run_program(
      "plan mug_on_table --path --export json,csv,isaac,moveit,gltf --top 3 --trials 240 "
      "--out " +
      folder.string());
  json grasps = json::parse(content(folder / "grasps.json"), nullptr, false);
};

class ArmExport : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(written().run.status, 0) << written().run.err;
    ASSERT_TRUE(written().grasps.is_object());
    ASSERT_EQ(written().grasps["grasps"].size(), 3U);
  }

  static const Written& written() {
    static const Written kWritten;
    return kWritten;
  }
  static const json& grasps() { return written().grasps; }
  static std::filesystem::path file(const std::string& name) { return written().folder / name; }
  static std::string path_name(std::size_t grasp, const std::string& end) {
    return "path_" + std::to_string(grasp + 1) + end;
  }
};

TEST_F(ArmExport, AllFilesAreWrittenAndNamed) {
  std::vector<std::string> names = {
      "grasps.json",  "grasps.csv", "grasps_isaac.yaml",         "grasps_moveit.yaml",
      "timings.json", "best.png",   "planning_scene_moveit.yaml"};
  for (std::size_t g = 0; g < 3; ++g) {
    names.push_back(path_name(g, ".csv"));
    names.push_back(path_name(g, "_moveit.yaml"));
    names.push_back("grasp_" + std::to_string(g + 1) + ".glb");
  }
  for (const std::string& name : names) {
    EXPECT_GT(content(file(name)).size(), 10U) << name;
    EXPECT_NE(written().run.out.find(name), std::string::npos) << name;
  }
}

TEST_F(ArmExport, TheGraspFileHoldsPathsAndObstacles) {
  EXPECT_EQ(grasps()["obstacles"], (json{"table", "floor"}));
  EXPECT_EQ(grasps()["robot"]["name"], "puma560_barrett");
  for (const json& grasp : grasps()["grasps"]) {
    EXPECT_EQ(grasp["outcome"], "stable");
    EXPECT_EQ(grasp["arm_dofs"].size(), grasps()["robot"]["dofs"].size());
    const json& path = grasp["path"];
    EXPECT_EQ(path.size(), 5U);
    EXPECT_EQ(path["joints"], grasps()["robot"]["joints"]);
    const std::size_t samples = path["times"].size();
    ASSERT_GT(samples, 10U);
    for (const char* rows : {"positions", "velocities"}) {
      ASSERT_EQ(path[rows].size(), samples) << rows;
      for (const json& row : path[rows]) ASSERT_EQ(row.size(), path["joints"].size()) << rows;
    }
    EXPECT_TRUE(std::is_sorted(path["times"].begin(), path["times"].end()));
    EXPECT_EQ(path["segments"].front()["first"], 0);
    EXPECT_EQ(path["segments"].back()["last"], samples - 1);
    ASSERT_TRUE(grasp.contains("lift"));
    const json& name = path["segments"].back()["name"];
    EXPECT_EQ(name, grasp["lift"] == "complete"          ? "retreat"
                    : grasp["lift"] == "retreat_blocked" ? "lift"
                                                         : "close");
  }
}

// The hand's joints, which are the last of the path, end where the grasp has them, and stay there
// while the object is carried.
TEST_F(ArmExport, APathEndsInItsGrasp) {
  for (const json& grasp : grasps()["grasps"]) {
    const json& last = grasp["path"]["positions"].back();
    const json& hand = grasp["joints"];
    ASSERT_GT(last.size(), hand.size());
    for (std::size_t j = 0; j < hand.size(); ++j) {
      EXPECT_NEAR(last[last.size() - hand.size() + j].get<double>(), hand[j].get<double>(), 1e-9);
    }
  }
}

TEST_F(ArmExport, PathsAsCsvAreThoseOfTheGraspFile) {
  for (std::size_t g = 0; g < 3; ++g) {
    const json& path = grasps()["grasps"][g]["path"];
    const auto rows = csv(file(path_name(g, ".csv")));
    const std::size_t joints = path["joints"].size();
    ASSERT_EQ(rows.size(), path["times"].size() + 1);
    for (std::size_t j = 0; j < joints; ++j) EXPECT_EQ(rows[0][2 + j], path["joints"][j]);
    for (std::size_t i = 1; i < rows.size(); ++i) {
      ASSERT_EQ(rows[i].size(), 2 + 2 * joints) << i;
      EXPECT_EQ(std::stod(rows[i][0]), path["times"][i - 1].get<double>());
      for (std::size_t j = 0; j < joints; ++j) {
        EXPECT_EQ(std::stod(rows[i][2 + j]), path["positions"][i - 1][j].get<double>());
        EXPECT_EQ(std::stod(rows[i][2 + joints + j]), path["velocities"][i - 1][j].get<double>());
      }
    }
  }
}

TEST_F(ArmExport, PathsForMoveItAreThoseOfTheGraspFile) {
  for (std::size_t g = 0; g < 3; ++g) {
    const json& path = grasps()["grasps"][g]["path"];
    const YAML::Node yaml = YAML::LoadFile(file(path_name(g, "_moveit.yaml")).string());
    std::size_t s = 0;
    for (const json& segment : path["segments"]) {
      if (s == yaml.size() || yaml[s]["segment"].as<std::string>() != segment["name"]) {
        // Left out: nothing moves in it.
        const std::size_t start = segment["first"];
        for (std::size_t i = start; i <= segment["last"].get<std::size_t>(); ++i) {
          EXPECT_EQ(path["positions"][i], path["positions"][start]);
        }
        continue;
      }
      const YAML::Node trajectory = yaml[s]["trajectory"]["joint_trajectory"];
      const auto names = trajectory["joint_names"].as<std::vector<std::string>>();
      const std::size_t first = segment["first"];
      ASSERT_EQ(trajectory["points"].size(), segment["last"].get<std::size_t>() - first + 1);
      for (std::size_t i = 0; i < trajectory["points"].size(); ++i) {
        const YAML::Node point = trajectory["points"][i];
        for (std::size_t k = 0; k < names.size(); ++k) {
          // The driver of the platform has no names of its own: those of its robots, alone.
          std::size_t joint = 0;
          while (path["joints"][joint].get<std::string>().find("/" + names[k]) ==
                 std::string::npos) {
            ASSERT_LT(++joint, path["joints"].size()) << names[k];
          }
          EXPECT_EQ(point["positions"][k].as<double>(),
                    path["positions"][first + i][joint].get<double>());
          EXPECT_EQ(point["velocities"][k].as<double>(),
                    path["velocities"][first + i][joint].get<double>());
        }
      }
      ++s;
    }
    EXPECT_EQ(s, yaml.size());
  }
}

TEST_F(ArmExport, GraspsInEveryFormatAreThoseOfTheGraspFile) {
  const auto rows = csv(file("grasps.csv"));
  const YAML::Node isaac = YAML::LoadFile(file("grasps_isaac.yaml").string())["grasps"];
  const YAML::Node moveit = YAML::LoadFile(file("grasps_moveit.yaml").string());
  ASSERT_EQ(rows.size(), 4U);
  ASSERT_EQ(isaac.size(), 3U);
  ASSERT_EQ(moveit.size(), 3U);
  for (std::size_t g = 0; g < 3; ++g) {
    const json& grasp = grasps()["grasps"][g];
    const json& p = grasp["X_object_hand"]["position"];
    const YAML::Node named = isaac["grasp_" + std::to_string(g)];
    const YAML::Node pose = moveit[g]["grasp_pose"]["pose"]["position"];
    EXPECT_EQ(std::stod(rows[g + 1][2]), grasp["epsilon"].get<double>());
    EXPECT_EQ(named["confidence"].as<double>(), grasp["epsilon"].get<double>());
    EXPECT_EQ(rows[g + 1].back(), path_name(g, ".csv"));
    double to_mount = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double expected = p[k].get<double>();
      EXPECT_EQ(std::stod(rows[g + 1][4 + k]), expected);
      EXPECT_EQ(named["position"][k].as<double>(), expected);
      to_mount += std::pow(pose[std::string(1, "xyz"[k])].as<double>() - expected, 2);
    }
    // The message has the frame of the arm that carries the hand, which robots/puma560_barrett puts
    // 175.05 mm behind the hand's own.
    EXPECT_NEAR(std::sqrt(to_mount), 0.17505, 1e-9);
  }
}

TEST_F(ArmExport, GraspsHoldWhenTheyAreEvaluatedAgain) {
  const std::filesystem::path again = fresh_folder("arm_evaluated");
  const ProgramRun run =
      run_program("evaluate " + file("grasps.json").string() + " --out " + again.string());
  ASSERT_EQ(run.status, 0) << run.err;
  const json evaluated = json::parse(content(again / "grasps.json"));
  ASSERT_EQ(evaluated["grasps"].size(), 3U);
  for (std::size_t g = 0; g < 3; ++g) {
    const json& grasp = evaluated["grasps"][g];
    EXPECT_EQ(grasp["outcome"], "stable");
    EXPECT_EQ(grasp["arm_dofs"].size(), grasps()["robot"]["dofs"].size());
    EXPECT_NEAR(grasp["epsilon"].get<double>(), grasps()["grasps"][g]["epsilon"].get<double>(),
                1e-3);
  }
}

TEST(ArmProgram, AnObjectFarAwayIsUnreachableWhichIsNoError) {
  const std::filesystem::path folder = fresh_folder("arm_far");
  json scene = library_scene("mug_on_table");
  scene["object"]["pose"]["position"][0] = 5.58;
  std::ofstream(folder / "in.json") << scene;
  const ProgramRun run = run_program("plan " + (folder / "in.json").string() + " --path --out " +
                                     (folder / "out").string());
  EXPECT_EQ(run.status, 0) << run.err;
  const json grasps = json::parse(content(folder / "out" / "grasps.json"));
  EXPECT_TRUE(grasps["grasps"].empty());
  int tried = 0;
  for (const auto& outcome : grasps["outcomes"]) tried += outcome.get<int>();
  EXPECT_GT(tried, 0);
  EXPECT_EQ(grasps["outcomes"]["unreachable"], tried);
  EXPECT_NE(run.out.find(std::to_string(tried) + " unreachable"), std::string::npos) << run.out;
  EXPECT_FALSE(std::filesystem::exists(folder / "out" / "best.png"));
}

// The library's mug on a table with one field changed.
struct BadScene {
  const char* name;
  const char* pointer;
  const char* value;
  const char* complaint;
};

void PrintTo(const BadScene& bad, std::ostream* stream) { *stream << bad.name; }

// The fingers touch where the path begins.
TEST(ArmStart, AClosedGripperOpensOnItsWay) {
  const std::filesystem::path folder = fresh_folder("arm_closed_start");
  std::ofstream(folder / "in.json") << R"({
      "object": {"geometry": [{"shape": "box", "size": [0.04, 0.05, 0.08]}],
                 "pose": {"position": [0.45, 0.1, 0.0401]}},
      "robot": {"platform": "panda", "pose": {"position": [0, 0, 0.001]},
                "start": {"hand/opening": 0}},
      "obstacles": [{"name": "table", "pose": {"position": [0.3, 0, -0.02]},
                     "geometry": [{"shape": "box", "size": [1.6, 1.2, 0.04]}]}]})";
  const ProgramRun run = run_program("plan " + (folder / "in.json").string() +
                                     " --path --accuracy draft --trials 60 --enough 1 --top 1 "
                                     "--no-report --out " +
                                     (folder / "out").string());
  ASSERT_EQ(run.status, 0) << run.err;
  const json grasps = json::parse(content(folder / "out" / "grasps.json"));
  ASSERT_EQ(grasps["grasps"].size(), 1U) << run.out;
  const json& path = grasps["grasps"][0]["path"];
  EXPECT_EQ(path["segments"][0]["name"], "preshape");
  EXPECT_EQ(path["positions"][0].back(), 0.0);
}

class BadArmScene : public testing::TestWithParam<BadScene> {};

TEST_P(BadArmScene, OneLineAndNothingWritten) {
  const std::filesystem::path folder = fresh_folder(std::string("bad_arm_") + GetParam().name);
  json scene = library_scene("mug_on_table");
  scene[json::json_pointer(GetParam().pointer)] = json::parse(GetParam().value);
  std::ofstream(folder / "in.json") << scene;
  const ProgramRun run = run_program("plan " + (folder / "in.json").string() + " --path --out " +
                                     (folder / "out").string());
  expect_refused(run, GetParam().complaint);
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

INSTANTIATE_TEST_SUITE_P(
    Corpus, BadArmScene,
    testing::Values(BadScene{"MissingPlatform", "/robot/platform", R"("tentacle")",
                             "in.json: robot.platform: neither a file nor one of allegro, "},
                    BadScene{"MissingMesh", "/obstacles/1",
                             R"({"name": "floor", "mesh": "nowhere.obj"})", "nowhere.obj"},
                    BadScene{"ObjectInAnObstacle", "/object/pose/position", "[0.58, 0.05, 0.71]",
                             "mug overlaps the obstacle table"},
                    BadScene{"StartInCollision", "/robot/pose/position", "[0.3, 0, 0.6868]",
                             "collides with table"},
                    BadScene{"StartOutsideLimits", "/robot/start", R"({"arm/waist": 9})",
                             "in.json: robot.start.arm/waist: outside the limits"},
                    BadScene{"UnknownDof", "/robot/start", R"({"arm/thumb": 0})",
                             "no degree of freedom is called arm/thumb"},
                    BadScene{"NoHand", "/robot/platform", R"("puma560")", "none is a hand"}),
    [](const auto& bad) { return std::string(bad.param.name); });

// Arm and hand in one URDF file, whose base stands 5 mm in the table.
TEST(ArmStart, AnArmAndAHandInOneUrdfFileGetPaths) {
  const std::filesystem::path folder = fresh_folder("arm_bare_urdf");
  const auto box = [](const char* name, const char* size, const char* xyz) {
    return std::string("<link name='") + name + "'><collision><origin xyz='" + xyz +
           "'/><geometry><box size='" + size + "'/></geometry></collision></link>";
  };
  const auto joint = [](const char* name, const char* parent, const char* child, const char* xyz,
                        const char* axis) {
    return std::string("<joint name='") + name + "' type='revolute'><parent link='" + parent +
           "'/><child link='" + child + "'/><origin xyz='" + xyz + "'/><axis xyz='" + axis +
           "'/><limit lower='-3' upper='3' effort='50' velocity='2'/></joint>";
  };
  const auto finger = [](const char* name, const char* link, const char* axis) {
    return std::string("<joint name='") + name +
           "' type='prismatic'><parent link='palm'/><child link='" + link +
           "'/><origin xyz='0 0 0.05'/><axis xyz='" + axis +
           "'/><limit lower='0' upper='0.035' effort='20' velocity='0.1'/>" +
           (std::string(name) == "g2" ? "<mimic joint='g1'/>" : "") + "</joint>";
  };
  std::ofstream(folder / "arm.urdf")
      << "<robot name='arm'>" << box("base", "0.1 0.1 0.105", "0 0 0.0475")
      << box("l1", "0.06 0.06 0.08", "0 0 0.05") << box("l2", "0.05 0.05 0.3", "0 0 0.2")
      << box("l3", "0.05 0.05 0.2", "0 0 0.15") << box("l4", "0.04 0.04 0.06", "0 0 0.05")
      << box("l5", "0.04 0.04 0.05", "0 0 0.04") << box("palm", "0.1 0.04 0.03", "0 0 0.03")
      << box("fa", "0.01 0.02 0.06", "0.005 0 0.03") << box("fb", "0.01 0.02 0.06", "-0.005 0 0.03")
      << joint("q1", "base", "l1", "0 0 0.1", "0 0 1")
      << joint("q2", "l1", "l2", "0 0 0.1", "0 1 0") << joint("q3", "l2", "l3", "0 0 0.4", "0 1 0")
      << joint("q4", "l3", "l4", "0 0 0.3", "0 0 1") << joint("q5", "l4", "l5", "0 0 0.1", "0 1 0")
      << joint("q6", "l5", "palm", "0 0 0.08", "0 0 1") << finger("g1", "fa", "1 0 0")
      << finger("g2", "fb", "-1 0 0") << "</robot>";
  std::ofstream(folder / "in.json") << R"({
      "object": {"geometry": [{"shape": "box", "size": [0.04, 0.05, 0.08]}],
                 "pose": {"position": [0.4, 0, 0.0395]}},
      "robot": {"platform": "arm.urdf"},
      "obstacles": [{"name": "table", "pose": {"position": [0.3, 0, -0.02]},
                     "geometry": [{"shape": "box", "size": [1.6, 1.2, 0.04]}]}]})";
  const ProgramRun run = run_program("plan " + (folder / "in.json").string() +
                                     " --path --accuracy draft --trials 200 --enough 1 --top 1 "
                                     "--no-report --out " +
                                     (folder / "out").string());
  ASSERT_EQ(run.status, 0) << run.err;
  const json grasps = json::parse(content(folder / "out" / "grasps.json"));
  EXPECT_EQ(grasps["grasps"].size(), 1U) << run.out;
  EXPECT_NE(run.err.find("base stands in table"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("is sunk into table by 0.5"), std::string::npos) << run.err;
  // A mesh alone does not say where it lies.
  const ProgramRun bare = run_program("plan mug --hand " + (folder / "arm.urdf").string() +
                                      " --path --out " + (folder / "none").string());
  EXPECT_EQ(bare.status, 2);
  EXPECT_NE(bare.err.find("has an arm, but nothing says where it stands"), std::string::npos)
      << bare.err;
}

struct BadWords {
  const char* name;
  const char* words;
  const char* complaint;
};

void PrintTo(const BadWords& bad, std::ostream* stream) { *stream << bad.name; }

class BadArmWords : public testing::TestWithParam<BadWords> {};

TEST_P(BadArmWords, OneLineAndNothingWritten) {
  const std::filesystem::path folder = fresh_folder(std::string("bad_words_") + GetParam().name);
  const ProgramRun run =
      run_program(std::string(GetParam().words) + " --out " + (folder / "out").string());
  expect_refused(run, GetParam().complaint);
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

INSTANTIATE_TEST_SUITE_P(
    Corpus, BadArmWords,
    testing::Values(BadWords{"PathWithoutAnArm", "plan mug --path", "no arm to plan paths for"},
                    BadWords{"UnknownFormat", "plan mug_on_table --export csv,stl", "stl"},
                    BadWords{"UnknownPlanner", "plan mug_on_table --path --path-planner teleport",
                             "teleport"},
                    BadWords{"UnknownScene", "plan mug_on_chair --path", "mug_on_chair"},
                    BadWords{"UnknownHand", "plan mug_on_table --hand tentacle", "tentacle"}),
    [](const auto& bad) { return std::string(bad.param.name); });

}  // namespace
}  // namespace prehend::test
