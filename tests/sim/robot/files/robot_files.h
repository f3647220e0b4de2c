// Robot files written by tests.
#pragma once

#include <cctype>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/base/input_error.h"
#include "sim/robot/files/robot_file.h"

namespace prehend::test {

// A planar arm of two revolute joints and one sliding finger, in millimetres and degrees: the
// smallest file that has every part.
inline nlohmann::json small_robot() {
  return nlohmann::json::parse(R"({
    "name": "small",
    "units": {"length": "mm", "angle": "deg"},
    "geometries": {"bar": [{"shape": "box", "size": [10, 4, 4]}]},
    "base": {"name": "foot", "material": "metal", "geometry": "bar"},
    "chains": [
      {"name": "arm",
       "joints": [
         {"name": "shoulder", "type": "revolute", "theta": 0, "d": 0, "a": 300, "alpha": 0,
          "limits": [-90, 90]},
         {"name": "elbow", "type": "revolute", "theta": 0, "d": 0, "a": 200, "alpha": 0,
          "limits": [-30, 60]}],
       "links": [
         {"name": "upper", "joint": "shoulder", "material": "wood", "geometry": "bar"},
         {"name": "fore", "joint": "elbow", "material": "wood", "geometry": "bar"}]},
      {"name": "finger",
       "base": [{"translate": [0, 0, 10]}, {"rotate_y": 90}],
       "joints": [
         {"name": "slide", "type": "prismatic", "theta": 0, "d": 5, "a": 0, "alpha": 0,
          "limits": [0, 40]}],
       "links": [{"name": "tip", "joint": "slide", "material": "rubber", "geometry": "bar"}]}],
    "dofs": [
      {"name": "bend", "closing_velocity": 90,
       "drives": [{"joint": "shoulder"}, {"joint": "elbow", "ratio": 0.5, "offset": 10}]},
      {"name": "grip", "closing_velocity": -50, "initial": 20, "drives": [{"joint": "slide"}]}],
    "hand": {
      "approach": [0, 0, 2], "closing": [1, 0, 0], "origin": [0, 0, 3],
      "preshapes": [{"name": "open", "dofs": {"grip": 40}, "width": [0, 80], "depth": 30}]}
  })");
}

// A new file in the folder for temporary files, one for each test.
inline std::filesystem::path write_robot_text(const std::string& text) {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(info->test_suite_name()) + "_" + info->name() + ".json";
  for (char& c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.') c = '_';
  }
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / name;
  std::ofstream(file) << text;
  return file;
}

inline Robot load_robot_json(const nlohmann::json& robot) {
  return load_robot(write_robot_text(robot.dump(1)));
}

// The complaint about the file, without the folder; "" when there is none.
inline std::string complaint_about(const std::filesystem::path& file) {
  try {
    load_robot(file);
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_EQ(message.rfind(file.string() + ": ", 0), 0U) << message;
    return message.substr(std::min(message.size(), file.string().size() + 2));
  }
  return "";
}

}  // namespace prehend::test
