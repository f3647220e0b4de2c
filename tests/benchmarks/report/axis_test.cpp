#include "benchmarks/report/axis.h"

#include <gtest/gtest.h>

#include "sim/base/random.h"

namespace prehend::bench {
namespace {

std::vector<std::string> labels_of(const Axis& axis) {
  std::vector<std::string> labels;
  for (const Tick& tick : axis.ticks) labels.push_back(tick.label);
  return labels;
}

using Labels = std::vector<std::string>;

TEST(Axis, LinearTicksAreRound) {
  EXPECT_EQ(labels_of(make_axis(Scale::linear, 0.0, 100.0)),
            (Labels{"0", "20", "40", "60", "80", "100"}));
  EXPECT_EQ(labels_of(make_axis(Scale::linear, 0.0, 0.23)),
            (Labels{"0", "0.05", "0.1", "0.15", "0.2", "0.25"}));
  EXPECT_EQ(labels_of(make_axis(Scale::linear, -1.0, 3.5)),
            (Labels{"-1", "0", "1", "2", "3", "4"}));
}

TEST(Axis, LogarithmicTicksArePowersOfTen) {
  EXPECT_EQ(labels_of(make_axis(Scale::logarithmic, 1e3, 1e6)),
            (Labels{"1k", "10k", "100k", "1M"}));
  EXPECT_EQ(labels_of(make_axis(Scale::logarithmic, 0.02, 70.0)),
            (Labels{"0.01", "0.1", "1", "10", "100"}));
  EXPECT_EQ(labels_of(make_axis(Scale::logarithmic, 3.0, 64.0)),
            (Labels{"2", "5", "10", "20", "50", "100"}));
  EXPECT_EQ(labels_of(make_axis(Scale::logarithmic, 1.0, 2.0)), (Labels{"1", "2"}));
}

// Whatever is to be seen, the axis contains it, and has two to nine ticks in ascending order.
TEST(Axis, ContainsWhatItIsFor) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Scale scale = i % 2 == 0 ? Scale::linear : Scale::logarithmic;
    const double low = std::pow(10.0, random.uniform(-9.0, 6.0));
    const double high = low * std::pow(10.0, i % 5 == 0 ? 0.0 : random.uniform(0.0, 14.0));
    const Axis axis = make_axis(scale, low, high);
    EXPECT_LE(axis.low, low * (1.0 + 1e-6));
    EXPECT_GE(axis.high, high * (1.0 - 1e-6));
    EXPECT_LT(axis.low, axis.high);
    ASSERT_GE(axis.ticks.size(), 2U);
    EXPECT_LE(axis.ticks.size(), 9U);
    for (std::size_t k = 1; k < axis.ticks.size(); ++k) {
      EXPECT_LT(axis.ticks[k - 1].value, axis.ticks[k].value);
      EXPECT_NE(axis.ticks[k - 1].label, axis.ticks[k].label);
    }
    EXPECT_GT(axis.place(high), -1e-6);
    EXPECT_LT(axis.place(high), 1.0 + 1e-6);
  }
}

TEST(Axis, PlacesAreBetweenZeroAndOne) {
  const Axis linear = make_axis(Scale::linear, 0.0, 100.0);
  EXPECT_DOUBLE_EQ(linear.place(0.0), 0.0);
  EXPECT_DOUBLE_EQ(linear.place(25.0), 0.25);
  const Axis decades = make_axis(Scale::logarithmic, 1.0, 1e4);
  EXPECT_DOUBLE_EQ(decades.place(100.0), 0.5);
  EXPECT_EQ(decades.place(0.0), 0.0);
}

TEST(Axis, NumbersAreShort) {
  EXPECT_EQ(short_number(0.0), "0");
  EXPECT_EQ(short_number(0.05), "0.05");
  EXPECT_EQ(short_number(250.0), "250");
  EXPECT_EQ(short_number(1000.0), "1k");
  EXPECT_EQ(short_number(2.5e6), "2.5M");
  EXPECT_EQ(short_number(1e-6), "1e-6");
  EXPECT_EQ(short_number(1e12), "1e12");
}

}  // namespace
}  // namespace prehend::bench
