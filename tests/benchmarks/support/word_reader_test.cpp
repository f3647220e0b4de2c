#include "benchmarks/support/word_reader.h"

#include <gtest/gtest.h>

namespace prehend::bench {
namespace {

TEST(WordReader, ReadsFlagsWithTheirValues) {
  WordReader reader({"--count", "12", "cup.stl", "--name", "--odd"});
  ASSERT_TRUE(reader.next());
  EXPECT_EQ(reader.word(), "--count");
  EXPECT_EQ(reader.number(), 12);
  ASSERT_TRUE(reader.next());
  EXPECT_EQ(reader.word(), "cup.stl");
  ASSERT_TRUE(reader.next());
  EXPECT_EQ(reader.text(), "--odd");
  EXPECT_FALSE(reader.next());
  EXPECT_FALSE(WordReader({}).next());
}

TEST(WordReader, RefusesValuesThatAreNone) {
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"--count"}, {"--count", "many"}, {"--count", "3x"}, {"--count", ""}}) {
    WordReader reader(words);
    ASSERT_TRUE(reader.next());
    EXPECT_THROW(reader.number(), InputError);
  }
}

}  // namespace
}  // namespace prehend::bench
