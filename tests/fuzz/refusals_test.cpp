// What a person reads whose robot or scene is refused: where the fault is, and what to do.
#include <algorithm>
#include <array>
#include <filesystem>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/input_file.h"
#include "tests/fuzz/untrusted_files.h"

namespace prehend::fuzz {
namespace {

std::vector<std::filesystem::path> refused_files(std::string_view kind) {
  std::vector<std::filesystem::path> files;
  const auto folder = std::filesystem::path(PREHEND_SOURCE_DIR) / "tests/corpus" / kind;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().filename().string().starts_with("bad_")) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// Of the ways in which messages say what would be right.
bool says_what_to_do(const std::string& message) {
  constexpr std::array<std::string_view, 12> kWays = {
      " must ",     " needs ", " need ", " known ", "one of ",   " only ",
      "not beside", "lacks ",  "save ",  "state ",  "GRASPIT (", "cannot be read: "};
  return std::any_of(kWays.begin(), kWays.end(),
                     [&](std::string_view way) { return message.find(way) != std::string::npos; });
}

class Refusals : public testing::TestWithParam<std::string_view> {};

TEST_P(Refusals, NameFileAndPlaceAndWhatToDo) {
  // FILE: then the line, the element or the path of the field; a whole file that has too many
  // levels has no such place.
  const std::regex place(R"(^/[^:]+: (line \d+[:,]|[a-z_][\w./\[\]-]*: |must |cannot ))");
  for (const std::filesystem::path& file : refused_files(GetParam())) {
    const std::string message = refusal(file_kind(GetParam()), read_file(file));
    SCOPED_TRACE(file.filename().string() + "\n" + message);
    EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_TRUE(std::regex_search(message, place));
    EXPECT_TRUE(says_what_to_do(message));
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Refusals,
                         testing::Values("robot", "platform", "graspit_robot", "graspit_world",
                                         "urdf", "xacro", "sdf", "mjcf", "scene", "moveit"),
                         [](const auto& kind) { return std::string(kind.param); });

}  // namespace
}  // namespace prehend::fuzz
