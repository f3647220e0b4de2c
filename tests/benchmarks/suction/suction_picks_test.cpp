#include "benchmarks/suction/suction_picks.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace prehend::bench {
namespace {

using Indices = std::vector<std::size_t>;

TEST(SuctionPicks, ChoiceGoesFromTheSmallestToTheLargest) {
  EXPECT_EQ(spread_over({5.0, 1.0, 4.0, 2.0, 3.0}, 3), (Indices{1, 4, 0}));
  EXPECT_EQ(spread_over({5.0, 1.0, 4.0, 2.0, 3.0}, 2), (Indices{1, 0}));
  EXPECT_EQ(spread_over({5.0, 1.0}, 3), (Indices{1, 0}));
  EXPECT_EQ(spread_over({2.0, 2.0, 2.0}, 1), (Indices{0}));
  EXPECT_EQ(spread_over({}, 3), Indices{});
}

TEST(SuctionPicks, ListsTakeTurns) {
  const auto text = [](const Indices& sizes, std::size_t count) {
    std::string all;
    for (const TakenItem& of : in_turn(sizes, count)) {
      all += std::to_string(of.list) + "." + std::to_string(of.item) + " ";
    }
    return all;
  };
  EXPECT_EQ(text({1, 3, 2}, 9), "0.0 1.0 2.0 1.1 2.1 1.2 ");
  EXPECT_EQ(text({1, 3, 2}, 4), "0.0 1.0 2.0 1.1 ");
  EXPECT_EQ(text({}, 4), "");
}

TEST(SuctionPicks, FactorsAreEvenOnALogarithmicScale) {
  for (const std::size_t count : {std::size_t{2}, std::size_t{7}, std::size_t{100}}) {
    std::vector<double> factors = spread_factors(0.3, 3.0, count);
    if (count == 100) {
      // Neighbours are far apart.
      EXPECT_GT(std::abs(std::log(factors[1] / factors[0])), 0.5);
    }
    std::sort(factors.begin(), factors.end());
    EXPECT_NEAR(factors.front(), 0.3, 1e-12);
    EXPECT_NEAR(factors.back(), 3.0, 1e-12);
    for (std::size_t k = 1; k < count; ++k) {
      EXPECT_NEAR(factors[k] / factors[k - 1], std::pow(10.0, 1.0 / static_cast<double>(count - 1)),
                  1e-9);
    }
  }
  EXPECT_EQ(spread_factors(0.3, 3.0, 1), std::vector<double>{0.3});
}

}  // namespace
}  // namespace prehend::bench
