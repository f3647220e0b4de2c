// The tables of benchmarks/results/wrench_spaces.md: what epsilon of the other wrench spaces costs
// and how narrow its bracket is, and how far pyramids are below exact cones. By family, grasps that
// hold.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "benchmarks/sim/quality/families_by_size.h"
#include "sim/quality/wrench_space.h"

namespace {

using prehend::EpsilonBracket;
using prehend::EpsilonOptions;
using prehend::EpsilonStatus;
using prehend::FrictionCone;
using prehend::Random;
using prehend::WrenchNorm;
using prehend::WrenchSpaceOptions;
using prehend::benchmark::Family;
using prehend::test::Contacts;

constexpr int kGrasps = 30;  // that hold, of a family
constexpr int kTries = 300;
constexpr int kRepeats = 3;

struct Space {
  const char* name;
  WrenchSpaceOptions options;
};

constexpr Space kSpaces[] = {
    {"L1, exact cone", {.norm = WrenchNorm::l1, .cone = FrictionCone::exact}},
    {"L-infinity, pyramid", {.norm = WrenchNorm::linf, .cone = FrictionCone::pyramid}},
    {"L-infinity, exact cone", {.norm = WrenchNorm::linf, .cone = FrictionCone::exact}},
};

// Those of the epsilon benchmark and two more that are as symmetric as grasps get.
std::vector<Family> all_families() {
  std::vector<Family> families = prehend::benchmark::families_by_size();
  families.push_back({"octahedron", 6, 6, [](Random&, int, double friction) {
                        return prehend::test::octahedron_grasp(friction);
                      }});
  families.push_back({"cube", 8, 8, [](Random&, int, double friction) {
                        return prehend::test::cube_grasp(friction);
                      }});
  return families;
}

// The `part` quantile: the value below which that part of the values lies.
double quantile(std::vector<double> values, double part) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const auto at = static_cast<std::size_t>(part * static_cast<double>(values.size()));
  return values[std::min(at, values.size() - 1)];
}

double width(const EpsilonBracket& bracket) {
  return (bracket.upper - bracket.lower) / bracket.upper;
}

// Grasps of the family that hold with exact cones; none where it has none of that many contacts.
std::vector<Contacts> holding_grasps(const Family& family, int contacts) {
  std::vector<Contacts> grasps;
  if (contacts < family.fewest || contacts % family.multiple != 0) return grasps;
  Random random(static_cast<std::uint64_t>(contacts));
  for (int i = 0; i < kTries && grasps.size() < kGrasps; ++i) {
    Contacts grasp = family.make(random, contacts, random.uniform(0.3, 1.0));
    if (grasp.size() != static_cast<std::size_t>(contacts)) return {};
    if (grasp_epsilon(grasp, {}, kSpaces[0].options).force_closure()) grasps.push_back(grasp);
  }
  return grasps;
}

// The last bracket of several calls, and their median microseconds.
struct Measured {
  EpsilonBracket bracket;
  double microseconds = 0.0;
};

Measured measure(const Contacts& contacts, const WrenchSpaceOptions& space) {
  Measured measured;
  std::vector<double> times;
  for (int i = 0; i < kRepeats; ++i) {
    const auto start = std::chrono::steady_clock::now();
    measured.bracket = grasp_epsilon(contacts, {}, space);
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
    times.push_back(took.count());
  }
  measured.microseconds = quantile(times, 0.5);
  return measured;
}

// One row of the table of costs.
void print_cost(const std::string& family, int contacts, std::span<const Contacts> grasps,
                const Space& space) {
  std::vector<double> times;
  std::vector<double> widths;
  int limited = 0;
  for (const Contacts& grasp : grasps) {
    const Measured measured = measure(grasp, space.options);
    if (!measured.bracket.force_closure()) continue;
    times.push_back(measured.microseconds);
    widths.push_back(width(measured.bracket));
    limited += measured.bracket.status == EpsilonStatus::limit ? 1 : 0;
  }
  std::printf("| %s | %d | %.0f | %.0f | %.0f | %.2g %% | %.2g %% | %d of %zu |\n", family.c_str(),
              contacts, quantile(times, 0.5), quantile(times, 0.9), quantile(times, 1.0),
              100.0 * quantile(widths, 0.5), 100.0 * quantile(widths, 1.0), limited, times.size());
}

void print_costs(const Space& space) {
  std::printf("\n## %s\n\n", space.name);
  std::printf(
      "| family | contacts | us, median | 90 %% | largest | width, median | largest | limit |\n"
      "|---|---|---|---|---|---|---|---|\n");
  for (const int contacts : {4, 6, 8, 16}) {
    for (const Family& family : all_families()) {
      const std::vector<Contacts> grasps = holding_grasps(family, contacts);
      if (!grasps.empty()) print_cost(family.name, contacts, grasps, space);
    }
  }
}

// One row of the table of pyramids: L1, all grasps of 3 to 8 contacts that hold with exact cones.
void print_pyramid(const Family& family) {
  constexpr EpsilonOptions kFine = {
      .relative_tolerance = 1e-3, .max_facets = 100000, .descent_steps = 12};
  std::vector<double> below;
  std::vector<double> widths;
  int exact_only = 0;
  for (const int contacts : {3, 4, 6, 8}) {
    for (const Contacts& grasp : holding_grasps(family, contacts)) {
      const EpsilonBracket pyramid = grasp_epsilon(grasp, {});
      if (!pyramid.force_closure()) {
        ++exact_only;
        continue;
      }
      const EpsilonBracket exact = grasp_epsilon(grasp, {}, kSpaces[0].options, kFine);
      below.push_back(1.0 - pyramid.lower / exact.upper);
      widths.push_back(width(exact));
    }
  }
  std::printf("| %s | %zu | %.1f %% | %.1f %% | %.2g %% | %d |\n", family.name.c_str(),
              below.size() + static_cast<std::size_t>(exact_only), 100.0 * quantile(below, 0.5),
              100.0 * quantile(below, 1.0), 100.0 * quantile(widths, 1.0), exact_only);
}

}  // namespace

int main() {
  std::printf("## Pyramids of 8 edges below exact cones, L1\n\n");
  std::printf(
      "| family | grasps | below, median | worst | widest bracket | hold with the exact cone only "
      "|\n|---|---|---|---|---|---|\n");
  for (const Family& family : all_families()) print_pyramid(family);
  for (const Space& space : kSpaces) print_costs(space);
}
