// Files of other programs' formats, written by tests.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/robot/files/foreign_robot.h"

namespace prehend::test {

// An empty folder for the test that runs.
inline std::filesystem::path test_folder() {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(info->test_suite_name()) + "_" + info->name();
  std::replace(name.begin(), name.end(), '/', '_');
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

inline std::filesystem::path write_text(const std::filesystem::path& file,
                                        const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << text;
  return file;
}

// A cube of edge 1, corners at 0 and 1.
inline const char* const kUnitCubeObj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

// A box of these edges as a <link> with this name.
inline std::string box_link(const std::string& name, const std::string& size = "0.1 0.1 0.1",
                            const std::string& xyz = "0 0 0") {
  return "<link name=\"" + name + "\"><collision><origin xyz=\"" + xyz +
         "\"/><geometry><box size=\"" + size + "\"/></geometry></collision></link>\n";
}

// A <joint>; `inside` stands between its tags, after parent and child.
inline std::string urdf_joint(const std::string& name, const std::string& type,
                              const std::string& parent, const std::string& child,
                              const std::string& inside = "") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/>" + inside + "</joint>\n";
}

inline const char* const kLimit = "<limit lower=\"-1\" upper=\"2\" effort=\"3\" velocity=\"4\"/>";

inline std::string urdf(const std::string& inside) {
  return "<robot name=\"made\">\n" + inside + "</robot>\n";
}

// The platform of a file "made.urdf" with this text.
inline Platform read_text(const std::string& text) {
  return read_foreign_robot(write_text(test_folder() / "made.urdf", text)).value();
}

// The complaint about such a file without its path; "" when there is none.
inline std::string foreign_complaint(const std::string& text) {
  try {
    (void)read_text(text);
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    const std::size_t at = message.find("made.urdf: ");
    EXPECT_NE(at, std::string::npos) << message;
    return at == std::string::npos ? message : message.substr(at + 11);
  }
  return "";
}

inline bool has_note(const Robot& robot, const std::string& part) {
  return std::any_of(robot.notes.begin(), robot.notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

}  // namespace prehend::test
