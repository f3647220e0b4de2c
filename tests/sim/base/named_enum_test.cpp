#include "sim/base/named_enum.h"

#include <gtest/gtest.h>

namespace prehend {
namespace {

enum class Fruit { apple, pear, plum };
constexpr auto enum_names(Fruit /*of*/) {
  return std::to_array<std::string_view>({"apple", "pear", "plum"});
}

TEST(NamedEnum, HasAllItsValuesInTheirOrder) {
  EXPECT_EQ(kAll<Fruit>, (std::array{Fruit::apple, Fruit::pear, Fruit::plum}));
}

TEST(NamedEnum, IsFoundByTheNameOfEachValueAndByNoOther) {
  for (const Fruit fruit : kAll<Fruit>) EXPECT_EQ(value_named<Fruit>(name_of(fruit)), fruit);
  EXPECT_EQ(name_of(Fruit::plum), "plum");
  EXPECT_EQ(value_named<Fruit>("Apple"), std::nullopt);
  EXPECT_EQ(value_named<Fruit>(""), std::nullopt);
}

TEST(EnumArray, HasAnEntryForEachValueZeroAtFirst) {
  EnumArray<Fruit, int> counts;
  EXPECT_EQ(counts.entries, (std::array{0, 0, 0}));
  ++counts[Fruit::pear];
  EXPECT_EQ(counts.entries, (std::array{0, 1, 0}));
  EXPECT_NE(counts, (EnumArray<Fruit, int>{}));
}

}  // namespace
}  // namespace prehend
