// Ctrl-C: what was found is written, nothing is left half written.
#include <algorithm>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.h"
#include "tests/program/running_program.h"

namespace prehend::test {
namespace {

using nlohmann::json;

std::filesystem::path own_folder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return fresh_folder(std::string("interrupt_") + test->name());
}

// Names of the files in a folder that need not exist.
std::vector<std::string> files_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  if (!std::filesystem::exists(folder)) return names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

// A scene that takes far longer to load than it takes the program to start the thread that waits
// for signals.
const char* const kSlowScene = R"({"object": {"generate": "mug", "triangles": 1000000}})";

// The lines of stderr that are not progress.
std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.find(" of ") == std::string::npos || line.starts_with("prehend"))
      lines.push_back(line);
  }
  return lines;
}

void expect_one_line(const std::string& rest, const std::string& words) {
  const std::vector<std::string> lines = words_of(rest);
  ASSERT_EQ(lines.size(), 1U) << rest;
  EXPECT_TRUE(lines[0].starts_with("prehend: interrupted")) << rest;
  EXPECT_NE(lines[0].find(words), std::string::npos) << rest;
}

TEST(Interrupt, OfPlanWritesTheGraspsThatWereFound) {
  const std::filesystem::path folder = own_folder();
  const std::filesystem::path out = folder / "grasps";
  std::filesystem::create_directories(out);
  std::ofstream(out / "report.html") << "of an earlier run";
  RunningProgram program(
      {"plan", "living_room", "--path", "--threads", "1", "--progress", "--out", out.string()},
      folder);
  ASSERT_TRUE(program.wait_for_line("trials 0 of "));
  ASSERT_TRUE(program.wait_for_line("trials "));
  program.send(SIGINT);
  std::string rest;
  EXPECT_EQ(program.wait(rest), 130);
  expect_one_line(rest, "candidates were tried; no report, no pictures");
  EXPECT_EQ(files_in(out), (std::vector<std::string>{"grasps.json", "timings.json"}));
  const json grasps = json::parse(content(out / "grasps.json"));
  EXPECT_EQ(grasps["status"], "cancelled");
  EXPECT_GT(grasps["untested"], 0);
  int tried = 0;
  for (const auto& [outcome, count] : grasps["outcomes"].items()) tried += count.get<int>();
  EXPECT_GT(tried, 0);
  EXPECT_NE(content(folder / "out").find(" tried: "), std::string::npos);
}

TEST(Interrupt, OfPlanBeforeTheFirstTrialWritesNothing) {
  const std::filesystem::path folder = own_folder();
  const std::filesystem::path scene = folder / "scene.json";
  std::ofstream(scene) << kSlowScene;
  RunningProgram program({"plan", scene.string(), "--out", (folder / "grasps").string()}, folder);
  ASSERT_TRUE(program.wait_for_threads(2));
  program.send(SIGINT);
  std::string rest;
  EXPECT_EQ(program.wait(rest), 130);
  expect_one_line(rest, "nothing is written");
  EXPECT_TRUE(files_in(folder / "grasps").empty());
}

TEST(Interrupt, BySigtermSaysSoInItsStatus) {
  const std::filesystem::path folder = own_folder();
  const std::filesystem::path out = folder / "grasps";
  RunningProgram program({"plan", "living_room", "--progress", "--out", out.string()}, folder);
  ASSERT_TRUE(program.wait_for_line("trials 0 of "));
  ASSERT_TRUE(program.wait_for_line("trials "));
  program.send(SIGTERM);
  std::string rest;
  EXPECT_EQ(program.wait(rest), 143);
  EXPECT_EQ(json::parse(content(out / "grasps.json"))["status"], "cancelled");
}

// A second one may come while the first is being obeyed, or be one with it.
TEST(Interrupt, TwiceLeavesNoPartsOfFiles) {
  const std::filesystem::path folder = own_folder();
  const std::filesystem::path out = folder / "grasps";
  RunningProgram program({"plan", "living_room", "--progress", "--out", out.string()}, folder);
  ASSERT_TRUE(program.wait_for_line("trials 0 of "));
  ASSERT_TRUE(program.wait_for_line("trials "));
  program.send(SIGINT);
  program.send(SIGINT);
  std::string rest;
  EXPECT_EQ(program.wait(rest), 130);
  for (const std::string& name : files_in(out)) {
    EXPECT_EQ(name.find(".part"), std::string::npos) << name;
  }
}

TEST(Interrupt, OfEvaluateWritesNothing) {
  const std::filesystem::path folder = own_folder();
  const std::filesystem::path file = folder / "asked.json";
  json asked{{"scene", "shelf"}, {"grasps", json::array()}};
  for (int i = 0; i < 5000; ++i) {
    asked["grasps"].push_back(
        {{"X_object_hand",
          {{"position", {0.0, 0.0, 0.25 + 1e-6 * i}}, {"quaternion_wxyz", {0.0, 1.0, 0.0, 0.0}}}},
         {"dofs", {0.0, 0.0, 0.0, 0.0}}});
  }
  std::ofstream(file) << asked.dump();
  RunningProgram program({"evaluate", file.string(), "--threads", "1", "--progress", "--out",
                          (folder / "evaluated").string()},
                         folder);
  ASSERT_TRUE(program.wait_for_line("trials 0 of 5000"));
  program.send(SIGINT);
  std::string rest;
  EXPECT_EQ(program.wait(rest), 130);
  expect_one_line(rest, "nothing is written");
  EXPECT_TRUE(files_in(folder / "evaluated").empty());
}

class InterruptedReader : public testing::TestWithParam<const char*> {};

