#include <algorithm>
#include <numeric>

#include "benchmarks/report/names.h"
#include "benchmarks/suite/memory.h"
#include "benchmarks/suite/parts.h"
#include "benchmarks/suite/patience.h"
#include "benchmarks/suite/planning.h"
#include "benchmarks/suite/record.h"
#include "benchmarks/suite/sample_grasps.h"
#include "benchmarks/suite/scaling_scenes.h"
#include "benchmarks/support/percentile.h"
#include "benchmarks/support/resources.h"
#include "planner/plan/run_trials.h"
#include "sim/quality/epsilon.h"
#include "sim/quality/wrench_hull.h"

namespace prehend::bench {
namespace {

using benchmark::Clock;
using benchmark::milliseconds_since;
using benchmark::processor_milliseconds;

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

// Times of the trials that end with contacts.
std::vector<double> times_in_contact(const CompiledScene& scene,
                                     const std::vector<Candidate>& candidates) {
  const TrialOptions options = standard_setting().options.trial;
  std::vector<double> times;
  for (const Candidate& candidate : candidates) {
    std::optional<Trial> trial;
    const double took =
        processor_milliseconds([&] { trial.emplace(run_trial(scene, candidate, options)); });
    if (!trial->contacts.empty()) times.push_back(took);
  }
  return times;
}

void add_memory(const std::string& program, const MemoryCase& what, Record& record) {
  const std::optional<double> megabytes = memory_elsewhere(program, what);
  if (megabytes) record.add(what.size, "memory of the process", "MB", *megabytes, what.value);
}

// A scene that grows in one way: made ready, and trials of the same candidates in it.
void measure_grown(const MemoryCase& what, Scene scene, const std::vector<Candidate>& candidates,
                   const std::string& program, Record& record) {
  record.say(std::to_string(what.value) + " " + what.size);
  CompiledScene compiled;
  const double ready = processor_milliseconds([&] { compiled = compile(std::move(scene)); });
  record.add(what.size, "scene made ready", "ms", ready, what.value);
  record.add(what.size, "trial in contact", "ms", times_in_contact(compiled, candidates),
             what.value);
  add_memory(program, what, record);
}

void measure_triangles(const Sizes& sizes, const std::string& program, Record& record) {
  // The same candidates at all sizes.
  const std::vector<Candidate> candidates = propose(scene_of_triangles(5000), sizes.scaling_trials);
  Patience patience(sizes.longest_point);
  for (const int triangles : sizes.triangles) {
    if (!patience.allows(triangles)) break;
    const Clock::time_point start = Clock::now();
    Scene scene = mug_scene(triangles);
    const double found =
        processor_milliseconds([&] { (void)decompose(scene.object.mesh, {}, {.threads = 1}); });
    record.add(kTriangles, "primitives found", "ms", found, triangles);
    measure_grown({kTriangles, triangles, sizes.scaling_trials}, std::move(scene), candidates,
                  program, record);
    patience.took(triangles, 1e-3 * milliseconds_since(start));
  }
}

void measure_obstacles(const Sizes& sizes, const std::string& program, Record& record) {
  const std::vector<Candidate> candidates = propose(scene_of_obstacles(0), sizes.scaling_trials);
  Patience patience(sizes.longest_point);
  for (const int obstacles : sizes.obstacles) {
    if (!patience.allows(obstacles)) break;
    const Clock::time_point start = Clock::now();
    measure_grown({kObstacles, obstacles, sizes.scaling_trials}, scene_among(obstacles), candidates,
                  program, record);
    patience.took(obstacles, 1e-3 * milliseconds_since(start));
  }
}

void measure_candidates(const Sizes& sizes, const std::string& program, Record& record) {
  const CompiledScene scene = scene_of_candidates();
  const std::vector<Primitive> primitives = primitives_of(scene);
  Patience proposing(sizes.longest_point);
  Patience trying(sizes.longest_point);
  for (const int wanted : sizes.candidates) {
    if (!proposing.allows(wanted)) break;
    record.say(std::to_string(wanted) + " candidates");
    std::vector<Candidate> candidates;
    const double proposed =
        processor_milliseconds([&] { candidates = propose(scene, primitives, wanted); });
    proposing.took(wanted, 1e-3 * proposed);
    if (candidates.size() < static_cast<std::size_t>(wanted)) break;  // the rules have no more
    record.add(kCandidates, "candidates proposed", "ms", proposed, wanted);
    if (!trying.allows(wanted)) continue;
    std::vector<std::optional<Trial>> results;
    const double tried = processor_milliseconds([&] {
      results = run_trials(scene, candidates, standard_setting().options.trial, {.threads = 1});
    });
    trying.took(wanted, 1e-3 * tried);
    record.add(kCandidates, "all trials", "ms", tried, wanted);
    std::vector<Trial> trials;
    for (std::optional<Trial>& trial : results) {
      if (trial) trials.push_back(std::move(*trial));
    }
    record.add(kCandidates, "ranked", "ms", processor_milliseconds([&] { (void)rank(trials, {}); }),
               wanted);
    // The process does all trials once more.
    add_memory(program, {kCandidates, wanted, 0}, record);
  }
}

// Times of one call for each of some grasps of that many contacts.
template <typename Call>
void measure_quality(const std::string& series, const Sizes& sizes, Record& record,
                     const Call& call) {
  Patience patience(sizes.longest_point);
  for (const int contacts : sizes.contacts) {
    if (!patience.allows(contacts)) break;
    std::vector<double> times;
    for (const std::vector<Contact>& grasp : holding_grasps(contacts, sizes.grasps)) {
      const Wrenches wrenches = contact_wrenches(grasp, {});
      times.push_back(processor_milliseconds([&] { call(wrenches); }));
    }
    record.add(kContacts, series, "ms", times, contacts);
    // The hull in six dimensions grows with the third power of its points at worst.
    patience.took(contacts, 8.0 * 1e-3 * sum_of(times));
  }
}

void measure_contacts(const Sizes& sizes, Record& record) {
  record.say("contacts");
  measure_quality("ε", sizes, record, [](const Wrenches& wrenches) { (void)epsilon_l1(wrenches); });
  measure_quality("hull by qhull", sizes, record,
                  [](const Wrenches& wrenches) { (void)wrench_hull(wrenches); });
}

// Whole plans by the wall clock on 1, 2, 4, ... threads, up to two or the number of processors.
void measure_threads(const Sizes& sizes, int cores, Record& record) {
  const CompiledScene scene = scene_of_triangles(5000);
  const int trials = 10 * sizes.scaling_trials;
  for (int threads = 1; threads <= std::max(2, cores); threads *= 2) {
    record.say(std::to_string(threads) + " threads");
    std::vector<double> plans;
    for (int run = 0; run < sizes.thread_runs; ++run) {
      const Clock::time_point start = Clock::now();
      (void)plan(scene, options_of(standard_setting(), trials, 1), {.threads = threads});
      plans.push_back(milliseconds_since(start));
    }
    record.add(kThreads, "whole plan", "ms", plans, threads);
  }
}

}  // namespace

void measure_scaling(const Sizes& sizes, const std::string& program, int cores,
                     std::vector<Entry>& entries) {
  Record record(kScaling, entries);
  measure_triangles(sizes, program, record);
  measure_candidates(sizes, program, record);
  measure_contacts(sizes, record);
  measure_threads(sizes, cores, record);
  measure_obstacles(sizes, program, record);
}

}  // namespace prehend::bench
