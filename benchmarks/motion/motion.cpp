// How often and how fast ways of an arm are found: the problems of MotionBenchMaker for the Panda
// of the library, on one thread. Prints a line for each kind of scene and one for all.
//   motion_benchmark FOLDER [FIRST]
// FOLDER has a folder for each kind of scene, with sceneNNNN.yaml and requestNNNN.yaml; FIRST: how
// many problems of each (100).
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/support/percentile.h"
#include "benchmarks/support/resources.h"
#include "planner/plan/path/arm_path.h"
#include "planner/plan/path/plan_transfer.h"
#include "sim/base/input_error.h"
#include "sim/scene/compiled_arm.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/moveit_scene.h"
#include "sim/scene/reach/motion_check.h"
#include "sim/scene/scene_file.h"

namespace {

using namespace prehend;  // NOLINT(google-build-using-namespace): a program of its own
using benchmark::percentile;

// What became of the problems of a kind.
struct Tally {
  int problems = 0;
  int impossible = 0;  // the start or the goal collides or is beyond the limits of this arm
  std::vector<double> milliseconds;  // of those that were solved
  std::vector<double> all_milliseconds;
  std::vector<double> search_milliseconds;  // without the proof of the way that is returned
  std::vector<double> lengths;              // of the ways, over those of the straight lines
  int refused = 0;                          // by the second check, of those that were solved
  std::vector<double> check_milliseconds;

  void add(const Tally& other) {
    problems += other.problems;
    impossible += other.impossible;
    const auto append = [](std::vector<double>& to, const std::vector<double>& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    append(milliseconds, other.milliseconds);
    append(all_milliseconds, other.all_milliseconds);
    append(search_milliseconds, other.search_milliseconds);
    append(lengths, other.lengths);
    append(check_milliseconds, other.check_milliseconds);
    refused += other.refused;
  }

  void print(const std::string& name) const {
    std::printf("| %s | %zu of %d | %d | %.2f | %.1f / %.1f / %.1f | %.2f | %.1f | %d | %.1f |\n",
                name.c_str(), milliseconds.size(), problems - impossible, impossible,
                percentile(search_milliseconds, 0.5), percentile(milliseconds, 0.5),
                percentile(milliseconds, 0.95), percentile(milliseconds, 1.0),
                percentile(lengths, 0.5),
                1e-3 * std::accumulate(all_milliseconds.begin(), all_milliseconds.end(), 0.0),
                refused, percentile(check_milliseconds, 0.5));
  }
};

// The scene and what is asked of the arm in it.
struct Problem {
  Scene scene;
  NamedJoints goal;
};

Problem read_problem(const std::filesystem::path& scene_file,
                     const std::filesystem::path& request_file) {
  Problem problem{load_scene(scene_file, {.robot = "panda", .needs_object = false}), {}};
  MotionRequest request = read_motion_request(request_file);
  set_start(request.start, problem.scene);
  problem.goal = std::move(request.goal);
  return problem;
}

// None where the arm cannot start.
std::optional<CompiledScene> compile_problem(const Problem& problem) {
  try {
    return compile(problem.scene);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

// The way that a problem asks for; none where its goal is impossible for this arm.
std::optional<Transfer> transfer_of(const CompiledScene& scene, const Problem& problem) {
  const CompiledArm& arm = *scene.arm;
  Scene there = problem.scene;
  set_start(problem.goal, there);
  // The hand is the last part of the platform.
  const std::vector<double> joints = joint_values(arm.robot(), arm.start);
  Transfer result{arm.start,
                  there.carrier->start,
                  {joints.begin() + arm.hand_part().first_joint, joints.end()}};
  for (std::size_t d = 0; d < result.to.size(); ++d) {
    if (!within_limits(arm.robot().dofs[d], result.to[d])) return std::nullopt;
  }
  const std::vector<double> goal = arm_joints(arm, result.to, result.hand_joints);
  if (first_meeting(arm, arm.arm_pairs, goal) || first_meeting(arm, arm.hand_pairs, goal)) {
    return std::nullopt;
  }
  return result;
}

// How long the proof of the lines of a way takes alone [ms].
double proof_milliseconds(const CompiledArm& arm, const Transfer& transfer,
                          const std::vector<DofValues>& way) {
  std::vector<std::vector<double>> path;
  for (const DofValues& dofs : way) path.push_back(arm_joints(arm, dofs, transfer.hand_joints));
  std::vector<ArmPair> pairs = arm.arm_pairs;
  pairs.insert(pairs.end(), arm.hand_pairs.begin(), arm.hand_pairs.end());
  return benchmark::processor_milliseconds([&] { (void)first_blocked(arm, pairs, path); });
}

void try_problem(const Problem& problem, Tally& tally) {
  ++tally.problems;
  const std::optional<CompiledScene> scene = compile_problem(problem);
  std::optional<Transfer> transfer;
  if (scene) transfer = transfer_of(*scene, problem);
  if (!transfer) {
    ++tally.impossible;
    return;
  }
  std::vector<DofValues> way;
  const double milliseconds = benchmark::processor_milliseconds(
      [&] { way = plan_transfer(*scene->arm, *transfer, {}, {.threads = 1}).waypoints; });
  tally.all_milliseconds.push_back(milliseconds);
  if (way.empty()) return;
  tally.milliseconds.push_back(milliseconds);
  tally.search_milliseconds.push_back(milliseconds -
                                      proof_milliseconds(*scene->arm, *transfer, way));
  tally.lengths.push_back(relative_length(way));
  const ArmPath path = plan_arm_path(*scene, {transfer->to}, {}, {.threads = 1});
  tally.refused += int{path.end == ArmPathEnd::refused};
  tally.check_milliseconds.push_back(benchmark::processor_milliseconds(
      [&] { (void)check_path(*scene, path.motion, {}, {.threads = 1}); }));
}

int run(const std::filesystem::path& folder, int first) {
  std::vector<std::filesystem::path> kinds;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.is_directory()) kinds.push_back(entry.path());
  }
  std::sort(kinds.begin(), kinds.end());
  Tally all;
  std::puts(
      "| scenes | solved | impossible | search ms | ms median / 95 % / most | length | s in all | "
      "refused | "
      "check ms |");
  std::puts("|--|--|--|--|--|--|--|--|--|");
  for (const std::filesystem::path& kind : kinds) {
    Tally tally;
    for (int i = 1; i <= first; ++i) {
      char number[16];
      std::snprintf(number, sizeof number, "%04d.yaml", i);
      const std::filesystem::path scene = kind / (std::string("scene") + number);
      if (!std::filesystem::exists(scene)) continue;
      try_problem(read_problem(scene, kind / (std::string("request") + number)), tally);
    }
    tally.print(kind.filename().string());
    std::fflush(stdout);
    all.add(tally);
  }
  all.print("all");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 2) throw InputError("motion_benchmark FOLDER [FIRST]");
    return run(argv[1], argc > 2 ? std::atoi(argv[2]) : 100);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "motion_benchmark: %s\n", error.what());
    return 2;
  }
}
