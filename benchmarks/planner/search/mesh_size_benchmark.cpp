// How the time and the memory of a plan grow with the number of triangles of the object, and how
// long meshes of your own take. Processor time of all threads; the same candidates for all sizes
// of one object as far as its primitives are the same.
//   mesh_size_benchmark [MESH UNIT]...
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "benchmarks/support/percentile.h"
#include "benchmarks/support/resources.h"
#include "planner/search/plan.h"
#include "sim/geometry/object_generator.h"
#include "sim/scene/make_scene.h"
#include "sim/scene/scene_file.h"

namespace {

using namespace prehend;  // NOLINT(google-build-using-namespace): a program of its own

// Prints one row. `make` reads or generates the scene, which counts as well.
template <typename Make>
void measure(const std::string& name, const std::string& hand, const Make& make) {
  benchmark::forget_most_megabytes();
  const double start = benchmark::processor_seconds();
  const CompiledScene scene = compile(make());
  const double ready = benchmark::processor_seconds();
  const PlanResult result = plan(scene);
  const double end = benchmark::processor_seconds();
  const double trials = result.trial_seconds.approach + result.trial_seconds.close;
  std::printf("%-28s %-13s %9zu %8.2f %8.2f %7zu %9.1f %7.0f\n", name.c_str(), hand.c_str(),
              scene.object().mesh.mesh().triangles.size(), ready - start, end - start,
              result.tried.size(), 1e3 * trials / static_cast<double>(result.tried.size()),
              benchmark::most_megabytes());
  std::fflush(stdout);
}

void measure_generated(const std::string& hand) {
  for (const char* name : {"mug", "bottle"}) {
    for (const int triangles : {5000, 20000, 80000, 250000, 1000000}) {
      measure(name, hand, [&] {
        return make_scene(make_graspable(name, generate_object(name, triangles), Material::plastic),
                          hand);
      });
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    std::printf("%-28s %-13s %9s %8s %8s %7s %9s %7s\n", "object", "hand", "triangles", "ready s",
                "whole s", "trials", "ms/trial", "MB");
    const std::vector<std::string> words(argv + 1, argv + argc);
    for (const std::string hand : {"parallel_jaw", "franka_hand", "barrett"}) {
      if (words.empty()) measure_generated(hand);
      for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
        measure(words[i].substr(words[i].rfind('/') + 1), hand, [&] {
          return load_scene(words[i], {hand, words[i + 1]});
        });
      }
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mesh_size_benchmark: %s\n", error.what());
    return 1;
  }
}
