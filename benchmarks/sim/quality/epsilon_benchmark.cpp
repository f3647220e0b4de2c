// What one epsilon_l1 costs, beside qhull's full hull of the same wrenches: medians of grasps that
// hold, by family and number of contacts.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "benchmarks/sim/quality/families_by_size.h"
#include "sim/quality/epsilon.h"
#include "sim/quality/wrench_hull.h"

namespace {

using prehend::Random;
using prehend::Wrenches;
using prehend::benchmark::families_by_size;
using prehend::benchmark::Family;

constexpr int kEdges = 8;
constexpr int kGrasps = 15;  // that hold, of a family
constexpr int kTries = 400;
constexpr int kRepeats = 5;

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2.0;
}

// Median microseconds of several calls.
template <typename Call>
double microseconds(const Call& call) {
  std::vector<double> times;
  for (int i = 0; i < kRepeats; ++i) {
    const auto start = std::chrono::steady_clock::now();
    call();
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
    times.push_back(took.count());
  }
  return median(times);
}

// Prints one line; returns how many times faster epsilon_l1 is, 0 where no grasp holds.
double measure(const Family& family, int contacts) {
  Random random(static_cast<std::uint64_t>(contacts));
  std::vector<double> growth;
  std::vector<double> hull;
  Eigen::Index columns = 0;
  for (int i = 0; i < kTries && growth.size() < kGrasps; ++i) {
    const double friction = random.uniform(0.3, 1.0);
    const Wrenches wrenches = contact_wrenches(family.make(random, contacts, friction), {}, kEdges);
    if (!prehend::epsilon_l1(wrenches).force_closure()) continue;
    columns = wrenches.cols();
    growth.push_back(microseconds([&] { prehend::epsilon_l1(wrenches); }));
    hull.push_back(microseconds([&] { prehend::wrench_hull(wrenches); }));
  }
  if (growth.empty()) return 0.0;
  const double ratio = median(hull) / median(growth);
  std::printf(
      "%-20s %3d contacts %4td wrenches %3zu grasps   epsilon_l1 %9.1f us   qhull %9.1f us   ratio "
      "%6.1f\n",
      family.name.c_str(), contacts, columns, growth.size(), median(growth), median(hull), ratio);
  return ratio;
}

}  // namespace

int main() {
  for (const int contacts : {3, 4, 6, 8}) {
    std::vector<double> ratios;
    for (const Family& family : families_by_size()) {
      if (contacts < family.fewest || contacts % family.multiple != 0) continue;
      const double ratio = measure(family, contacts);
      if (ratio > 0.0) ratios.push_back(ratio);
    }
    std::printf("%d contacts: median over families %.1f\n\n", contacts, median(ratios));
  }
}
