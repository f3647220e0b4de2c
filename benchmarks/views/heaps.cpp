// What becomes of the first grasp of a heap of five things:
//
//   heaps_benchmark FILE... [--heaps N] [--hand NAME]
//
// Each of N heaps (10) is of five of the meshes (in metres), dropped on a table, and seen from two
// opposite sides. The first grasp of plan_any on what was seen, without an arm, is carried out on
// what is there, in time: the hand comes as in the plan until it touches, closes on the thing,
// which is free and has its weight, and rises. The other things stand still.
#include <cstdio>
#include <exception>
#include <limits>
#include <string>
#include <vector>

#include "benchmarks/support/resources.h"
#include "benchmarks/views/heap.h"
#include "planner/plan/accuracy.h"
#include "planner/plan/plan_any.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/make_scene.h"
#include "sim/scene/seen_scene.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/nearest_point.h"
#include "sim/trial/perturbed_trials.h"
#include "sim/trial/run_trial.h"

namespace prehend::bench {
namespace {

constexpr double kMass = 0.3;  // of each thing [kg]

struct Words {
  std::vector<std::string> files;
  std::string hand = "franka_hand";
  int heaps = 10;
};

Words read(const std::vector<std::string>& words) {
  Words read;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool more = i + 1 < words.size();
    if (words[i] == "--hand" && more) {
      read.hand = words[++i];
    } else if (words[i] == "--heaps" && more) {
      read.heaps = std::stoi(words[++i]);
    } else if (words[i].starts_with("--")) {
      throw InputError({.field = words[i], .problem = "is no option"});
    } else {
      read.files.push_back(words[i]);
    }
  }
  require(read.files.size() >= 5, {.field = "FILE", .problem = "needs at least five"});
  return read;
}

// Five different ones of the files.
std::vector<std::string> drawn(std::vector<std::string> files, std::uint64_t seed) {
  Random random(seed);
  std::vector<std::string> chosen;
  while (chosen.size() < 5) {
    const std::size_t at = random.index(files.size());
    chosen.push_back(files[at]);
    files.erase(files.begin() + static_cast<std::ptrdiff_t>(at));
  }
  return chosen;
}

double distance_to(const TriangleMesh& mesh, const Vector3& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners corners = corners_of(mesh, static_cast<int>(t));
    nearest = std::min(nearest, (nearest_point_on(corners, p) - p).norm());
  }
  return nearest;
}

// The thing that the contacts of a grasp are nearest to.
std::size_t thing_of(const std::vector<HeapThing>& heap, const Scene& scene, const Trial& trial) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < heap.size(); ++k) {
    double sum = 0.0;
    for (const GraspContact& contact : trial.contacts) {
      sum += distance_to(heap[k].mesh_W, scene.object.X_WO * contact.point.position);
    }
    if (sum >= least) continue;
    least = sum;
    best = k;
  }
  return best;
}

// What is there, with thing `at` to be grasped; frame O is that of the scene that was seen.
CompiledScene true_scene(const std::vector<HeapThing>& heap, std::size_t at, const Scene& seen,
                         const std::string& hand) {
  const Pose& X_WO = seen.object.X_WO;
  Scene scene =
      make_scene(make_graspable(heap[at].name, transformed(heap[at].mesh_W, X_WO.inverse()),
                                Material::plastic, kMass),
                 hand);
  scene.object.X_WO = X_WO;
  for (std::size_t k = 0; k < heap.size(); ++k) {
    if (k == at) continue;
    add_obstacle(scene, heap[k].name, heap[k].mesh_W, Pose::Identity(), Material::plastic);
  }
  add_obstacle(scene, "table", make_box({1.2, 1.2, 0.02}), translation({0.0, 0.0, -0.01}));
  return compile(std::move(scene));
}

struct Tally {
  int heaps = 0;
  int found = 0;
  int clear = 0;  // of found: the hand met nothing but the thing
  int stable = 0;
  int lifted = 0;
};

void try_heap(const Words& words, std::uint64_t seed, Tally& tally) {
  const std::vector<HeapThing> heap = fallen_heap(drawn(words.files, seed), seed);
  AnyPlan any;
  std::vector<Scene> scenes;
  std::size_t things = 0;
  const double time = benchmark::processor_milliseconds([&] {
    const SeenThings seen = seen_things({.views = views_of_heap(heap, 2, seed)});
    things = seen.bodies.objects.size();
    std::vector<CompiledScene> compiled;
    for (std::size_t k = 0; k < things; ++k) {
      Scene scene = make_scene(make_graspable("none", make_box({0.1, 0.1, 0.1}), Material::plastic),
                               words.hand);
      place_seen(seen, k, Material::plastic, kMass, scene);
      scenes.push_back(scene);
      compiled.push_back(compile(std::move(scene)));
    }
    any = plan_any(compiled, plan_options(Accuracy::draft), {.threads = 0});
  });
  ++tally.heaps;
  std::printf("heap %llu: %zu things seen, %.1f s of processor time; ",
              static_cast<unsigned long long>(seed), things, 1e-3 * time);
  if (any.ranked.empty()) {
    std::printf("no grasp\n");
    return;
  }
  ++tally.found;
  const AnyGrasp first = any.ranked.front();
  const ScoredGrasp& grasp = any.results[index(first.scene)].grasps[index(first.grasp)];
  const Scene& seen = scenes[index(first.scene)];
  const std::size_t at = thing_of(heap, seen, grasp.trial);
  const CompiledScene truth = true_scene(heap, at, seen, words.hand);
  const Candidate candidate = replayed_approach(grasp.candidate, grasp.trial, Pose::Identity());
  const Trial still = run_trial(truth, candidate);
  TrialOptions in_time;
  in_time.formation.dynamic = true;
  const Trial lifted = run_trial(truth, candidate, in_time);
  tally.clear += is_blocked(still.outcome) ? 0 : 1;
  tally.stable += still.outcome == Outcome::stable ? 1 : 0;
  tally.lifted += lifted.outcome == Outcome::stable ? 1 : 0;
  std::printf("%s: %s, in time %s\n", heap[at].name.c_str(),
              std::string(name_of(still.outcome)).c_str(),
              std::string(name_of(lifted.outcome)).c_str());
  std::fflush(stdout);
}

void run(const Words& words) {
  Tally tally;
  for (int k = 0; k < words.heaps; ++k) try_heap(words, static_cast<std::uint64_t>(k) + 1, tally);
  std::printf("%d heaps: a grasp of %d, the hand meets nothing else in %d, holds %d, lifts %d\n",
              tally.heaps, tally.found, tally.clear, tally.stable, tally.lifted);
}

}  // namespace
}  // namespace prehend::bench

int main(int count, char** words) {
  try {
    prehend::bench::run(prehend::bench::read({words + 1, words + count}));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "heaps_benchmark: %s\n", error.what());
    return 1;
  }
}
