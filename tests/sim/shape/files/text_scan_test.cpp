#include "sim/shape/files/text_scan.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"

namespace prehend {
namespace {

TEST(TextScan, EndsLinesAtEveryKindOfBreak) {
  TextScan scan("a b\r\nc\rd\n\n e");
  std::string words;
  while (scan.next_line()) {
    for (auto word = scan.next_word(); !word.empty(); word = scan.next_word()) {
      words += std::to_string(scan.line_number()) + std::string(word);
    }
  }
  EXPECT_EQ(words, "1a1b2c3d5e");
}

TEST(TextScan, SeparatesWordsBySpacesAndTabsOnly) {
  TextScan scan("a \tb\vc\fd");
  ASSERT_TRUE(scan.next_line());
  EXPECT_EQ(scan.next_word(), "a");
  EXPECT_EQ(scan.next_word(), "b\vc\fd");
  EXPECT_EQ(scan.next_word(), "");
}

TEST(NumberIn, TakesWholeWordsOnly) {
  EXPECT_EQ(number_in("+1.5e1"), 15.0);
  EXPECT_EQ(number_in("-.5"), -0.5);
  EXPECT_EQ(number_in("2."), 2.0);
  EXPECT_EQ(number_in("1e-999"), 0.0);
  EXPECT_EQ(number_in("0." + std::string(400, '0') + "1"), 0.0);
  EXPECT_TRUE(std::isinf(number_in(std::string(400, '9') + "e-5").value()));
  EXPECT_TRUE(std::isinf(number_in("1e999").value()));
  EXPECT_TRUE(std::isnan(number_in("nan").value()));
  for (const char* word : {"", "+", "-", "+-1", "1x", "3.1+e2", "0x10", "1,5"}) {
    EXPECT_FALSE(number_in(word)) << word;
  }
  EXPECT_EQ(integer_in("-7"), -7);
  EXPECT_FALSE(integer_in("7.0"));
  EXPECT_FALSE(integer_in("99999999999999999999"));
}

TEST(CoordinateIn, RefusesWhatDoesNotFitAFloat) {
  const TextScan scan("");
  EXPECT_EQ(coordinate_in(scan, "3e38"), 3e38);
  for (const char* word : {"4e38", "inf", "-nan", "x", ""}) {
    EXPECT_THROW(coordinate_in(scan, word), InputError) << word;
  }
}

TEST(InQuotes, IsShortAndPrintable) {
  EXPECT_EQ(in_quotes("a\nb"), "'a?b'");
  EXPECT_EQ(in_quotes(std::string(100, 'x')), "'" + std::string(40, 'x') + "...'");
}

}  // namespace
}  // namespace prehend
