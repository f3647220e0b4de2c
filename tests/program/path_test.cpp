// Paths of an arm from the command line: what they write, and what is refused.
#include <fstream>
#include <string>
#include <yaml-cpp/yaml.h>

#include <gtest/gtest.h>

#include "tests/program/program.h"

namespace prehend::test {
namespace {

ProgramRun path(const std::string& words, const std::filesystem::path& out) {
  return run_program("path " + words + " --out " + out.string());
}

TEST(Path, ToAPostureByTheNamesOfTheDriver) {
  const std::filesystem::path out = fresh_folder("path_posture");
  const ProgramRun run = path("panda_on_table --to panda_joint1=0.5,panda_joint4=-1.5", out);
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("none collides"), std::string::npos) << run.out;
  EXPECT_EQ(content(out / "path.csv").find("time,segment,arm/joint1"), 0U);
  const YAML::Node file = YAML::LoadFile((out / "path_moveit.yaml").string());
  ASSERT_EQ(file.size(), 1U);
  const YAML::Node trajectory = file[0]["trajectory"]["joint_trajectory"];
  EXPECT_EQ(trajectory["joint_names"].size(), 7U);
  EXPECT_EQ(trajectory["joint_names"][0].as<std::string>(), "panda_joint1");
  const YAML::Node last = trajectory["points"][trajectory["points"].size() - 1];
  EXPECT_EQ(last["positions"][0].as<double>(), 0.5);
  EXPECT_EQ(last["positions"][3].as<double>(), -1.5);
}

TEST(Path, ScenesAndRequestsOfMoveItAreRead) {
  const std::filesystem::path folder = fresh_folder("path_moveit");
  std::ofstream(folder / "scene.yaml") << R"(
robot_model_name: panda
world:
  collision_objects:
    - id: post
      primitives: [{type: box, dimensions: [0.05, 0.05, 0.9]}]
      primitive_poses: [{position: [0.22, 0.22, 0.45], orientation: [0, 0, 0, 1]}]
)";
  std::ofstream(folder / "request.yaml") << R"(
start_state: {joint_state: {name: [panda_joint1], position: [0.1]}}
goal_constraints: [{joint_constraints: [{joint_name: panda_joint1, position: 1.5}]}]
)";
  const std::string scene = (folder / "scene.yaml").string();
  const ProgramRun run =
      path(scene + " --request " + (folder / "request.yaml").string(), folder / "out");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(content(folder / "out" / "path.csv").find("\n0.0,transfer,0.1,"),
            content(folder / "out" / "path.csv").find('\n'));
  // A failure leaves no path of another request.
  const ProgramRun blocked = path(scene + " --to panda_joint1=0.7854", folder / "out");
  EXPECT_EQ(blocked.status, 1);
  EXPECT_NE(blocked.out.find("goal_collides"), std::string::npos) << blocked.out;
  EXPECT_NE(blocked.out.find("meets post"), std::string::npos) << blocked.out;
  EXPECT_FALSE(std::filesystem::exists(folder / "out" / "path.csv"));
}

TEST(Path, InAStraightLineOfTheHand) {
  const std::filesystem::path out = fresh_folder("path_straight");
  const std::string goal =
      "--from 0,-0.785,0,-2.356,0,1.571,0.785 --frame panda_hand_tcp --straight ";
  const ProgramRun run = path("panda_on_table " + goal + "--to-pose 0.4,0.1,0.5,1,0,0,0", out);
  ASSERT_EQ(run.status, 0) << run.out << run.err;
  EXPECT_NE(run.out.find("along a straight line of the hand"), std::string::npos) << run.out;
  EXPECT_NE(content(out / "path.csv").find(",line,"), std::string::npos);
  const ProgramRun far = path("panda_on_table " + goal + "--to-pose 2,0.1,0.5,1,0,0,0", out);
  EXPECT_EQ(far.status, 1);
  EXPECT_NE(far.out.find("no path: unreachable (after "), std::string::npos) << far.out;
  const ProgramRun down = path("panda_on_table " + goal + "--to-pose 0.4,0,-0.1,1,0,0,0", out);
  EXPECT_EQ(down.status, 1);
  EXPECT_NE(down.out.find("no path: line_blocked ("), std::string::npos) << down.out;
  EXPECT_NE(down.out.find("meets table"), std::string::npos) << down.out;
}

TEST(Path, RefusesWhatItCannotAnswer) {
  const std::filesystem::path out = fresh_folder("path_refused");
  expect_refused(path("panda_on_table", out), "exactly one of --to, --to-pose and --request");
  expect_refused(path("panda_on_table --to 1,2", out), "2 values for 7 joints");
  expect_refused(path("panda_on_table --to panda_joint1=x", out), "not a number (x)");
  expect_refused(path("panda_on_table --to panda_joint1=1e30", out), "not a number");
  expect_refused(path("panda_on_table --to wheel=1", out), "none is of the arm");
  expect_refused(path("panda_on_table --to-pose 1,2,3", out), "x,y,z,qx,qy,qz,qw");
  expect_refused(path("panda_on_table --to-pose 1,2,3,0,0,0,0", out), "quaternion is zero");
  expect_refused(path("panda_on_table --to-pose 1,2,3,0,0,0,1 --frame nose", out),
                 "panda_hand_tcp");
  expect_refused(path("panda_on_table --to 0,0,0,0,0,0,0 --frame panda_hand", out), "--to-pose");
  expect_refused(path("panda_on_table --to 0,0,0,0,0,0,0 --straight", out), "--to-pose");
  expect_refused(path("mug --to 1", out), "no arm");
  expect_refused(path("panda_on_table --robot panda --to 1", out), "MoveIt");
}

}  // namespace
}  // namespace prehend::test
