// Whether grasps are what they promise where the object is free on a table, in MuJoCo's opinion:
//
//   carry_out [--grasps N] [--trials N] [--hand NAME]... [--list] [--write FOLDER] OBJECT...
//
// An object is a mesh file or a generated object ("bowl"); it stands on a table. The hand begins at
// the grasp, open, closes with the efforts of the exported file, rises by 20 cm, shakes mildly and
// holds for 5 s. For each hand: of the best grasps of plans how many survive; and of the best
// grasps by the epsilon of an object that stands still, how many survive, and for how many of them
// closing on a free object (free_grasps) says the same. Each disagreement has a line; with --list
// each grasp of plans. --write: each grasp is also a file in that folder, which carry_out.mjs
// carries out in the MuJoCo of Node.js.
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "benchmarks/shake/carry_file.h"
#include "benchmarks/shake/mujoco_shake.h"
#include "benchmarks/shake/opinions.h"
#include "benchmarks/support/word_reader.h"
#include "planner/plan/free_grasps.h"
#include "planner/plan/plan.h"
#include "sim/base/input_error.h"
#include "sim/motion/dynamic_grasp/closing.h"
#include "sim/motion/dynamic_grasp/scene_world.h"
#include "sim/robot/files/robot_file.h"
#include "sim/trial/close_dynamic.h"

namespace prehend::bench {
namespace {

struct Arguments {
  int grasps = 5;
  int trials = 800;
  bool list = false;
  std::string write = {};  // a folder, "": none
  std::vector<std::string> hands;
  std::vector<std::string> objects;
};

Arguments read_arguments(const std::vector<std::string>& words) {
  Arguments arguments;
  WordReader reader(words);
  while (reader.next()) {
    if (reader.word() == "--grasps")
      arguments.grasps = reader.number();
    else if (reader.word() == "--trials")
      arguments.trials = reader.number();
    else if (reader.word() == "--list")
      arguments.list = true;
    else if (reader.word() == "--write")
      arguments.write = reader.text();
    else if (reader.word() == "--hand")
      arguments.hands.push_back(reader.text());
    else
      arguments.objects.push_back(reader.word());
  }
  if (arguments.hands.empty()) {
    arguments.hands = {"franka_hand", "robotiq_2f85", "barrett", "robotiq_3f", "allegro"};
  }
  if (arguments.objects.empty()) arguments.objects = {"mug", "bottle", "box", "phone", "bowl"};
  return arguments;
}

// Close 2 s a stage, up by 20 cm, +-2 cm at 1 Hz along two axes, 5 s at rest. The object fails when
// it falls by 5 cm after it rose.
TestProcedure carrying(const Closing& closing) {
  ProcedurePhase close{.kind = PhaseKind::close, .duration = 2.0 * (1 + closing.stages())};
  ProcedurePhase lift{.kind = PhaseKind::lift, .duration = 1.0, .height = 0.2};
  lift.fails.least_rise = 0.15;
  ProcedurePhase swing{.kind = PhaseKind::swing,
                       .duration = 1.0,
                       .axis = Vector3::UnitX(),
                       .amplitude = 0.02,
                       .frequency = 1.0};
  swing.fails.dropped = 0.05;
  ProcedurePhase across = swing;
  across.axis = Vector3::UnitY();
  ProcedurePhase hold{.kind = PhaseKind::hold, .duration = 5.0};
  hold.fails.dropped = 0.05;
  TestProcedure procedure;
  procedure.name = "carry";
  procedure.on_support = true;
  procedure.gravity = {0.0, 0.0, -9.81};
  procedure.tests = {{"carry", {close, lift, swing, across, hold}}};
  return procedure;
}

struct Tally {
  int grasps = 0;
  int survived = 0;
  int agreed = 0;
};

class HandRun {
 public:
  HandRun(std::string hand, const Arguments& arguments)
      : hand_(std::move(hand)), arguments_(arguments) {}

