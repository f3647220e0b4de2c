// Files of an earlier run must not stand beside grasps that they are not about.
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "tests/program/program.h"
#include "tests/program/running_program.h"

namespace prehend::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

ProgramRun plan_into(const fs::path& out, const std::string& words) {
  const std::string scene = (fs::path(PREHEND_SOURCE_DIR) / "benchmarks/scenes/mug.json").string();
  const ProgramRun run =
      run_program("plan " + scene + " --trials 40 --out '" + out.string() + "' " + words);
  EXPECT_EQ(run.status, 0) << run.err;
  return run;
}

TEST(EarlierFiles, OfMoreExportsAndMoreGraspsAreRemoved) {
  const fs::path out = fresh_folder("earlier_exports");
  plan_into(out, "--top 3 --export csv,isaac,moveit,gltf,mjcf");
  EXPECT_TRUE(fs::exists(out / "grasp_3.glb"));
  EXPECT_TRUE(fs::exists(out / "grasp_3.xml"));
  std::ofstream(out / "notes.txt") << "mine";
  std::ofstream(out / "path_7.csv") << "of an earlier run";
  plan_into(out, "--top 1 --no-report --export csv,gltf");
  EXPECT_EQ(names_in(out), (std::vector<std::string>{"grasp_1.glb", "grasps.csv", "grasps.json",
                                                     "notes.txt", "timings.json"}));
}

TEST(EarlierFiles, ThatTheNewRunWritesAsWellAreNew) {
  const fs::path out = fresh_folder("earlier_same");
  for (const char* name : {"report.html", "best.png", "grasps.csv"}) {
    std::ofstream(out / name) << "of an earlier run";
  }
  plan_into(out, "--top 1 --export csv");
  for (const char* name : {"report.html", "best.png", "grasps.csv"}) {
    EXPECT_NE(content(out / name), "of an earlier run") << name;
  }
}

TEST(EarlierFiles, AreNotFollowedThroughLinks) {
  const fs::path out = fresh_folder("earlier_links");
  const fs::path kept = fresh_folder("earlier_kept") / "report.html";
  std::ofstream(kept) << "mine";
  fs::create_symlink(kept, out / "report.html");
  plan_into(out, "--top 1 --no-report");
  EXPECT_TRUE(fs::is_symlink(out / "report.html"));
  EXPECT_EQ(content(kept), "mine");
}

TEST(EarlierFiles, OfPlanAreRemovedByEvaluate) {
  const fs::path out = fresh_folder("earlier_evaluated");
  plan_into(out, "--top 1 --export gltf");
  const ProgramRun run = run_program("evaluate " + (out / "grasps.json").string() +
                                     " --no-report --out '" + out.string() + "'");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(names_in(out), (std::vector<std::string>{"grasps.json", "timings.json"}));
}

TEST(EarlierFiles, AreRemovedByARunThatIsInterrupted) {
  const fs::path folder = fresh_folder("earlier_interrupted");
  const fs::path out = folder / "grasps";
  fs::create_directories(out);
  for (const char* name : {"report.html", "best.png", "best_arm.png", "path_1.csv",
                           "path_1_moveit.yaml", "grasp_001.png", "notes.txt"}) {
    std::ofstream(out / name) << "of an earlier run";
  }
  RunningProgram program(
      {"plan", "living_room", "--path", "--threads", "1", "--progress", "--out", out.string()},
      folder);
  ASSERT_TRUE(program.wait_for_line("trials 0 of "));
  ASSERT_TRUE(program.wait_for_line("trials "));
  program.send(SIGINT);
  std::string rest;
  EXPECT_EQ(program.wait(rest), 130);
  EXPECT_EQ(names_in(out), (std::vector<std::string>{"grasps.json", "notes.txt", "timings.json"}));
}

TEST(EarlierFiles, StayWhereNothingIsWritten) {
  const fs::path out = fresh_folder("earlier_refused");
  std::ofstream(out / "report.html") << "of an earlier run";
  EXPECT_EQ(run_program("plan nothing --out '" + out.string() + "'").status, 2);
  EXPECT_TRUE(fs::exists(out / "report.html"));
}

}  // namespace
}  // namespace prehend::test
