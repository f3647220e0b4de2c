// What one trial costs on one core: solved / ended with contacts / all, and percentiles.
//   trial_benchmark [SCENE | MESH] [HAND]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <vector>

#include "planner/candidates.h"
#include "planner/plan.h"
#include "planner/scene_library.h"
#include "sim/scene/scene_file.h"

namespace {

using prehend::CompiledScene;
using prehend::Outcome;
using prehend::Trial;

double percentile(std::vector<double> values, double part) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

void print(const char* what, const std::vector<double>& milliseconds) {
  std::printf("%-24s %6zu   median %7.2f ms   p90 %7.2f ms   p99 %7.2f ms\n", what,
              milliseconds.size(), percentile(milliseconds, 0.5), percentile(milliseconds, 0.9),
              percentile(milliseconds, 0.99));
}

void measure(const CompiledScene& scene) {
  const auto primitives = scene.scene.primitives.empty()
                              ? prehend::decompose(scene.scene.object.mesh).primitives
                              : scene.scene.primitives;
  const auto proposals = prehend::propose_grasps(scene, primitives);
  std::vector<double> all;
  std::vector<double> with_contacts;
  std::vector<double> stable;
  for (const prehend::ProposedGrasp& grasp : proposals.grasps) {
    const auto start = std::chrono::steady_clock::now();
    const Trial trial = prehend::run_trial(scene, grasp.candidate);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    all.push_back(took.count());
    if (!trial.contacts.empty()) with_contacts.push_back(took.count());
    if (trial.outcome == Outcome::stable) stable.push_back(took.count());
  }
  print("all trials", all);
  print("ended with contacts", with_contacts);
  print("hold", stable);
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
