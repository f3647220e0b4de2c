// `prehend truth`: scores of grasps that were executed, and what became of these.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.h"
#include "tests/program/running_program.h"

namespace prehend::test {
namespace {

using nlohmann::json;

// The parallel gripper over the rim of the mug, ever higher: the lower ones lifted it.
json rim_grasps(int count) {
  json executions = json::array();
  for (int i = 0; i < count; ++i) {
    executions.push_back({{"object", "mug"},
                          {"session", i % 2 == 0 ? "monday" : "tuesday"},
                          {"X_object_hand",
                           {{"position", {-0.05, 0.0, 0.13 + 0.08 * i / count}},
                            {"quaternion_wxyz", {0.0, 1.0, 0.0, 0.0}}}},
                          {"preshape", "open"},
                          {"lifted", 2 * i < count}});
  }
  return executions;
}

json sample(int count) {
  return {{"format", "prehend truth 1"},
          {"hand", "parallel_jaw"},
          {"objects", {{{"name", "mug"}, {"scene", "mug"}}}},
          {"executions", rim_grasps(count)}};
}

std::filesystem::path written(const json& file) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = fresh_folder(std::string("truth_") + test->name());
  std::ofstream(folder / "truth.json") << file;
  return folder;
}

std::string words_for(const std::filesystem::path& folder, const std::string& out) {
  return "truth " + (folder / "truth.json").string() + " --resamples 50 --accuracy draft --out " +
         (folder / out).string();
}

TEST(ValidateCommand, ComparesScoresWithWhatBecameOfTheGrasps) {
  const std::filesystem::path folder = written(sample(12));
  const ProgramRun run = run_program(words_for(folder, "out"));
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(run.out.find("12 executions of 1 object in 2 sessions: 6 lifted, 6 failed\n"), 0U)
      << run.out;
  EXPECT_NE(run.out.find("resamples of 2 sessions; so few make them too narrow"),
            std::string::npos);
  const json report = json::parse(content(folder / "out" / "truth.json"));
  EXPECT_EQ(report.at("format"), "prehend truth report 1");
  EXPECT_EQ(report.at("settings").at("groups"), "session");
  EXPECT_EQ(report.at("scores").size(), 10U);
  for (const json& score : report.at("scores")) {
    EXPECT_GE(score.at("auc"), 0.0) << score.at("name");
    EXPECT_LE(score.at("auc"), 1.0) << score.at("name");
  }
  // The highest hands close above the mug.
  EXPECT_GT(report.at("outcomes").at("no_contact"), 0);
  EXPECT_GT(report.at("frames").at("object").at("beside"), 0);
  EXPECT_GT(report.at("scores").at(1).at("auc"), 0.5);
  EXPECT_EQ(content(folder / "out" / "truth.html").find("<!DOCTYPE html>"), 0U);
}

TEST(ValidateCommand, WritesTheSameBytesOnAnyNumberOfThreads) {
  const std::filesystem::path folder = written(sample(8));
  const ProgramRun one = run_program(words_for(folder, "one") + " --threads 1");
  const ProgramRun two = run_program(words_for(folder, "two") + " --threads 2");
  ASSERT_EQ(one.status, 0) << one.err;
  ASSERT_EQ(two.status, 0) << two.err;
  for (const char* file : {"truth.json", "truth.html"}) {
    EXPECT_EQ(content(folder / "one" / file), content(folder / "two" / file)) << file;
  }
}

TEST(ValidateCommand, LeavesOutWhatIsNotWanted) {
  const std::filesystem::path folder = written(sample(4));
  const ProgramRun run =
      run_program(words_for(folder, "out") + " --no-volumes --no-report --groups each");
  ASSERT_EQ(run.status, 0) << run.err;
  const json report = json::parse(content(folder / "out" / "truth.json"));
  EXPECT_EQ(report.at("scores").size(), 9U);
  EXPECT_EQ(report.at("groups_drawn"), 4);
  EXPECT_FALSE(std::filesystem::exists(folder / "out" / "truth.html"));
}

// A scene beside the file, and a hand of its own.
TEST(ValidateCommand, LooksForScenesBesideTheFile) {
  json file = sample(4);
  file["objects"][0] = {{"name", "mug"}, {"scene", "my_mug.json"}, {"hand", "parallel_jaw"}};
  file.erase("hand");
  const std::filesystem::path folder = written(file);
  std::ofstream(folder / "my_mug.json") << R"({"object": {"generate": "mug"}})";
  const ProgramRun run = run_program(words_for(folder, "out"));
  EXPECT_EQ(run.status, 0) << run.err;
}

TEST(ValidateCommand, RefusesMistakesInOneLineAndWritesNothing) {
  const auto refused = [](const json& file, const std::string& complaint,
                          const std::string& words = "") {
    const std::filesystem::path folder = written(file);
    const ProgramRun run = run_program(words_for(folder, "out") + words);
    expect_refused(run, complaint);
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  };
  json file = sample(4);
  file["executions"][2]["object"] = "cup";
  refused(file, "truth.json: executions[2].object: is none of the file's objects (\"cup\")");
  file = sample(4);
  file["objects"][0]["scene"] = "none.obj";
  refused(file, "none.obj");
  file = sample(4);
  file["executions"] = json::array();
  refused(file, "truth.json: executions: must not be empty");
  file["executions"] = rim_grasps(1);
  refused(file,
          "truth.json: executions: none of them failed, nothing can be compared (lifted 1 of 1)");
  file = sample(4);
  file["executions"][1]["X_object_hand"]["position"][0] = nullptr;
  refused(file, "executions[1].X_object_hand.position");
  refused(sample(4), "--resamples", " --resamples 0");
  refused(sample(4), "--groups", " --groups hand");
  expect_refused(run_program("truth /no/such/file.json"), "/no/such/file.json");
}

TEST(ValidateCommand, InterruptedWritesNothing) {
  const std::filesystem::path folder = written(sample(5000));
  RunningProgram program({"truth", (folder / "truth.json").string(), "--threads", "1", "--progress",
                          "--out", (folder / "compared").string()},
                         folder);
  ASSERT_TRUE(program.wait_for_line("trials 0 of 5000"));
  program.send(SIGINT);
  std::string rest;
  EXPECT_EQ(program.wait(rest), 130);
  EXPECT_NE(rest.find("prehend: interrupted, nothing is written\n"), std::string::npos) << rest;
  EXPECT_FALSE(std::filesystem::exists(folder / "compared"));
}

}  // namespace
}  // namespace prehend::test
