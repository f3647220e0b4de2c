// The program carries out recorded sessions again.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.h"

namespace prehend::test {
namespace {

TEST(Replay, ARecordingGivesTheSameFileEachTime) {
  const std::filesystem::path folder = fresh_folder("replay");
  const std::filesystem::path recording = folder / "session.jsonl";
  std::ofstream(recording) << R"({"command": "scene.new", "hand": "parallel_jaw"})"
                           << "\n"
                           << R"({"command": "object.set", "generate": "ball"})"
                           << "\n"
                           << R"({"command": "hand.approach"})"
                           << "\n"
                           << R"({"id": 7, "command": "hand.auto_grasp"})"
                           << "\n"
                           << R"({"command": "plan.start", "trials": 20})"
                           << "\n"
                           << R"({"recorded": "plan.finished"})"
                           << "\n"
                           << R"({"command": "scene.save", "file": "ball.json"})"
                           << "\n"
                           << R"({"command": "scene.save", "file": "../ball.json"})"
                           << "\n";
  const std::string words = "replay " + recording.string() + " --folder " + folder.string();
  const ProgramRun once = run_program(words + " --out " + (folder / "a/one.json").string());
  ASSERT_EQ(once.status, 0) << once.err;
  EXPECT_NE(once.out.find("7 commands, 1 refused"), std::string::npos) << once.out;
  const ProgramRun again =
      run_program(words + " --threads 1 --out " + (folder / "two.json").string());
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(content(folder / "a/one.json"), content(folder / "two.json"));
  const auto replayed = nlohmann::json::parse(content(folder / "two.json"));
  EXPECT_EQ(replayed["replies"][3]["id"], 7);
  EXPECT_EQ(replayed["replies"][3]["result"]["outcome"], "stable");
  EXPECT_EQ(replayed["scene"], content(folder / "ball.json"));
  // The scene file that was saved is one that the program reads.
  EXPECT_EQ(run_program("inspect " + (folder / "ball.json").string()).status, 0);
}

TEST(Replay, WritesAnAnimationOnDemand) {
  const std::filesystem::path folder = fresh_folder("replay_gltf");
  const std::filesystem::path recording = folder / "session.jsonl";
  std::ofstream(recording) << R"({"command": "object.set", "generate": "ball"})"
                           << "\n"
                           << R"({"command": "hand.back_off"})"
                           << "\n";
  const std::string words =
      "replay " + recording.string() + " --out " + (folder / "replay.json").string() + " --gltf ";
  const std::filesystem::path film = folder / "films" / "session.glb";
  const ProgramRun once = run_program(words + film.string());
  ASSERT_EQ(once.status, 0) << once.err;
  EXPECT_NE(once.out.find("wrote " + film.string()), std::string::npos) << once.out;
  EXPECT_EQ(content(film).substr(0, 4), "glTF");
  ASSERT_EQ(run_program(words + (folder / "again.glb").string()).status, 0);
  EXPECT_EQ(content(film), content(folder / "again.glb"));
  expect_refused(run_program(words + (folder / "session.gltf").string()), "must end in .glb");
}

TEST(Replay, MistakesAreNamedAndNothingIsWritten) {
  const std::filesystem::path folder = fresh_folder("replay_bad");
  const std::filesystem::path recording = folder / "session.jsonl";
  const std::filesystem::path out = folder / "out.json";
  std::ofstream(recording) << "{\"command\": \"state\"}\nnonsense\n";
  expect_refused(run_program("replay " + recording.string() + " --out " + out.string()),
                 "session.jsonl: line 2: ");
  expect_refused(run_program("replay " + (folder / "none").string()), "no such file");
  expect_refused(
      run_program("replay " + recording.string() + " --folder " + (folder / "none").string()),
      "folder: no such folder");
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace prehend::test
