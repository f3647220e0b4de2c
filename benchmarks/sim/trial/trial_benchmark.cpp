// What one trial costs on one core: all / ended with contacts / hold, with percentiles; what it
// would cost if qhull judged the contacts, and whether the ranking would be the same.
//   trial_benchmark [SCENE | MESH] [HAND]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <numeric>
#include <vector>

#include "benchmarks/support/percentile.h"
#include "planner/propose/candidates.h"
#include "planner/search/plan.h"
#include "sim/quality/wrench_hull.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_library.h"

namespace {

using prehend::CompiledScene;
using prehend::Outcome;
using prehend::Trial;
using prehend::benchmark::Clock;
using prehend::benchmark::milliseconds_since;
using prehend::benchmark::percentile;

void print(const char* what, const std::vector<double>& milliseconds) {
  std::printf("%-24s %6zu   median %7.2f ms   p90 %7.2f ms   p99 %7.2f ms\n", what,
              milliseconds.size(), percentile(milliseconds, 0.5), percentile(milliseconds, 0.9),
              percentile(milliseconds, 0.99));
}

// The same trial, judged by the full hull: what its last contacts cost is exchanged.
struct ByHull {
  double milliseconds = 0.0;
  double epsilon = 0.0;
};

ByHull judge_by_hull(const CompiledScene& scene, const Trial& trial, double took) {
  const auto wrenches =
      prehend::contact_wrenches(prehend::contacts_of(trial.contacts), scene.wrench_frame);
  auto start = Clock::now();
  (void)prehend::epsilon_l1(wrenches);
  const double growth = milliseconds_since(start);
  start = Clock::now();
  const prehend::WrenchHull hull = prehend::wrench_hull(wrenches);
  return {took - growth + milliseconds_since(start), hull.force_closure() ? hull.min_offset : 0.0};
}

// Places of the two rankings, best first, at which they differ by more than rounding.
int differences(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<std::size_t> by_a(a.size());
  std::iota(by_a.begin(), by_a.end(), std::size_t{0});
  std::vector<std::size_t> by_b = by_a;
  const auto better = [](const std::vector<double>& v) {
    return [&v](std::size_t i, std::size_t j) { return v[i] > v[j]; };
  };
  std::stable_sort(by_a.begin(), by_a.end(), better(a));
  std::stable_sort(by_b.begin(), by_b.end(), better(b));
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const bool differs = by_a[i] != by_b[i];
    if (differs && std::abs(a[by_a[i]] - a[by_b[i]]) > 1e-9 * a[by_a[i]]) ++count;
  }
  return count;
}

void measure(const CompiledScene& scene) {
  const auto primitives = scene.scene.primitives.empty()
                              ? prehend::decompose(scene.scene.object.mesh).primitives
                              : scene.scene.primitives;
  const auto proposals = prehend::propose_grasps(scene, primitives);
  std::vector<double> all;
  std::vector<double> with_contacts;
  std::vector<double> stable;
  std::vector<double> by_hull;
  std::vector<double> epsilons;
  std::vector<double> hull_epsilons;
  for (const prehend::ProposedGrasp& grasp : proposals.grasps) {
    const auto start = Clock::now();
    const Trial trial = prehend::run_trial(scene, grasp.candidate);
    const double took = milliseconds_since(start);
    all.push_back(took);
    if (trial.contacts.empty()) continue;
    with_contacts.push_back(took);
    if (trial.outcome == Outcome::stable) stable.push_back(took);
    const ByHull hull = judge_by_hull(scene, trial, took);
    by_hull.push_back(hull.milliseconds);
    epsilons.push_back(trial.epsilon.lower);
    hull_epsilons.push_back(hull.epsilon);
  }
  print("all trials", all);
  print("ended with contacts", with_contacts);
  print("hold", stable);
  print("judged by qhull", by_hull);
  std::printf("ranking by qhull differs at %d of %zu places\n",
              differences(epsilons, hull_epsilons), epsilons.size());
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const auto file = prehend::find_scene(argc > 1 ? argv[1] : "mug");
    measure(prehend::compile(prehend::load_scene(file, {argc > 2 ? argv[2] : "", "m"})));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "trial_benchmark: %s\n", error.what());
    return 2;
  }
}
