// What the program says where no grasp holds.
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.h"

namespace prehend::test {
namespace {

ProgramRun plan_scene(const std::filesystem::path& folder, const std::string& scene,
                      const std::string& words) {
  std::ofstream(folder / "scene.json") << scene;
  return run_program("plan " + (folder / "scene.json").string() + " --out " +
                     (folder / "out").string() + " " + words);
}

// A plate that lies on a table.
const char* const kPlate =
    R"({"object": {"geometry": [{"shape": "cylinder", "radius": 0.11, "height": 0.02}],
                   "pose": {"position": [0, 0, 0.0101]}},
        "hand": "parallel_jaw",
        "obstacles": [{"name": "table", "geometry": [{"shape": "box", "size": [1, 1, 0.1]}],
                       "pose": {"position": [0, 0, -0.05]}}]})";

TEST(NoGrasp, IsExplainedInTheTerminalTheFileAndTheReport) {
  const std::filesystem::path folder = fresh_folder("no_grasp_plate");
  const ProgramRun run = plan_scene(folder, kPlate, "");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("no grasp holds; by rule:\n  cylinder side, thumb along: "),
            std::string::npos)
      << run.out;
  const std::string words = "the obstacle table is in the way: without it, ";
  EXPECT_NE(run.out.find("what may help:\n  " + words), std::string::npos) << run.out;
  const auto grasps = nlohmann::json::parse(content(folder / "out" / "grasps.json"));
  EXPECT_EQ(grasps["advice"][0]["hint"], "obstacle");
  EXPECT_EQ(grasps["advice"][0]["words"].get<std::string>().find(words), 0U);
  EXPECT_NE(content(folder / "out" / "report.html").find(words), std::string::npos);
}

TEST(NoGrasp, WhereNothingCouldBeTriedIsOneLineWithAnotherHand) {
  const std::filesystem::path folder = fresh_folder("no_grasp_wide");
  const std::string scene =
      R"({"object": {"geometry": [{"shape": "box", "size": [0.12, 0.12, 0.12]}]},
          "hand": "parallel_jaw"})";
  const ProgramRun run = plan_scene(folder, scene, "");
  expect_refused(run, "the hand opens to 80 mm; try --hand ");
  const std::string start = "try --hand ";
  const std::size_t at = run.err.find(start) + start.size();
  const std::string hand = run.err.substr(at, run.err.find(',', at) - at);
  const ProgramRun other = plan_scene(folder, scene, "--no-report --hand " + hand);
  EXPECT_EQ(other.status, 0) << other.err;
  EXPECT_EQ(other.out.find("no grasp holds"), std::string::npos) << other.out;
}

TEST(NoGrasp, TheFolderTellsOfTheObjectThatFailedNotOfAnEarlierOne) {
  const std::filesystem::path folder = fresh_folder("no_grasp_after_one");
  const std::string cube = R"({"object": {"geometry": [{"shape": "box", "size": [SIZE]}]},
                               "hand": "parallel_jaw"})";
  const auto of_size = [&](const std::string& size) {
    std::string scene = cube;
    return scene.replace(scene.find("SIZE"), 4, size);
  };
  const std::string words = "--trials 20 --export csv,gltf";
  ASSERT_EQ(plan_scene(folder, of_size("0.05, 0.05, 0.05"), words).status, 0);
  const std::filesystem::path out = folder / "out";
  std::ofstream(out / "notes.txt") << "of the user";
  for (const char* file : {"best.png", "grasps.csv", "report.html"}) {
    EXPECT_TRUE(std::filesystem::exists(out / file)) << file;
  }
  expect_refused(plan_scene(folder, of_size("0.2, 0.2, 0.2"), "--trials 20"), "no grasp to try");
  std::set<std::string> left;
  for (const auto& entry : std::filesystem::directory_iterator(out)) {
    left.insert(entry.path().filename().string());
  }
  EXPECT_EQ(left,
            (std::set<std::string>{"grasps.json", "notes.txt", "report.html", "timings.json"}));
  const auto grasps = nlohmann::json::parse(content(out / "grasps.json"));
  EXPECT_EQ(grasps["status"], "object_too_large");
  EXPECT_TRUE(grasps["grasps"].empty());
  EXPECT_NE(content(out / "report.html").find(R"("problem":"object: no grasp to try with hand)"),
            std::string::npos);
}

TEST(NoGrasp, SaysNothingOfTheKindWhereThereIsOne) {
  const std::filesystem::path folder = fresh_folder("no_grasp_held");
  const ProgramRun run =
      plan_scene(folder, R"({"object": {"geometry": [{"shape": "box", "size": [0.05, 0.05, 0.05]}]},
                  "hand": "parallel_jaw"})",
                 "--no-report --trials 20 --primitive-tolerance 3.4641");
  EXPECT_EQ(run.status, 0) << run.err;
  // One more was found by the refinement.
  EXPECT_NE(run.out.find("21 tried: "), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("may help"), std::string::npos) << run.out;
  const auto grasps = nlohmann::json::parse(content(folder / "out" / "grasps.json"));
  // The cube's diagonal is 86.6 mm long.
  EXPECT_NEAR(grasps["settings"]["primitive_tolerance"], 0.04, 1e-6);
  EXPECT_EQ(grasps["settings"]["trials"], 20);
}

}  // namespace
}  // namespace prehend::test
