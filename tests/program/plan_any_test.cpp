// plan --any, and what grasp files say of the choice of an object and its regions.
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.h"

namespace prehend::test {
namespace {

using nlohmann::json;

// Two blocks side by side, and one under a lid in a pit.
const char* const kBlocks = R"({"hand": "parallel_jaw", "objects": [
    {"name": "free", "geometry": [{"shape": "box", "size": [0.04, 0.04, 0.06]}],
     "pose": {"position": [1, 0, 0]}},
    {"name": "under", "geometry": [{"shape": "box", "size": [0.04, 0.04, 0.06]}],
     "pose": {"position": [0, 0, -0.07]}},
    {"name": "lid", "geometry": [{"shape": "box", "size": [0.25, 0.13, 0.02]}]}],
  "obstacles": [
    {"name": "north", "geometry": [{"shape": "box", "size": [0.3, 0.02, 0.3]}],
     "pose": {"position": [0, 0.08, 0.05]}},
    {"name": "south", "geometry": [{"shape": "box", "size": [0.3, 0.02, 0.3]}],
     "pose": {"position": [0, -0.08, 0.05]}},
    {"name": "east", "geometry": [{"shape": "box", "size": [0.02, 0.12, 0.3]}],
     "pose": {"position": [0.14, 0, 0.05]}},
    {"name": "west", "geometry": [{"shape": "box", "size": [0.02, 0.12, 0.3]}],
     "pose": {"position": [-0.14, 0, 0.05]}},
    {"name": "floor", "geometry": [{"shape": "box", "size": [0.3, 0.18, 0.02]}],
     "pose": {"position": [0, 0, -0.111]}}]})";

json json_of(const std::filesystem::path& file) { return json::parse(content(file)); }

TEST(PlanAnyProgram, RanksAllAndSaysWhatMustGoFirst) {
  const std::filesystem::path folder = fresh_folder("plan_any");
  std::ofstream(folder / "in.json") << kBlocks;
  const std::string words =
      "plan " + (folder / "in.json").string() + " --any --no-report --trials 60 --top 3 --out ";
  const ProgramRun run = run_program(words + (folder / "out").string() + " --threads 1");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("lid must go first"), std::string::npos) << run.out;
  const json any = json_of(folder / "out/any.json");
  EXPECT_EQ(any["objects"].size(), 3U);
  EXPECT_EQ(any["objects"][1]["first"], json::array({"lid"}));
  EXPECT_EQ(any["ranked"][0]["object"], "free");
  const json own = json_of(folder / "out/free/grasps.json");
  EXPECT_EQ(own["scene"]["object"], "free");
  EXPECT_EQ(own["grasps"][0]["epsilon"], any["ranked"][0]["epsilon"]);
  const ProgramRun again = run_program(words + (folder / "two").string() + " --threads 2");
  EXPECT_EQ(again.status, 0) << again.err;
  for (const char* file : {"any.json", "free/grasps.json", "under/grasps.json"}) {
    EXPECT_EQ(content(folder / "out" / file), content(folder / "two" / file)) << file;
  }
}

TEST(PlanAnyProgram, AGraspFileSaysWhichObjectAndWhichRegions) {
  const std::filesystem::path folder = fresh_folder("plan_choice");
  std::ofstream(folder / "in.json") << kBlocks;
  const ProgramRun run = run_program("plan " + (folder / "in.json").string() +
                                     " --object free --keep-out -50,-50,0:50,50,50 --no-report "
                                     "--trials 60 --top 3 --out " +
                                     (folder / "out").string());
  EXPECT_EQ(run.status, 0) << run.err;
  const json written = json_of(folder / "out/grasps.json");
  EXPECT_EQ(written["scene"]["keep_out"][0]["inside"]["shape"], "box");
  for (const json& grasp : written["grasps"]) {
    for (const json& contact : grasp["contacts"]) EXPECT_LT(contact["position"][2], 0.0);
  }
  const ProgramRun judged = run_program("evaluate " + (folder / "out/grasps.json").string() +
                                        " --no-report --out " + (folder / "judged").string());
  EXPECT_EQ(judged.status, 0) << judged.err;
  EXPECT_EQ(json_of(folder / "judged/grasps.json")["scene"], written["scene"]);
}

TEST(PlanAnyProgram, TheHandKeepsApartFromOtherObjects) {
  const std::filesystem::path folder = fresh_folder("plan_apart");
  std::ofstream(folder / "in.json") << R"({"hand": "parallel_jaw", "objects": [
    {"name": "left", "geometry": [{"shape": "box", "size": [0.03, 0.04, 0.1]}]},
    {"name": "right", "geometry": [{"shape": "box", "size": [0.03, 0.04, 0.1]}],
     "pose": {"position": [0.055, 0, 0]}}]})";
  const auto planned = [&](const std::string& apart) {
    const ProgramRun run = run_program("plan " + (folder / "in.json").string() +
                                       " --object left --no-report --trials 100 --apart " + apart +
                                       " --out " + (folder / apart).string());
    EXPECT_EQ(run.status, 0) << run.err;
    return json_of(folder / apart / "grasps.json");
  };
  const json near = planned("0");
  EXPECT_FALSE(near["scene"].contains("apart"));
  const json far = planned("0.01");
  EXPECT_EQ(far["scene"]["apart"], 0.01);
  EXPECT_LT(far["outcomes"]["stable"], near["outcomes"]["stable"]);
  EXPECT_EQ(far["blockers"][0]["by"], "right") << far["blockers"];
  const ProgramRun wrong =
      run_program("plan " + (folder / "in.json").string() + " --apart 2 --out " + folder.string());
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("apart"), std::string::npos) << wrong.err;
}

}  // namespace
}  // namespace prehend::test
