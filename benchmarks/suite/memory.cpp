#include "benchmarks/suite/memory.h"

#include <cstdio>
#include <memory>

#include "benchmarks/report/names.h"
#include "benchmarks/suite/planning.h"
#include "benchmarks/suite/scaling_scenes.h"
#include "benchmarks/support/resources.h"
#include "planner/plan/run_trials.h"
#include "sim/base/input_error.h"

namespace prehend::bench {
namespace {

// The word as the shell takes it, whatever is in it.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char letter : word)
    text += letter == '\'' ? std::string("'\\''") : std::string{letter};
  return text + "'";
}

void try_some(const CompiledScene& scene, const std::vector<Candidate>& candidates) {
  (void)run_trials(scene, candidates, {}, {.threads = 1});
}

}  // namespace

double memory_here(const MemoryCase& what) {
  if (what.size == kTriangles) {
    const CompiledScene scene = scene_of_triangles(what.value);
    try_some(scene, propose(scene, what.trials));
  } else if (what.size == kCandidates) {
    const CompiledScene scene = scene_of_candidates();
    try_some(scene, propose(scene, what.value));
  } else if (what.size == kObstacles) {
    const CompiledScene scene = scene_of_obstacles(what.value);
    try_some(scene, propose(scene, what.trials));
  } else {
    throw InputError("memory is measured of triangles, candidates and obstacles");
  }
  return benchmark::most_megabytes();
}

std::optional<double> memory_elsewhere(const std::string& program, const MemoryCase& what) {
  const std::string command = quoted(program) + " memory " + what.size + " " +
                              std::to_string(what.value) + " " + std::to_string(what.trials);
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  double megabytes = 0.0;
  if (!pipe || std::fscanf(pipe.get(), "%lf", &megabytes) != 1) return std::nullopt;
  if (!(megabytes > 0.0)) return std::nullopt;
  return megabytes;
}

}  // namespace prehend::bench
