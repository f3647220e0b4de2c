// How soon long calls return after cancellation is requested. Each call runs on one thread, again
// and again, and another thread requests its cancellation at a moment chosen at random; measured is
// the time from the request to the return, which is at most the longest interval between two checks
// plus what the call does with its partial result.
//   cancel_benchmark [ROUNDS]
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "benchmarks/support/percentile.h"
#include "planner/plan/path/grasp_path.h"
#include "planner/plan/plan.h"
#include "planner/results/grasps_file.h"
#include "planner/show/contact_sheet.h"
#include "planner/show/grasp_picture.h"
#include "planner/show/posed_grasp.h"
#include "planner/show/report/plan_report.h"
#include "sim/base/random.h"
#include "sim/quality/robust_epsilon.h"
#include "sim/quality/wrench_space.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/make_scene.h"
#include "sim/scene/scene_file.h"
#include "sim/shape/object_generator.h"
#include "sim/trial/grasp_contacts.h"

namespace {

using namespace prehend;  // NOLINT(google-build-using-namespace): a program of its own
using benchmark::Clock;
using benchmark::milliseconds_since;
using benchmark::percentile;
using Call = std::function<void(const RunContext&)>;

// Milliseconds of a whole call.
double whole(const Call& call) {
  const Clock::time_point start = Clock::now();
  call({.threads = 1});
  return milliseconds_since(start);
}

// Milliseconds from the request to the return of a call that is cancelled after `wait` ms; negative
// where it had returned before.
double after_request(const Call& call, double wait) {
  const RunContext context{.threads = 1};
  Clock::time_point requested;
  std::atomic<bool> running = true;
  bool in_time = false;
  std::thread canceller([&] {
    std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(wait));
    in_time = running;
    requested = Clock::now();
    context.cancellation.request();
  });
  try {
    call(context);
  } catch (const Cancelled&) {
    // The return of calls without a partial result.
  }
  running = false;
  const Clock::time_point returned = Clock::now();
  canceller.join();
  if (!in_time) return -1.0;
  return std::chrono::duration<double, std::milli>(returned - requested).count();
}

void measure(const std::string& name, int rounds, const Call& call) {
  const double length = whole(call);
  Random random(1);
  std::vector<double> times;
  for (int i = 0; i < rounds; ++i) {
    const double time = after_request(call, length * random.uniform());
    if (time >= 0.0) times.push_back(time);
  }
  std::printf("%-40s %9.1f %5zu %8.2f %8.2f %8.2f\n", name.c_str(), length, times.size(),
              percentile(times, 0.5), percentile(times, 0.9), percentile(times, 1.0));
}

Scene scene_of(const TriangleMesh& mesh) {
  return make_scene(make_graspable("object", mesh, Material::plastic), "barrett");
}

void measure_objects(int rounds) {
  for (const int triangles : {5000, 80000, 500000}) {
    const TriangleMesh mesh = generate_object("mug", triangles);
    const std::string size = std::to_string(triangles) + " triangles";
    const Scene scene = scene_of(mesh);
    measure("compile, " + size, rounds,
            [&](const RunContext& context) { (void)compile(scene, context); });
    measure("decompose, " + size, rounds,
            [&](const RunContext& context) { (void)decompose(mesh, {}, context); });
  }
}

void measure_trials(int rounds) {
  const CompiledScene scene = compile(load_scene("mug"));
  const PlanResult planned = plan(scene);
  std::vector<Candidate> candidates;
  std::vector<PosedGrasp> posed;
  for (const ScoredGrasp& grasp : planned.grasps) {
    candidates.push_back(grasp.candidate);
    posed.push_back(posed_grasp(scene, grasp));
  }
  const std::vector<Contact> contacts = contacts_of(planned.grasps.front().trial.contacts);
  measure("propose_grasps", rounds, [&](const RunContext& context) {
    (void)propose_grasps(scene, planned.primitives, 800, {}, context);
  });
  measure("plan", rounds, [&](const RunContext& context) { (void)plan(scene, {}, context); });
  measure("evaluate", rounds,
          [&](const RunContext& context) { (void)evaluate(scene, candidates, {}, context); });
  measure("robust_epsilon", rounds, [&](const RunContext& context) {
    (void)robust_epsilon(contacts, scene.wrench_frame, {}, {}, context);
  });
  measure("plan_report", rounds, [&](const RunContext& context) {
    (void)plan_report(scene, planned, {}, kMostDetailed, context);
  });
  measure("contact_sheet", rounds, [&](const RunContext& context) {
    (void)contact_sheet(scene, posed, 5, kGraspPicture, context);
  });
}

void measure_paths(int rounds) {
  for (const char* name : {"shelf", "living_room"}) {
    const CompiledScene scene = compile(load_scene(name));
    PlanOptions options;
    options.paths.emplace();
    measure(std::string("plan with paths, ") + name, rounds,
            [&](const RunContext& context) { (void)plan(scene, options, context); });
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 40;
    std::printf("%-40s %9s %5s %8s %8s %8s\n", "milliseconds", "whole", "times", "p50", "p90",
                "most");
    measure_objects(rounds);
    measure_trials(rounds);
    measure_paths(rounds);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cancel_benchmark: %s\n", error.what());
    return 1;
  }
  return 0;
}
