// Quantiles against those of sorted values.
#include "primitives/quantile.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/random.h"

namespace prehend {
namespace {

void expect_as_sorted(const std::vector<double>& values) {
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  for (const double q : {0.0, 0.005, 0.01, 0.15, 0.5, 0.85, 0.95, 0.99, 1.0}) {
    std::vector<double> reordered = values;
    const auto place =
        static_cast<std::size_t>(std::lround(q * static_cast<double>(values.size() - 1)));
    EXPECT_EQ(quantile(reordered, q), sorted[place]) << values.size() << " values, q " << q;
    std::sort(reordered.begin(), reordered.end());
    EXPECT_EQ(reordered, sorted);
  }
}

TEST(Quantile, OfRandomValuesOfAnyNumber) {
  Random random(1);
  for (std::size_t count = 1; count <= 300; ++count) {
    std::vector<double> values(count);
    for (double& v : values) v = random.uniform(-1.0, 1.0);
    expect_as_sorted(values);
  }
}

TEST(Quantile, OfValuesThatRepeat) {
  Random random(2);
  for (const double distinct : {1.0, 2.0, 3.0, 10.0}) {
    std::vector<double> values(500);
    for (double& v : values) v = std::floor(random.uniform(0.0, distinct));
    expect_as_sorted(values);
  }
}

// Orders for which a naive choice of the pivot takes quadratic time.
TEST(Quantile, OfValuesInOrder) {
  std::vector<double> up(20'000);
  for (std::size_t i = 0; i < up.size(); ++i) up[i] = static_cast<double>(i);
  const std::vector<double> down(up.rbegin(), up.rend());
  std::vector<double> pipes(up);
  std::copy(down.begin() + 10'000, down.end(), pipes.begin() + 10'000);
  for (const std::vector<double>& values : {up, down, pipes}) expect_as_sorted(values);
}

TEST(ValueAtPlace, FindsEveryPlace) {
  Random random(3);
  std::vector<double> values(40);
  for (double& v : values) v = random.uniform(0.0, 1.0);
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t place = 0; place < values.size(); ++place) {
    std::vector<double> reordered = values;
    EXPECT_EQ(value_at_place(reordered, place), sorted[place]) << place;
  }
}

}  // namespace
}  // namespace prehend
