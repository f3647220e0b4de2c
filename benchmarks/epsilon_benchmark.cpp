// What one epsilon_l1 costs, beside qhull's full hull of the same wrenches: medians of grasps that
// hold, by family and number of contacts.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "benchmarks/grasp_families.h"
#include "sim/quality/epsilon.h"
#include "sim/quality/wrench_hull.h"

namespace {

using prehend::Contact;
using prehend::Wrenches;
using prehend::bench::Contacts;
using prehend::bench::Random;

constexpr int kEdges = 8;
constexpr int kGrasps = 15;  // that hold, of a family
constexpr int kTries = 400;
constexpr int kRepeats = 5;

struct Family {
  std::string name;
  int multiple;  // of contacts that it has
  int fewest;
  std::function<Contacts(Random&, int contacts, double friction)> make;
};

Contacts turned(Random& random, const Contacts& contacts) {
  return prehend::bench::rotated(contacts, random.rotation());
}

std::vector<Family> families() {
  using prehend::bench::cylinder_grasp;
  using prehend::bench::doubled;
  using prehend::bench::jaw_grasp;
  using prehend::bench::loose_grasp;
  using prehend::bench::patches_grasp;
  using prehend::bench::random_grasp;
  using prehend::bench::ring_grasp;
  return {
      {"random", 1, 3, random_grasp},
      {"loose", 1, 3, loose_grasp},
      {"ring", 1, 3,
       [](Random& random, int n, double f) { return turned(random, ring_grasp(n, f)); }},
      {"ring aligned", 1, 3, [](Random&, int n, double f) { return ring_grasp(n, f); }},
      {"cylinder", 1, 3,
       [](Random& random, int n, double f) {
         return turned(random, cylinder_grasp(random, n, f));
       }},
      {"cylinder aligned", 1, 3, cylinder_grasp},
      {"patches", 4, 8,
       [](Random& random, int n, double f) { return patches_grasp(random, n / 4, f); }},
      {"jaw", 8, 8,
       [](Random& random, int, double f) {
         return turned(random, jaw_grasp(random.between(0.01, 0.2), f));
       }},
      {"two, nearly, twice", 4, 4,
       [](Random& random, int n, double f) {
         Contacts pair = turned(random, ring_grasp(2, f));
         for (; n > 2; n /= 2) pair = doubled(random, pair, 0.05);
         return pair;
       }},
      {"some frictionless", 1, 3,
       [](Random& random, int n, double f) {
         Contacts contacts = random_grasp(random, n, f);
         contacts[0].friction = 0.0;
         return contacts;
       }},
      {"soft fingers", 1, 3,
       [](Random& random, int n, double f) {
         Contacts contacts = random_grasp(random, n, f);
         for (Contact& contact : contacts) {
           contact.model = prehend::ContactModel::soft_finger;
           contact.torsion = 0.1;
         }
         return contacts;
       }},
  };
}

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
    const double friction = random.between(0.3, 1.0);
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
    for (const Family& family : families()) {
      if (contacts < family.fewest || contacts % family.multiple != 0) continue;
      const double ratio = measure(family, contacts);
      if (ratio > 0.0) ratios.push_back(ratio);
    }
    std::printf("%d contacts: median over families %.1f\n\n", contacts, median(ratios));
  }
}
