#include "planner/live/serve/line_splitter.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/random.h"

namespace prehend {
namespace {

using Lines = std::vector<std::pair<std::string, bool>>;

Lines lines_of(LineSplitter& splitter, std::string_view bytes) {
  Lines lines;
  splitter.add(bytes, [&](std::string line, bool whole) {
    lines.emplace_back(std::move(line), whole);
    return true;
  });
  return lines;
}

TEST(LineSplitter, TakesBothEndsAndLeavesEmptyLinesOut) {
  LineSplitter splitter(10);
  EXPECT_EQ(lines_of(splitter, "a\nb\r\n\n\r\nc\rd\n\ne"),
            (Lines{{"a", true}, {"b", true}, {"c\rd", true}}));
  EXPECT_EQ(lines_of(splitter, "f\n"), (Lines{{"ef", true}}));
}

TEST(LineSplitter, TheLongestLineFitsWithEitherEnd) {
  LineSplitter splitter(4);
  EXPECT_EQ(lines_of(splitter, "1234\n1234\r\n"), (Lines{{"1234", true}, {"1234", true}}));
  EXPECT_EQ(lines_of(splitter, "12345\n1234\r"), (Lines{{"12345", false}}));
  EXPECT_EQ(lines_of(splitter, "\nabc\n"), (Lines{{"1234", true}, {"abc", true}}));
  // Too long by what is no end after all.
  EXPECT_EQ(lines_of(splitter, "1234\r"), Lines{});
  EXPECT_EQ(lines_of(splitter, "5\nabc\n"), (Lines{{"1234\r", false}, {"abc", true}}));
}

TEST(LineSplitter, ALongLineIsPassedOnOnceAndItsRestDropped) {
  LineSplitter splitter(100);
  const std::string piece(60, 'x');
  EXPECT_EQ(lines_of(splitter, piece), Lines{});
  EXPECT_EQ(lines_of(splitter, piece), (Lines{{std::string(16, 'x'), false}}));
  EXPECT_EQ(lines_of(splitter, piece + piece + piece), Lines{});
  EXPECT_EQ(lines_of(splitter, piece + "\nnext\n"), (Lines{{"next", true}}));
}

TEST(LineSplitter, AHundredMegabytesAreNotKept) {
  constexpr std::size_t kLongest = 10000;
  LineSplitter splitter(kLongest);
  const std::string piece(65536, 'x');
  std::size_t most = 0;
  std::size_t said = 0;
  for (int i = 0; i < 1600; ++i) {
    said += lines_of(splitter, piece).size();
    most = std::max(most, splitter.held());
  }
  EXPECT_EQ(said, 1U);
  // A string that grows takes twice of what it needs at most.
  EXPECT_LE(most, 2 * kLongest);
}

TEST(LineSplitter, DropsTheRestOfAPieceWhenItIsToldSo) {
  LineSplitter splitter(10);
  Lines lines;
  splitter.add("a\nb\nc\n", [&](std::string line, bool whole) {
    lines.emplace_back(std::move(line), whole);
    return lines.size() < 2;
  });
  EXPECT_EQ(lines, (Lines{{"a", true}, {"b", true}}));
}

// The reference cuts the whole text at once.
TEST(LineSplitter, WhereTheStreamIsCutDoesNotMatter) {
  Random random(7);
  for (int round = 0; round < 300; ++round) {
    const std::size_t longest = 1 + random.index(20);
    std::string text;
    for (std::size_t i = random.index(400); i > 0; --i) text += "abc\r\n\n"[random.index(6)];
    Lines expected;
    std::string_view rest = text;
    for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
      std::string line(rest.substr(0, end));
      if (line.ends_with('\r')) line.pop_back();
      if (line.size() > longest) {
        expected.emplace_back("", false);
      } else if (!line.empty()) {
        expected.emplace_back(line, true);
      }
      rest.remove_prefix(end + 1);
    }
    const bool is_cut = rest.size() > longest + 1;
    if (is_cut) expected.emplace_back("", false);

    LineSplitter splitter(longest);
    Lines lines;
    for (std::string_view left = text; !left.empty();) {
      const std::size_t size = std::min(left.size(), 1 + random.index(30));
      for (auto& [line, whole] : lines_of(splitter, left.substr(0, size))) {
        lines.emplace_back(whole ? line : "", whole);
      }
      left.remove_prefix(size);
    }
    EXPECT_EQ(lines, expected) << "round " << round;
  }
}

}  // namespace
}  // namespace prehend
