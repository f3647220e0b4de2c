// Simulations from the command line: which files they write, and what is refused.
#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.h"

namespace prehend::test {
namespace {

using nlohmann::json;

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

// A cube on a table, and a grasp of it with the jaw from above.
std::filesystem::path cube_on_table(const std::string& name) {
  const std::filesystem::path folder = fresh_folder(name);
  std::ofstream(folder / "cube.json") << R"({
    "object": {"name": "cube", "geometry": [{"shape": "box", "size": [0.05, 0.05, 0.05]}]},
    "hand": "parallel_jaw",
    "obstacles": [{"name": "table", "pose": {"position": [0, 0, -0.0351]},
                   "geometry": [{"shape": "box", "size": [0.6, 0.6, 0.02]}]}]})";
  std::ofstream(folder / "grasps.json") << R"({
    "scene": "cube.json",
    "grasps": [{"X_object_hand": {"position": [0.004, 0, 0.06], "quaternion_wxyz": [0, 1, 0, 0]},
                "preshape": "open",
                "approach": {"direction": [0, 0, -1], "distance": 0.05, "travel": 0.05}}]})";
  return folder;
}

ProgramRun simulate(const std::filesystem::path& what, const std::filesystem::path& out,
                    const std::string& words = "") {
  return run_program("simulate " + what.string() + " --out " + out.string() + " " + words);
}

TEST(Simulate, WritesStatesQuantitiesAndAReport) {
  const std::filesystem::path folder = cube_on_table("simulate_files");
  const std::filesystem::path out = folder / "out";
  const ProgramRun run =
      simulate(folder / "grasps.json", out, "--csv time,cube.x,parallel_jaw/left --frames 2");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("held after"), std::string::npos) << run.out;
  const json file = json::parse(std::ifstream(out / "simulation.json"));
  EXPECT_EQ(file["end"], "held");
  EXPECT_EQ(file["events"][0]["event"], "touched");
  EXPECT_EQ(file["simulation"]["not_converged"], 0);
  const json& states = file["states"];
  ASSERT_GT(states.size(), 10U);
  EXPECT_EQ(states.front()["time"], 0.0);
  // The jaw is 4 mm off, and pushes the cube to its middle.
  const double x = states.back()["bodies"]["cube"]["position"][0];
  EXPECT_NEAR(x, 0.004, 5e-4);
  EXPECT_FALSE(states.back()["contacts"].empty());
  const std::string table = text_of(out / "states.csv");
  EXPECT_EQ(table.substr(0, table.find('\n')), "time,cube.x,parallel_jaw/left");
  EXPECT_NE(text_of(out / "report.html").find("What happened"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(out / "moment_002.png"));
}

TEST(Simulate, ShakesAGraspAsAProtocolSays) {
  const std::filesystem::path folder = cube_on_table("simulate_protocol");
  const ProgramRun run =
      simulate(folder / "grasps.json", folder / "out", "--protocol strength --test up --no-report");
  ASSERT_EQ(run.status, 2) << run.out;
  EXPECT_NE(run.err.find("no such test in protocol strength"), std::string::npos) << run.err;
  const ProgramRun lifts =
      simulate(folder / "grasps.json", folder / "out", "--protocol simready --no-report");
  ASSERT_EQ(lifts.status, 0) << lifts.err;
  EXPECT_NE(lifts.out.find("the hand has lifted it"), std::string::npos) << lifts.out;
}

TEST(Simulate, GivesTheSameBytesOnAnyNumberOfThreads) {
  const std::filesystem::path folder = fresh_folder("simulate_threads");
  for (const std::string threads : {"1", "2"}) {
    const ProgramRun run = simulate("wine_glass_on_its_side", folder / threads,
                                    "--seconds 1.2 --csv all --no-report --threads " + threads);
    ASSERT_EQ(run.status, 0) << run.err;
  }
  for (const char* name : {"simulation.json", "states.csv"}) {
    EXPECT_EQ(text_of(folder / "1" / name), text_of(folder / "2" / name)) << name;
  }
}

TEST(Simulate, RefusesWhatItCannotDoInOneLine) {
  const std::filesystem::path folder = cube_on_table("simulate_refused");
  const std::string grasps = (folder / "grasps.json").string();
  const std::string out = " --out " + (folder / "out").string();
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"simulate " + (folder / "cube.json").string(), "nothing says where the hand begins"},
      {"simulate " + grasps + " --grasp 2", "there are 1 grasps"},
      {"simulate " + grasps + " --step 10", "--step"},
      {"simulate " + grasps + " --step 0", "--step"},
      {"simulate " + grasps + " --every 0", "--every"},
      {"simulate " + grasps + " --csv cube.color", "no such quantity; there are cube.x"},
      {"simulate " + grasps + " --protocol nonsense", "no protocol of that name"},
      {"simulate nothing_of_that_name", "nothing_of_that_name"},
      {"plan mug_on_table --dynamic --path", "--path: not together with --dynamic"}};
  for (const auto& [words, expected] : cases) {
    const ProgramRun run = run_program(words + out);
    EXPECT_EQ(run.status, 2) << words;
    EXPECT_NE(run.err.find(expected), std::string::npos) << words << "\n" << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
}

TEST(Simulate, TrialsMayBeDynamic) {
  const std::filesystem::path folder = cube_on_table("simulate_dynamic");
  const ProgramRun run = run_program("evaluate " + (folder / "grasps.json").string() +
                                     " --dynamic --no-report --out " + (folder / "out").string());
  ASSERT_EQ(run.status, 0) << run.err;
  const json file = json::parse(std::ifstream(folder / "out" / "grasps.json"));
  const json& grasp = file["grasps"][0];
  EXPECT_EQ(grasp["outcome"], "stable");
  EXPECT_NEAR(grasp["X_object_moved"]["position"][0].get<double>(), 0.004, 5e-4);
  // The result can be read again.
  const ProgramRun again = run_program("evaluate " + (folder / "out" / "grasps.json").string() +
                                       " --no-report --out " + (folder / "again").string());
  EXPECT_EQ(again.status, 0) << again.err;
}

}  // namespace
}  // namespace prehend::test
