#include "planner/live/serve/utf8.h"

#include <cstdint>
#include <string>

#include <gtest/gtest.h>

namespace prehend {
namespace {

// Bits of a character in so many bytes, whether or not it may be written so.
std::string written(std::uint32_t character, int bytes) {
  if (bytes == 1) return std::string(1, static_cast<char>(character));
  const std::uint32_t mark = (0xF00U >> static_cast<unsigned>(bytes)) & 0xFFU;
  std::string text;
  for (int i = bytes - 1; i >= 0; --i) {
    const std::uint32_t bits = character >> static_cast<unsigned>(6 * i);
    text += static_cast<char>(i == bytes - 1 ? (mark | bits) : (0x80U | (bits & 0x3FU)));
  }
  return text;
}

TEST(Utf8, EveryCharacterIsTextInItsShortestFormOnly) {
  for (std::uint32_t character = 0; character < 0x200000; ++character) {
    const bool exists = character <= 0x10FFFF && (character < 0xD800 || character > 0xDFFF);
    const int shortest = character < 0x80 ? 1 : character < 0x800 ? 2 : character < 0x10000 ? 3 : 4;
    for (int bytes = shortest; bytes <= 4; ++bytes) {
      const std::string text = written(character, bytes);
      ASSERT_EQ(is_utf8(text), exists && bytes == shortest) << character << " in " << bytes;
    }
  }
}

TEST(Utf8, CutAndStrayBytesAreNot) {
  EXPECT_TRUE(is_utf8(""));
  EXPECT_TRUE(
      is_utf8("gr\xC3\xBC\xC3\x9F"
              "e"));
  EXPECT_FALSE(is_utf8("gr\xC3"));
  EXPECT_FALSE(is_utf8("\xE2\x88"));
  EXPECT_FALSE(is_utf8("\xF0\x9F\x98"));
  EXPECT_FALSE(
      is_utf8("\xC3"
              "a"));
  EXPECT_FALSE(is_utf8("a\x80"));
  EXPECT_FALSE(is_utf8("\xFF\xFE"));
}

TEST(Utf8, PlainTextHasNoControlCharactersButTabs) {
  for (int byte = 0; byte < 256; ++byte) {
    const std::string text = std::string("a") + static_cast<char>(byte) + "b";
    EXPECT_EQ(is_plain_text(text), byte == '\t' || (byte >= 0x20 && byte < 0x7F)) << byte;
  }
  EXPECT_TRUE(is_plain_text("gr\xC3\xBC\xC3\x9F"));
  EXPECT_TRUE(is_plain_text(""));
}

}  // namespace
}  // namespace prehend
