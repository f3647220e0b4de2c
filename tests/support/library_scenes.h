// Scenes of the library for tests: compiled, or as JSON that a test changes and loads again.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/base/random.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/scene_file.h"

namespace prehend::test {

// The file of a scene of the library in the source tree.
inline std::filesystem::path library_scene(const std::string& name) {
  return std::filesystem::path(PREHEND_SOURCE_DIR) / "benchmarks" / "scenes" / (name + ".json");
}

// The content of that file.
inline nlohmann::json scene_json(const std::string& name) {
  return nlohmann::json::parse(std::ifstream(library_scene(name)));
}

// Writes the scene to a file whose name contains that of the running test, because tests run in
// parallel, and returns its path.
inline std::filesystem::path write_scene(const nlohmann::json& scene) {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(info->test_suite_name()) + "_" + info->name();
  std::replace(name.begin(), name.end(), '/', '_');
  const std::filesystem::path file = testing::TempDir() + "/arm_scene_" + name + ".json";
  std::ofstream(file) << scene.dump(1);
  return file;
}

// The library scene of that name, ready for trials.
inline CompiledScene compiled_library_scene(const std::string& name) {
  return compile(load_scene(library_scene(name)));
}

// The scene with that JSON, written to a file, loaded and compiled.
inline CompiledScene compiled_scene(const nlohmann::json& scene) {
  return compile(load_scene(write_scene(scene)));
}

// An obstacle of a scene file: a box of `size` [m] with its centre `at` [m] in the world's frame.
inline nlohmann::json box_obstacle(const std::string& name, const Vector3& size,
                                   const Vector3& at) {
  return {{"name", name},
          {"pose", {{"position", {at.x(), at.y(), at.z()}}}},
          {"geometry", {{{"shape", "box"}, {"size", {size.x(), size.y(), size.z()}}}}}};
}

}  // namespace prehend::test
