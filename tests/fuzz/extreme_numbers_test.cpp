// Every number of every kind of file as an extreme: it is refused, or what is read keeps what its
// reader promises.
#include "tests/fuzz/extreme_numbers.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/input_file.h"
#include "tests/fuzz/untrusted_files.h"

namespace prehend::fuzz {
namespace {

TEST(ExtremeNumbers, StandInThePlaceOfEachNumberThatIsNoPartOfAName) {
  std::vector<std::string> changed;
  for_each_extreme("v1 -2.5e3 d0*3", 100, [&](const std::string& text) {
    if (text.find("1e21") != std::string::npos && text.find("-1e21") == std::string::npos) {
      changed.push_back(text);
    }
  });
  EXPECT_EQ(changed, (std::vector<std::string>{"v1 1e21 d0*3", "v1 -2.5e3 d0*1e21"}));
}

class ExtremeNumbersIn : public testing::TestWithParam<FileKind> {};

TEST_P(ExtremeNumbersIn, AreRefusedOrRead) {
  constexpr std::size_t kMostInAFile = 120;
  int cases = 0;
  const std::filesystem::path folder =
      std::filesystem::path(PREHEND_SOURCE_DIR) / "tests/corpus" / GetParam().name;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (!entry.path().filename().string().starts_with("good_")) continue;
    SCOPED_TRACE(entry.path().string());
    for_each_extreme(read_file(entry.path()), kMostInAFile, [&](const std::string& changed) {
      ++cases;
      EXPECT_NO_THROW((void)refusal(GetParam(), changed)) << changed;
    });
  }
  RecordProperty("cases", cases);
  const bool is_text = GetParam().grammar != Grammar::glb && GetParam().name != "stl";
  EXPECT_GT(cases, is_text ? 0 : -1);
}

// Messages are tried with the table of commands, which knows all their numbers
// (tests/planner/live/protocol/extreme_numbers_test.cpp).
std::vector<FileKind> kinds_of_files() {
  std::vector<FileKind> kinds(file_kinds().begin(), file_kinds().end());
  std::erase_if(kinds, [](const FileKind& kind) { return kind.grammar == Grammar::messages; });
  return kinds;
}

INSTANTIATE_TEST_SUITE_P(Kinds, ExtremeNumbersIn, testing::ValuesIn(kinds_of_files()),
                         [](const auto& kind) { return std::string(kind.param.name); });

}  // namespace
}  // namespace prehend::fuzz
