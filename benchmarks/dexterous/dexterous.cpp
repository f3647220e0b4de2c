// Hands of many joints, as planners for graphics processors are measured: grasps that hold and
// overlap nothing, a second, and how many of the best survive DexGraspBench's pulls in MuJoCo.
//
//   dexterous [--trials N] [--grasps N] [--hand HAND]... MESH...     --grasps 0: no MuJoCo
//
// HAND: a name of the library or a robot file. For each hand a line of a table in Markdown, over
// all meshes. A grasp counts where its trial ended in force closure and FCL finds no link of the
// hand that crosses the object or another link. The time is that of whole plans without free
// closing, volumes and files, on all processors.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/shake/opinions.h"
#include "benchmarks/support/word_reader.h"
#include "planner/plan/path/fcl_mesh.h"
#include "planner/plan/plan.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/parallel/parallel.h"
#include "sim/manipulation/test_procedure_file.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/scene_file.h"

namespace prehend::bench {
namespace {

struct Arguments {
  int trials = 5000;
  int grasps = 10;
  std::vector<std::string> hands;
  std::vector<std::string> meshes;
};

Arguments read_arguments(const std::vector<std::string>& words) {
  Arguments arguments;
  WordReader reader(words);
  while (reader.next()) {
    if (reader.word() == "--trials")
      arguments.trials = reader.number();
    else if (reader.word() == "--grasps")
      arguments.grasps = reader.number();
    else if (reader.word() == "--hand")
      arguments.hands.push_back(reader.text());
    else
      arguments.meshes.push_back(reader.word());
  }
  if (arguments.hands.empty()) arguments.hands = {"allegro", "shadow_like", "dlr"};
  if (arguments.meshes.empty()) {
    throw InputError({.field = "MESH", .problem = "at least one is needed"});
  }
  return arguments;
}

// What one hand did, over all meshes.
struct HandTally {
  int dofs = 0;
  int meshes = 0;
  int trials = 0;
  int holding = 0;      // force closure
  int overlapping = 0;  // of these, in FCL's opinion
  double seconds = 0.0;
  int tried = 0;  // of the best grasps, in MuJoCo
  int survived = 0;
};

// Whether FCL lets some link cross the object or, of those that may not, another link.
class Overlaps {
 public:
  explicit Overlaps(const CompiledScene& scene)
      : robot_(scene.scene.hand), object_(scene.scene.object.mesh) {
    for (const Link& link : robot_.links) links_.emplace_back(link.mesh);
    for (const auto& [a, b] : scene.self_pairs) pairs_.emplace_back(index(a), index(b));
  }

  bool at(const Trial& trial) const {
    RobotPoses poses;
    robot_poses(robot_, trial.joints, poses);
    const Pose X_OO = Pose::Identity();
    for (std::size_t l = 0; l < links_.size(); ++l) {
      if (links_[l].crosses(trial.X_OH * poses.X_BL[l], object_, X_OO)) return true;
    }
    return std::any_of(pairs_.begin(), pairs_.end(), [&](const auto& pair) {
      return links_[pair.first].crosses(poses.X_BL[pair.first], links_[pair.second],
                                        poses.X_BL[pair.second]);
    });
  }

 private:
  const Robot& robot_;
  FclMesh object_;
  std::vector<FclMesh> links_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;
};

// With the friction that the protocol has.
Scene scene_of(const std::string& mesh, const std::string& hand, const TestProcedure& procedure) {
  SceneSource source;
  source.hand = hand;
  source.friction = procedure.friction;
  return load_scene(mesh, source);
}

// As many grasps as there are, not the best: the search goes on beside all that hold.
void search(const std::string& mesh, const std::string& hand, const TestProcedure& procedure,
            int trials, HandTally& tally) {
  const auto start = std::chrono::steady_clock::now();
  const CompiledScene scene = compile(scene_of(mesh, hand, procedure));
  PlanOptions options;
  options.search.trials = trials;
  options.search.settled = 1.0;
  // Beside each grasp that holds others are likely to.
  options.search.local_fraction = 0.9;
  options.search.followed = trials;
  options.search.batch = 128;
  options.refine.trials = 0;
  options.free_closing = 0;
  options.volumes = false;
  std::vector<Trial> found;
  const PlanResult result =
      plan(scene, options, {},
           [&](const Candidate& /*of*/, const Trial& trial) { found.push_back(trial); });
  tally.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  tally.dofs = static_cast<int>(scene.scene.hand.dofs.size());
  tally.trials += static_cast<int>(result.tried.size());
  tally.holding += static_cast<int>(found.size());
  const Overlaps overlaps(scene);
  for (const Trial& trial : found) tally.overlapping += overlaps.at(trial) ? 1 : 0;
}

// The best grasps of a plan as users make it.
void pull(const std::string& mesh, const std::string& hand, const TestProcedure& procedure,
          int grasps, HandTally& tally) {
  constexpr int kTrials = 800;
  const ShakeCase shaken = shake_case(mesh, scene_of(mesh, hand, procedure), kTrials, grasps);
  std::vector<int> survived(shaken.grasps.size(), 0);
  for_each_in_parallel(shaken.grasps.size(), 0, [&](std::size_t i) {
    survived[i] = in_mujoco(shaken, shaken.grasps[i], procedure).survived() ? 1 : 0;
  });
  tally.tried += static_cast<int>(survived.size());
  tally.survived += static_cast<int>(std::count(survived.begin(), survived.end(), 1));
  std::fprintf(stderr, "%s, %s: %td of %zu survive\n", hand.c_str(), mesh.c_str(),
               std::count(survived.begin(), survived.end(), 1), survived.size());
}

void print(const std::string& name, const HandTally& tally) {
  const int good = tally.holding - tally.overlapping;
  std::printf("| %s | %d | %d | %.0f | %.1f %% | %d | **%.0f** | %d of %d (%.0f %%) |\n",
              name.c_str(), tally.dofs, tally.meshes, tally.trials / tally.seconds,
              100.0 * tally.holding / tally.trials, tally.overlapping, good / tally.seconds,
              tally.survived, tally.tried, 100.0 * tally.survived / std::max(tally.tried, 1));
  std::fflush(stdout);
}

int run(const std::vector<std::string>& words) {
  const Arguments arguments = read_arguments(words);
  const TestProcedure procedure = read_test_procedure(find_test_procedure("dexgraspbench"));
  std::printf("| hand | degrees of freedom | objects | trials a second | hold | overlap | ");
  std::printf("grasps a second | survive in MuJoCo |\n|---|---|---|---|---|---|---|---|\n");
  for (const std::string& hand : arguments.hands) {
    HandTally tally;
    for (const std::string& mesh : arguments.meshes) {
      try {
        search(mesh, hand, procedure, arguments.trials, tally);
        if (arguments.grasps > 0) pull(mesh, hand, procedure, arguments.grasps, tally);
        ++tally.meshes;
      } catch (const InputError& error) {
        std::fprintf(stderr, "%s, %s: left out: %s\n", hand.c_str(), mesh.c_str(), error.what());
      }
    }
    if (tally.trials > 0) print(std::filesystem::path(hand).stem().string(), tally);
  }
  return 0;
}

}  // namespace
}  // namespace prehend::bench

int main(int count, char** words) {
  try {
    return prehend::bench::run({words + 1, words + count});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "dexterous: %s\n", error.what());
    return 1;
  }
}
