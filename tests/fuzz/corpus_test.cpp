// What the fuzz targets do, with the files of tests/corpus. Names begin with good_ where a file is
// to be read, with bad_ where it is to be refused.
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

std::filesystem::path corpus_folder() {
  return std::filesystem::path(PREHEND_SOURCE_DIR) / "tests/corpus";
}

std::vector<std::filesystem::path> corpus_of(const FileKind& kind) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(corpus_folder() / kind.name)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class Corpus : public testing::TestWithParam<FileKind> {};

TEST_P(Corpus, IsReadOrRefusedAsItsNamesSay) {
  int good = 0;
  int bad = 0;
  for (const std::filesystem::path& file : corpus_of(GetParam())) {
    SCOPED_TRACE(file.string());
    const std::string name = file.filename().string();
    std::string why;
    EXPECT_NO_THROW(why = refusal(GetParam(), read_file(file)));
    good += int{name.starts_with("good_")};
    bad += int{name.starts_with("bad_")};
    EXPECT_EQ(why.empty(), name.starts_with("good_")) << why;
    EXPECT_TRUE(name.starts_with("good_") || name.starts_with("bad_"));
  }
  EXPECT_GT(good, 0);
  EXPECT_GT(bad, 0);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Corpus, testing::ValuesIn(file_kinds().begin(), file_kinds().end()),
                         [](const auto& kind) { return std::string(kind.param.name); });

TEST(Corpora, HaveNoFolderThatNoReaderReads) {
  for (const auto& entry : std::filesystem::directory_iterator(corpus_folder())) {
    EXPECT_NO_THROW((void)file_kind(entry.path().filename().string())) << entry.path();
  }
}

// Of the ways in which messages say what would be right.
bool says_what_to_do(const std::string& message) {
  constexpr std::array<std::string_view, 13> kWays = {
      " must ", " needs ", " need ", " known ",   "one of ",          " only ",    "not beside",
      "lacks ", "save ",   "state ", "GRASPIT (", "cannot be read: ", "say where "};
  return std::any_of(kWays.begin(), kWays.end(),
                     [&](std::string_view way) { return message.find(way) != std::string::npos; });
}

// What a person reads whose robot or scene is refused: where the fault is, and what to do.
class Refusals : public testing::TestWithParam<std::string_view> {};

TEST_P(Refusals, NameFileAndPlaceAndWhatToDo) {
  // FILE: then the line, the element or the path of the field; a whole file that has too many
  // levels has no such place.
  const std::regex place(R"(^/[^:]+: (line \d+[:,]|[a-z_][\w./\[\]-]*: |must |cannot ))");
  for (const std::filesystem::path& file : corpus_of(file_kind(GetParam()))) {
    if (!file.filename().string().starts_with("bad_")) continue;
    const std::string message = refusal(file_kind(GetParam()), read_file(file));
    SCOPED_TRACE(file.filename().string() + "\n" + message);
    EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_TRUE(std::regex_search(message, place));
    EXPECT_TRUE(says_what_to_do(message));
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Refusals,
                         testing::Values("robot", "platform", "graspit_robot", "graspit_world",
                                         "urdf", "xacro", "sdf", "openrave", "mjcf", "scene",
                                         "moveit"),
                         [](const auto& kind) { return std::string(kind.param); });

}  // namespace
}  // namespace prehend::fuzz
