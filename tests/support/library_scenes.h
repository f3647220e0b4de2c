// The library's scenes with an arm, and changes to their files.
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

inline std::filesystem::path library_scene(const std::string& name) {
  return std::filesystem::path(PREHEND_SOURCE_DIR) / "benchmarks" / "scenes" / (name + ".json");
}

inline nlohmann::json scene_json(const std::string& name) {
  return nlohmann::json::parse(std::ifstream(library_scene(name)));
}

// A file of the running test's own: tests run side by side.
inline std::filesystem::path write_scene(const nlohmann::json& scene) {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(info->test_suite_name()) + "_" + info->name();
  std::replace(name.begin(), name.end(), '/', '_');
  const std::filesystem::path file = testing::TempDir() + "/arm_scene_" + name + ".json";
  std::ofstream(file) << scene.dump(1);
  return file;
}

inline CompiledScene compiled_library_scene(const std::string& name) {
  return compile(load_scene(library_scene(name)));
}

inline CompiledScene compiled_scene(const nlohmann::json& scene) {
  return compile(load_scene(write_scene(scene)));
}

// A box that stands in the way, in the world's frame.
inline nlohmann::json box_obstacle(const std::string& name, const Vector3& size,
                                   const Vector3& at) {
  return {{"name", name},
          {"pose", {{"position", {at.x(), at.y(), at.z()}}}},
          {"geometry", {{{"shape", "box"}, {"size", {size.x(), size.y(), size.z()}}}}}};
}

}  // namespace prehend::test