  void add(const std::string& object) {
    ShakeCase shaken = shake_case(object + ":" + hand_, arguments_.trials, arguments_.grasps, true);
    for (const ShakenGrasp& grasp : shaken.grasps) count(shaken, grasp, "free", free_);
    PlanOptions options;
    options.search.trials = arguments_.trials;
    options.rank.top = arguments_.grasps;
    options.volumes = false;
    options.free_closing = 0;
    const std::shared_ptr<const RobotModel> hand = hand_model(shaken.scene);
    int rank = 0;
    for (ScoredGrasp& grasp : plan(shaken.scene, options).grasps) {
      grasp.free =
          closed_freely(shaken.scene, hand, grasp.candidate, grasp.trial, options.trial, {});
      count(shaken, {std::move(grasp), ++rank}, "still", still_);
    }
  }

  void print() const {
    std::printf("%-16s of plans %3d of %3d survive; by epsilon %3d of %3d, %3d agreed\n",
                hand_.c_str(), free_.survived, free_.grasps, still_.survived, still_.grasps,
                still_.agreed);
    std::fflush(stdout);
  }

 private:
  void count(const ShakeCase& shaken, const ShakenGrasp& grasp, const char* of,
             Tally& tally) const {
    MujocoRun run;
    run.clutches = true;
    run.start.open = true;
    const Robot& hand = shaken.scene.scene.hand;
    const TestProcedure procedure =
        carrying(Closing(hand, strategy_of(hand, grasp.grasp.candidate)));
    const MujocoCase model = mujoco_case(shaken, grasp, procedure, run);
    const ShakeResult result = shake_in_mujoco(model.mjcf, procedure, model.subject, run.start);
    const bool survived = result.tests.size() == 1 && result.tests.front().survived();
    const bool predicted = grasp.grasp.free && keeps_object(shaken.scene, *grasp.grasp.free);
    ++tally.grasps;
    tally.survived += survived ? 1 : 0;
    tally.agreed += survived == predicted ? 1 : 0;
    if (!arguments_.write.empty()) {
      write_carry_file(arguments_.write,
                       {.hand = hand_,
                        .object = shaken.scene.scene.object.name,
                        .of = of,
                        .rank = grasp.rank,
                        .predicted = predicted,
                        .survived = survived},
                       model, procedure);
    }
    if (survived == predicted && !(arguments_.list && &tally == &free_)) return;
    const ShakeTestResult& test = result.tests.empty() ? result.prepare : result.tests.front();
    const std::optional<FreeEnd> end =
        grasp.grasp.free ? free_end(shaken.scene, *grasp.grasp.free) : std::nullopt;
    const std::string strategy = strategy_of(hand, grasp.grasp.candidate).name;
    std::printf(
        "  %-24s %-5s rank %d%s%s: here %s, epsilon %.3f, moved %.1f mm; "
        "in MuJoCo %s in phase %zu, moved %.1f mm\n",
        shaken.name.c_str(), of, grasp.rank, strategy.empty() ? "" : ", ", strategy.c_str(),
        grasp.grasp.free ? std::string(name_of(grasp.grasp.free->outcome)).c_str() : "-",
        end ? end->epsilon : 0.0, end ? 1e3 * end->moved : 0.0,
        std::string(name_of(test.phases.back().failure)).c_str(), test.phases.size(),
        1e3 * test.phases.front().measure.moved);
    std::fflush(stdout);
  }

  std::string hand_;
  const Arguments& arguments_;
  Tally free_;
  Tally still_;
};

int run(const std::vector<std::string>& words) {
  const Arguments arguments = read_arguments(words);
  for (const std::string& hand : arguments.hands) {
    HandRun of_hand(hand, arguments);
    for (const std::string& object : arguments.objects) {
      try {
        of_hand.add(object);
      } catch (const InputError& error) {
        std::printf("  %s, %s left out: %s\n", object.c_str(), hand.c_str(), error.what());
      }
    }
    of_hand.print();
  }
  return 0;
}

}  // namespace
}  // namespace prehend::bench

int main(int count, char** words) {
  try {
    return prehend::bench::run({words + 1, words + count});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "carry_out: %s\n", error.what());
    return 1;
  }
}
