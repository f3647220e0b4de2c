// How often and how fast ways of an arm are found: the problems of MotionBenchMaker for the Panda
// of the library, on one thread. Prints a line for each kind of scene and one for all.
//   motion_benchmark FOLDER [FIRST]
// FOLDER has a folder for each kind of scene, with sceneNNNN.yaml and requestNNNN.yaml; FIRST: how
// many problems of each (100).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/motion/moveit_problem.h"
#include "benchmarks/support/percentile.h"
#include "benchmarks/support/resources.h"
#include "planner/plan/path/plan_transfer.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/scene/compiled_arm.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/reach/motion_check.h"
#include "sim/scene/scene_file.h"
#include "sim/shape/basic_shapes.h"

namespace {

using namespace prehend;  // NOLINT(google-build-using-namespace): a program of its own
using benchmark::MoveitProblem;
using benchmark::percentile;

// What became of the problems of a kind.
struct Tally {
  int problems = 0;
  int impossible = 0;  // the start or the goal collides or is beyond the limits of this arm
  std::vector<double> milliseconds;  // of those that were solved
  std::vector<double> all_milliseconds;
  std::vector<double> lengths;  // of the ways, over those of the straight lines

  void add(const Tally& other) {
    problems += other.problems;
    impossible += other.impossible;
    const auto append = [](std::vector<double>& to, const std::vector<double>& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    append(milliseconds, other.milliseconds);
    append(all_milliseconds, other.all_milliseconds);
    append(lengths, other.lengths);
  }

  void print(const std::string& name) const {
    std::printf("| %s | %zu of %d | %d | %.1f / %.1f / %.1f | %.2f | %.1f |\n", name.c_str(),
                milliseconds.size(), problems - impossible, impossible,
                percentile(milliseconds, 0.5), percentile(milliseconds, 0.95),
                percentile(milliseconds, 1.0), percentile(lengths, 0.5),
                1e-3 * std::accumulate(all_milliseconds.begin(), all_milliseconds.end(), 0.0));
  }
};

// The arm among the obstacles of a problem, with its hand open and nothing to grasp near it. None
// where it cannot start.
std::optional<CompiledScene> compile_problem(const Scene& base, const MoveitProblem& problem) {
  Scene scene = base;
  scene.obstacles = problem.obstacles;
  scene.object = make_graspable("none", make_box({0.02, 0.02, 0.02}), Material::plastic);
  scene.object.X_WO = translation(Vector3(0.0, 0.0, 10.0));
  scene.carrier->X_WB = Pose::Identity();
  std::size_t k = 0;
  for (const auto& [joint, value] : problem.start) {
    if (joint.starts_with("panda_joint")) scene.carrier->start[k++] = value;
  }
  try {
    return compile(std::move(scene));
  } catch (const InputError&) {
    return std::nullopt;
  }
}

double length(const std::vector<DofValues>& way) {
  double sum = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    double squares = 0.0;
    for (std::size_t k = 0; k < way[i].size(); ++k) {
      squares += (way[i][k] - way[i - 1][k]) * (way[i][k] - way[i - 1][k]);
    }
    sum += std::sqrt(squares);
  }
  return sum;
}

// The way that a problem asks for; none where its goal is impossible for this arm.
std::optional<Transfer> transfer_of(const CompiledArm& arm, const MoveitProblem& problem) {
  // The hand is the last part of the platform.
  const std::vector<double> joints = joint_values(arm.robot(), arm.start);
  Transfer result{
      arm.start, arm.start, {joints.begin() + arm.hand_part().first_joint, joints.end()}};
  std::size_t k = 0;
  for (const auto& [joint, value] : problem.goal) {
    const std::size_t dof = index(arm.dofs[k++]);
    const DegreeOfFreedom& limits = arm.robot().dofs[dof];
    if (value < limits.lower || value > limits.upper) return std::nullopt;
    result.to[dof] = value;
  }
  const std::vector<double> goal = arm_joints(arm, result.to, result.hand_joints);
  if (first_meeting(arm, arm.arm_pairs, goal) || first_meeting(arm, arm.hand_pairs, goal)) {
    return std::nullopt;
  }
  return result;
}

void try_problem(const Scene& base, const MoveitProblem& problem, Tally& tally) {
  ++tally.problems;
  const std::optional<CompiledScene> scene = compile_problem(base, problem);
  std::optional<Transfer> transfer;
  if (scene) transfer = transfer_of(*scene->arm, problem);
  if (!transfer) {
    ++tally.impossible;
    return;
  }
  std::vector<DofValues> way;
  const double milliseconds = benchmark::processor_milliseconds(
      [&] { way = plan_transfer(*scene->arm, *transfer, {}, {.threads = 1}); });
  tally.all_milliseconds.push_back(milliseconds);
  if (way.empty()) return;
  tally.milliseconds.push_back(milliseconds);
  tally.lengths.push_back(length(way) / length({transfer->from, transfer->to}));
}

int run(const std::filesystem::path& folder, int first) {
  const Scene base = load_scene("panda_on_table");
  std::vector<std::filesystem::path> kinds;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.is_directory()) kinds.push_back(entry.path());
  }
  std::sort(kinds.begin(), kinds.end());
  Tally all;
  std::puts("| scenes | solved | impossible | ms median / 95 % / most | length | s in all |");
  std::puts("|--|--|--|--|--|--|");
  for (const std::filesystem::path& kind : kinds) {
    Tally tally;
    for (int i = 1; i <= first; ++i) {
      char number[16];
      std::snprintf(number, sizeof number, "%04d.yaml", i);
      const std::filesystem::path scene = kind / (std::string("scene") + number);
      if (!std::filesystem::exists(scene)) continue;
      try_problem(base,
                  benchmark::read_moveit_problem(scene, kind / (std::string("request") + number)),
                  tally);
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
