#include "planner/plan/pattern_search.h"

#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "sim/base/random.h"

namespace prehend {
namespace {

using Function = std::function<double(const std::vector<double>&)>;

// Runs the search for `steps` steps of `at_once` variables and checks what holds in each.
PatternSearch searched(const Function& f, std::size_t variables, double step, int steps,
                       std::size_t at_once) {
  PatternSearch search(variables, f(std::vector<double>(variables, 0.0)), step);
  for (int i = 0; i < steps; ++i) {
    const auto points = search.next(at_once);
    EXPECT_EQ(points.size(), 2 * at_once);
    std::vector<double> values;
    for (const std::vector<double>& point : points) {
      EXPECT_NE(point, search.best());
      for (const double x : point) EXPECT_LE(std::abs(x), 1.0);
      values.push_back(f(point));
    }
    const double before = search.best_value();
    search.tell(values);
    EXPECT_GE(search.best_value(), before);
    EXPECT_EQ(search.best_value(), f(search.best()));
  }
  return search;
}

// A paraboloid whose axes are those of the variables has its maximum found along each of them.
TEST(PatternSearch, FindsTheTopOfAParaboloid) {
  Random random(1);
  for (const std::size_t at_once : {1U, 2U, 4U}) {
    std::vector<double> top;
    for (int i = 0; i < 4; ++i) top.push_back(random.uniform(-0.8, 0.8));
    const auto f = [&](const std::vector<double>& x) {
      double sum = 0.0;
      for (std::size_t i = 0; i < 4; ++i) sum -= (x[i] - top[i]) * (x[i] - top[i]);
      return sum;
    };
    const PatternSearch search = searched(f, 4, 0.3, 200, at_once);
    // Steps go down to a thirtieth of the first, 0.01; then the nearest point is half of that away.
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(search.best()[i], top[i], 0.01);
  }
}

TEST(PatternSearch, StaysWithinTheLimitsAndReachesThem) {
  const auto slope = [](const std::vector<double>& x) { return x[0] - 2.0 * x[1] + x[2]; };
  const PatternSearch search = searched(slope, 3, 0.3, 40, 2);
  EXPECT_EQ(search.best(), (std::vector<double>{1.0, -1.0, 1.0}));
}

// From every point of the ridge x0 = x1 each variable alone leads down, while the ridge leads up to
// 2 at (1, 1).
TEST(PatternSearch, FollowsARidgeThatNoVariableFollows) {
  const auto ridge = [](const std::vector<double>& x) {
    return x[0] + x[1] - 10.0 * std::abs(x[0] - x[1]);
  };
  EXPECT_GT(searched(ridge, 2, 0.3, 400, 2).best_value(), 1.9);
}

// A cliff beside the best point: only comparisons count, not how deep it goes.
TEST(PatternSearch, AClimbAlongACliffGoesOn) {
  for (const double depth : {0.0, 1e30, std::numeric_limits<double>::infinity()}) {
    const auto f = [&](const std::vector<double>& x) { return x[1] > 0.05 ? -depth - 1.0 : x[0]; };
    EXPECT_EQ(searched(f, 2, 0.3, 40, 2).best()[0], 1.0);
  }
}

TEST(PatternSearch, DoesNotGoToWhatIsNotANumber) {
  const auto f = [](const std::vector<double>& x) {
    return x[0] > 0.0 ? std::numeric_limits<double>::quiet_NaN() : -std::abs(x[0] + 0.5);
  };
  PatternSearch search(1, f({0.0}), 0.3);
  for (int i = 0; i < 60; ++i) {
    std::vector<double> values;
    for (const auto& point : search.next(1)) values.push_back(f(point));
    search.tell(values);
  }
  EXPECT_NEAR(search.best()[0], -0.5, 0.01);
}

TEST(PatternSearch, OfEqualValuesTheFirstIsTaken) {
  PatternSearch search(2, 0.0, 0.3);
  const auto points = search.next(2);
  search.tell({0.0, 1.0, 1.0, 1.0});
  EXPECT_EQ(search.best(), points[1]);
}

}  // namespace
}  // namespace prehend
