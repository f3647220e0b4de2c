#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>
#include <utility>

#include "planner/main/option_values.h"
#include "planner/main/print_notes.h"
#include "planner/main/progress_bar.h"
#include "planner/main/requested_scene.h"
#include "planner/main/shared_options.h"
#include "planner/plan/plan.h"
#include "planner/plan/together/hold_together.h"
#include "planner/results/together_file.h"
#include "planner/show/best_viewpoint.h"
#include "planner/show/grasp_picture.h"
#include "planner/show/posed_grasp.h"
#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/output_file.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_library.h"

namespace prehend {
namespace {

namespace fs = std::filesystem;

// Arguments of `together`.
struct TogetherCommand {
  std::string first;          // name or scene file
  std::string second;         // of the same object, with another hand or arm
  std::optional<int> trials;  // of each hand; empty: those of the accuracy
  int top = 3;
  bool path = false;
  bool no_second_check = false;
  CommonOptions common = {.out = "out/together"};
};

void declare(CLI::App& command, TogetherCommand& options) {
  add_examples(command, {"together crate_left crate_right",
                         "together crate_left crate_right --path --top 1 --out lift"});
  command.add_option("first", options.first, "scene name or scene file of the first hand")
      ->required();
  command
      .add_option("second", options.second,
                  "the same of the second hand, with the same object at the same place")
      ->required();
  command.add_option("--trials", options.trials, "candidates to try at most with each hand")
      ->check(CLI::Range(1, 1000000));
  command.add_option("--top", options.top, "pairs of grasps to return")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command.add_flag("--path", options.path,
                   "plan the ways of both arms, one after the other, and the lift of both");
  add_second_check(command, options.no_second_check);
  add_common(command, options.common);
  add_accuracy(command, options.common);
  add_no_report(command, options.common.no_report);
}

// Neither hand has to hold the object by itself: it is not closed on one that is free to move.
PlanOptions options_of(const TogetherCommand& command) {
  constexpr int kMost = 200;
  PlanOptions options = requested_accuracy(command.common.accuracy);
  options.seed = command.common.seed;
  options.free_closing = 0;
  options.volumes = false;
  options.rank.top = kMost;
  if (command.trials) options.search.trials = *command.trials;
  return options;
}

struct LoadedHand {
  CompiledScene scene;
  RunRecord record;
  PlanResult result = {};
};

LoadedHand load_hand(const TogetherCommand& command, const std::string& name) {
  Scene scene = load_scene(name, SceneSource{});
  print_notes(scene);
  require(!command.path || scene.carrier.has_value(),
          {.file = name, .field = "robot", .problem = "--path needs an arm there"});
  RunRecord record;
  record.scene = scene_reference(name);
  record.options = options_of(command);
  return {compile(std::move(scene)), std::move(record)};
}

std::string times_text(double strength) {
  return std::isfinite(strength) ? formatted("%.2f", strength) : "any";
}

void print(const TogetherResult& result) {
  if (!result.grasps.empty()) {
    std::cout << formatted("%4s  %8s  %8s  %17s  %9s\n", "rank", "epsilon", "x weight", "alone",
                           "rises [m]");
  }
  for (std::size_t i = 0; i < result.grasps.size(); ++i) {
    const SharedGrasp& pair = result.grasps[i];
    const std::string alone = times_text(pair.alone[0]) + ", " + times_text(pair.alone[1]);
    std::cout << formatted("%4zu  %8.4f  %8s  %17s  %9.3f\n", i + 1, pair.epsilon.lower,
                           times_text(pair.strength).c_str(), alone.c_str(), pair.lift.risen);
  }
  std::cout << formatted(
      "%d pairs of grasps: %d whose robots are apart, %d of these bear the weight, %d lifted in "
      "simulation, of which %d kept the object\n",
      result.pairs, result.apart, result.bear, result.tried, result.lifted);
}

// What ended the pairs, and what may help.
std::string why_none(const TogetherCommand& command, const std::array<HandPlan, 2>& plans,
                     const TogetherResult& result) {
  for (std::size_t side = 0; side < 2; ++side) {
    if (!plans[side].result.grasps.empty()) continue;
    return (side == 0 ? command.first : command.second) +
           " has no grasp in force closure: see what `plan` says of it";
  }
  if (result.apart == 0) return "the robots meet in all pairs: move one of them in its scene file";
  if (result.bear == 0) return "no pair bears the weight: a lighter object or stronger hands";
  if (result.lifted == 0)
    return "the object slipped from all pairs: more friction, or more --trials";
  return "no pair has ways for both arms: move one of them in its scene file, or another --seed";
}

class TogetherProgram {
 public:
  TogetherProgram(const TogetherCommand& command, Interrupts& interrupts)
      : command_(command),
        interrupts_(interrupts),
        folder_(command.common.out),
        hands_{load_hand(command, command.first), load_hand(command, command.second)} {}

