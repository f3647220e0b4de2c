#include "planner/results/datasets/hdf5/checksum.h"

#include <gtest/gtest.h>

namespace prehend::hdf5 {
namespace {

Bytes bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

// The first two values are those of the comments in Jenkins' lookup3.c.
TEST(Checksum, Lookup3IsJenkins) {
  EXPECT_EQ(lookup3({}), 0xdeadbeefU);
  EXPECT_EQ(lookup3(bytes_of("Four score and seven years ago")), 0x17770551U);
}

// Sums by hand: 0x6162 + 0x6364 + 0x6500 = 0x129c6, which folds to 0x29c7.
TEST(Checksum, Fletcher32AddsWordsWithTheUpperByteFirst) {
  EXPECT_EQ(fletcher32({}), 0U);
  EXPECT_EQ(fletcher32(bytes_of("ab")), 0x61626162U);
  EXPECT_EQ(fletcher32(bytes_of("abcde")) & 0xffffU, 0x29c7U);
}

}  // namespace
}  // namespace prehend::hdf5
