#include "sim/base/number_text.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/base/random.h"

namespace prehend {
namespace {

TEST(NumberText, ReadsBackEqualAndAsANumberEverywhere) {
  const std::vector<std::pair<double, std::string>> known = {
      {0.0, "0.0"},      {1.0, "1.0"},        {-2.5, "-2.5"},    {0.1, "0.1"},
      {1e-5, "1.0e-05"}, {1.5e-7, "1.5e-07"}, {1e22, "1.0e+22"}, {-0.0, "-0.0"}};
  for (const auto& [value, text] : known) EXPECT_EQ(number_text(value), text);
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const double mantissa = random.uniform(-1.0, 1.0);
    const double value = mantissa * std::pow(10.0, random.uniform(-300.0, 300.0));
    const std::string text = number_text(value);
    EXPECT_EQ(std::stod(text), value);
    EXPECT_NE(text.find('.'), std::string::npos) << text;
  }
  EXPECT_THROW(number_text(std::numeric_limits<double>::quiet_NaN()), InputError);
  EXPECT_THROW(number_text(-std::numeric_limits<double>::infinity()), InputError);
}

}  // namespace
}  // namespace prehend