  int run() {
    require_pair(hands_[0].scene, hands_[1].scene, command_.path);
    interrupts_.end_at_once("nothing is written");
    ProgressBar bar(command_.common.progress);
    const RunContext context{command_.common.threads, interrupts_.cancellation(),
                             [&](const Progress& progress) { bar.show(progress); },
                             interrupts_.deadline()};
    for (LoadedHand& hand : hands_) hand.result = plan(hand.scene, hand.record.options, context);
    TogetherOptions options;
    options.top = command_.top;
    if (command_.path) {
      options.paths.emplace();
      options.paths->transfer.seed = command_.common.seed;
      options.paths->check.collisions = !command_.no_second_check;
    }
    const std::array<HandPlan, 2> plans = {
        {{hands_[0].scene, hands_[0].result}, {hands_[1].scene, hands_[1].result}}};
    const TogetherResult result = hold_together(
        plans, options, {command_.common.threads, interrupts_.cancellation(), {}, {}});
    bar.clear();
    make_folder(folder_);
    interrupts_.write(folder_ / "together.json",
                      together_json(plans, {hands_[0].record, hands_[1].record}, result));
    remove_regular_files(folder_, [](const std::string& name) { return name == "best.png"; });
    print(result);
    if (result.grasps.empty()) {
      std::cout << "no grasp of both hands: " << why_none(command_, plans, result) << "\n";
      return 1;
    }
    std::string names = "together.json";
    if (!command_.common.no_report) {
      draw_best(plans, result.grasps.front());
      names += ", best.png";
    }
    std::cout << "wrote " << folder_.string() << ": " << names << "\n";
    return 0;
  }

 private:
  void draw_best(const std::array<HandPlan, 2>& plans, const SharedGrasp& pair) const {
    std::vector<PosedGrasp> posed;
    for (std::size_t side = 0; side < 2; ++side) {
      posed.push_back(posed_grasp(plans[side].scene, plans[side].result.grasps[pair.grasps[side]]));
      posed.back().weakest.setZero();
      if (pair.paths) posed.back().arm_joints = pair.paths->reach[side].positions.back();
    }
    posed[0].title = formatted("two hands: epsilon %.4f, %s times the weight", pair.epsilon.lower,
                               times_text(pair.strength).c_str());
    const Image image =
        shared_grasp_picture({&plans[0].scene, &plans[1].scene}, {posed[0], posed[1]},
                             best_viewpoint(plans[0].scene, posed[0]), kGraspPicture,
                             {.threads = command_.common.threads});
    interrupts_.write(folder_ / "best.png", png_bytes(image));
  }

  const TogetherCommand& command_;
  Interrupts& interrupts_;
  fs::path folder_;
  std::array<LoadedHand, 2> hands_;
};

int run_together(const TogetherCommand& command, Interrupts& interrupts) {
  require_writable(command.common.out);
  return TogetherProgram(command, interrupts).run();
}

}  // namespace

void add_together(CLI::App& app, CommandRequest& request) {
  add_command(app, request, "together", "plan grasps of two hands that hold one object together",
              declare, run_together);
}

}  // namespace prehend