// The command reads what takes long: a scene, or contacts whose wrench space has very many facets.
std::vector<std::string> slow_words(const std::string& command,
                                    const std::filesystem::path& folder) {
  const std::string scene = (folder / "scene.json").string();
  const std::string grasps = (folder / "grasps.json").string();
  const std::string contacts = (folder / "contacts.json").string();
  std::ofstream(scene) << kSlowScene;
  std::ofstream(grasps) << json{{"scene", scene}, {"grasps", json::array()}};
  std::ofstream(contacts) << R"({"contacts": [
      {"position": [0.1, 0, 0], "normal": [-1, 0, 0], "friction": 0.5},
      {"position": [0, 0.1, 0], "normal": [0, -1, 0], "friction": 0.5},
      {"position": [0, 0, 0.1], "normal": [0, 0, -1], "friction": 0.5},
      {"position": [-0.1, 0, 0], "normal": [1, 0, 0], "friction": 0.5}]})";
  if (command == "quality") return {command, contacts, "--cone", "pyramid:300"};
  return {command, command == "inspect" ? scene : grasps};
}

TEST_P(InterruptedReader, EndsAtOnce) {
  const std::filesystem::path folder = fresh_folder(std::string("interrupt_") + GetParam());
  RunningProgram program(slow_words(GetParam(), folder), folder);
  ASSERT_TRUE(program.wait_for_threads(2));
  program.send(SIGINT);
  std::string rest;
  EXPECT_EQ(program.wait(rest), 130);
  expect_one_line(rest, "nothing is written");
  EXPECT_EQ(content(folder / "out"), "");
}

INSTANTIATE_TEST_SUITE_P(Commands, InterruptedReader,
                         testing::Values("evaluate", "render", "inspect", "quality"),
                         [](const auto& command) { return std::string(command.param); });

TEST(Interrupt, OfRenderLeavesWholePicturesOnly) {
  const std::filesystem::path folder = own_folder();
  const std::filesystem::path out = folder / "pictures";
  const std::filesystem::path file = folder / "asked.json";
  json asked{{"scene", "shelf"}, {"grasps", json::array()}};
  for (int i = 0; i < 200; ++i) {
    asked["grasps"].push_back(
        {{"X_object_hand",
          {{"position", {0.0, 0.0, 0.25}}, {"quaternion_wxyz", {0.0, 1.0, 0.0, 0.0}}}},
         {"dofs", {0.0, 0.0, 0.0, 0.0}}});
  }
  std::ofstream(file) << asked.dump();
  RunningProgram program({"render", file.string(), "--out", out.string()}, folder);
  const auto is_whole = [](const std::string& name) { return name.ends_with(".png"); };
  for (bool drawn = false; !drawn;) {
    const std::vector<std::string> names = files_in(out);
    drawn = std::any_of(names.begin(), names.end(), is_whole);
    ASSERT_FALSE(program.has_ended());
    ::usleep(1000);
  }
  program.send(SIGINT);
  std::string rest;
  EXPECT_EQ(program.wait(rest), 130);
  expect_one_line(rest, "pictures that were drawn are written");
  const std::vector<std::string> names = files_in(out);
  EXPECT_LT(names.size(), 200U);
  for (const std::string& name : names) {
    ASSERT_TRUE(is_whole(name)) << name;
    const std::string bytes = content(out / name);
    ASSERT_GT(bytes.size(), 8U);
    EXPECT_EQ(bytes.substr(bytes.size() - 8, 4), "IEND") << name;
  }
}

// Far below what it takes to load a scene on any machine.
TEST(Limits, ABudgetThatLoadingUsesUpEndsInOneLine) {
  const std::filesystem::path folder = own_folder();
  const ProgramRun run = run_program("plan living_room --path --budget 0.1ms --out '" +
                                     (folder / "out").string() + "'");
  EXPECT_EQ(run.status, 124);
  EXPECT_EQ(run.err, "prehend: the budget is used up, nothing is written\n");
}

// More trials than fit into the budget on any machine, and enough time for one of them.
TEST(Limits, ABudgetLeavesAllFilesOfWhatWasTried) {
  const std::filesystem::path folder = own_folder();
  const std::filesystem::path out = folder / "out";
  const ProgramRun run =
      run_program("plan mug --trials 1000000 --budget 6s --out '" + out.string() + "'");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("out of time: "), std::string::npos) << run.out;
  EXPECT_EQ(files_in(out),
            (std::vector<std::string>{"best.png", "grasps.json", "report.html", "timings.json"}));
  const json grasps = json::parse(content(out / "grasps.json"));
  EXPECT_EQ(grasps["status"], "out_of_time");
  EXPECT_FALSE(grasps["grasps"].empty());
  int tried = 0;
  for (const auto& [outcome, count] : grasps["outcomes"].items()) tried += count.get<int>();
  // A refinement may have added a few.
  EXPECT_GE(tried + grasps["untested"].get<int>(), 1000000);
  EXPECT_LE(tried + grasps["untested"].get<int>(), 1000004);
  // The file is as good as that of a complete plan.
  const ProgramRun again = run_program("evaluate '" + (out / "grasps.json").string() +
                                       "' --no-report --out '" + (folder / "again").string() + "'");
  EXPECT_EQ(again.status, 0) << again.err;
}

TEST(Limits, MemoryEndsInOneLine) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer reserves more memory than any limit leaves";
#endif
  const std::filesystem::path folder = own_folder();
  const ProgramRun run = run_program("plan mug --no-report --memory-limit 20 --out '" +
                                     (folder / "out").string() + "'");
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.err,
            "prehend: not enough memory: allow more (--memory-limit), or use fewer threads "
            "(--threads)\n");
}

}  // namespace
}  // namespace prehend::test
