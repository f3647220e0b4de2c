// Commands that write files, each with small inputs, and what a run of one may leave behind.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.h"
#include "tests/support/file_tree.h"

namespace prehend::test {

using FileTree = std::map<std::string, std::string>;

// A command that writes below the folder `out` of its home.
struct WritingCommand {
  std::string name;
  std::string words;  // OUT and HOME stand for the folders
};

inline std::ostream& operator<<(std::ostream& stream, const WritingCommand& command) {
  return stream << command.name;
}

inline const char* const kFaultBatch = R"({
  "objects": ["meshes/"], "hands": ["parallel_jaw"],
  "settings": [{"accuracy": "draft", "trials": 12}], "seeds": [1, 2]})";

inline const char* const kFaultTruth = R"({
  "format": "prehend truth 1", "hand": "parallel_jaw",
  "objects": [{"name": "mug", "scene": "mug"}],
  "executions": [
    {"object": "mug", "lifted": true, "preshape": "open",
     "X_object_hand": {"position": [-0.05, 0, 0.13], "quaternion_wxyz": [0, 1, 0, 0]}},
    {"object": "mug", "lifted": false, "preshape": "open",
     "X_object_hand": {"position": [-0.05, 0, 0.17], "quaternion_wxyz": [0, 1, 0, 0]}}]})";

inline const char* const kFaultContacts = R"({"contacts": [
  {"position": [0.1, 0, 0], "normal": [-1, 0, 0], "friction": 0.5},
  {"position": [0, 0.1, 0], "normal": [0, -1, 0], "friction": 0.5},
  {"position": [0, 0, 0.1], "normal": [0, 0, -1], "friction": 0.5},
  {"position": [-0.1, 0, 0], "normal": [1, 0, 0], "friction": 0.5}]})";

inline const char* const kFaultScene = R"({
  "object": {"name": "cube", "geometry": [{"shape": "box", "size": [0.05, 0.05, 0.05]}]},
  "hand": "parallel_jaw"})";

inline const char* const kFaultGrasps = R"({
  "scene": "cube.json",
  "grasps": [{"X_object_hand": {"position": [0.004, 0, 0.06], "quaternion_wxyz": [0, 1, 0, 0]},
              "preshape": "open",
              "approach": {"direction": [0, 0, -1], "distance": 0.05, "travel": 0.05}}]})";

inline const char* const kFaultSession =
    "{\"command\": \"scene.new\", \"hand\": \"parallel_jaw\"}\n"
    "{\"command\": \"object.set\", \"generate\": \"ball\"}\n"
    "{\"command\": \"hand.back_off\"}\n";

inline std::vector<WritingCommand> writing_commands() {
  return {
      {"plan",
       "plan HOME/cube.json --accuracy draft --trials 12 --top 1 --threads 1 --export csv --out "
       "OUT"},
      {"evaluate", "evaluate HOME/grasps.json --threads 1 --out OUT"},
      {"path", "path panda_on_table --to panda_joint1=0.2 --threads 1 --out OUT"},
      {"simulate", "simulate HOME/grasps.json --threads 1 --frames 2 --csv all --out OUT"},
      {"render", "render HOME/grasps.json --frames 1 --out OUT"},
      {"inspect", "inspect barrett --picture OUT/hand.png"},
      {"save", "inspect HOME/cube.json --save OUT/scene.json"},
      {"convert", "convert barrett OUT/hand.urdf"},
      {"quality", "quality HOME/contacts.json --project force --out OUT"},
      {"truth",
       "truth HOME/truth.json --resamples 20 --accuracy draft --no-volumes --threads 1 --out OUT"},
      {"replay", "replay HOME/session.jsonl --out OUT/replay.json --gltf OUT/session.glb"},
      {"batch", "batch HOME/batch.json --threads 1 -o OUT"},
      {"merge", "batch merge HOME/batch.json --threads 1 --pictures 1 -o OUT"},
      {"learn", "learn HOME/done/merged/acronym -o OUT/model.json"}};
}

inline void write_fault_inputs(const std::filesystem::path& home) {
  std::filesystem::create_directories(home / "meshes");
  std::ofstream(home / "meshes/cube.obj") << kBoxObj;
  std::ofstream(home / "batch.json") << kFaultBatch;
  std::ofstream(home / "truth.json") << kFaultTruth;
  std::ofstream(home / "contacts.json") << kFaultContacts;
  std::ofstream(home / "cube.json") << kFaultScene;
  std::ofstream(home / "grasps.json") << kFaultGrasps;
  std::ofstream(home / "session.jsonl") << kFaultSession;
}

inline std::string replaced(std::string text, const std::string& word, const std::string& by) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at)) {
    text.replace(at, word.size(), by);
    at += by.size();
  }
  return text;
}

// Times are not the same twice; of such a file only that it is whole.
inline bool has_times(const std::string& file) { return file.ends_with("timings.json"); }

// Each file is one of the results or as it was before, and there is none beside these.
inline void expect_whole(const FileTree& found, const FileTree& results, const FileTree& before) {
  for (const auto& [name, bytes] : found) {
    if (has_times(name) && results.contains(name)) {
      EXPECT_TRUE(nlohmann::json::accept(bytes) || before.contains(name)) << name;
      continue;
    }
    const auto result = results.find(name);
    const auto earlier = before.find(name);
    EXPECT_TRUE((result != results.end() && result->second == bytes) ||
                (earlier != before.end() && earlier->second == bytes))
        << name << " is neither the result nor what was there before";
  }
}

inline void expect_same(FileTree found, FileTree results) {
  std::erase_if(found, [](const auto& file) { return has_times(file.first); });
  std::erase_if(results, [](const auto& file) { return has_times(file.first); });
  ASSERT_EQ(found.size(), results.size());
  for (const auto& [name, bytes] : results) {
    EXPECT_TRUE(found.contains(name) && found.at(name) == bytes) << name;
  }
}

}  // namespace prehend::test
