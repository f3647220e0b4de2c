#include "planner/main/plan_command.h"

#include <memory>
#include <utility>

#include "planner/main/print_notes.h"
#include "planner/main/requested_scene.h"
#include "planner/plan/learn/tree_model_file.h"
#include "planner/show/report/plan_report.h"
#include "sim/base/input_error.h"
#include "sim/base/input_file.h"
#include "sim/robot/files/platform_file.h"
#include "sim/scene/scene_library.h"

namespace prehend {
namespace {

PlanOptions options_of(const PlanCommand& command, const TriangleMesh& object) {
  PlanOptions options = requested_accuracy(command.common.accuracy);
  if (command.primitive_tolerance) {
    options.primitives.tolerance = requested_tolerance(object, *command.primitive_tolerance);
  }
  options.seed = command.common.seed;
  if (command.common.contacts) options.trial.contacts = *command.common.contacts;
  if (command.dynamic) options.trial.formation.dynamic = true;
  if (command.still) options.free_closing = 0;
  options.rank.top = command.top;
  if (command.trials) options.search.trials = *command.trials;
  if (command.enough) options.search.enough = *command.enough;
  if (!command.approach.empty()) {
    options.candidates.approach = requested_approach(command.approach);
  }
  if (!command.path) options.paths.reset();
  if (command.path) {
    if (!options.paths) options.paths.emplace();
    // Paths look for postures of the arm with the same options as trials.
    options.paths->reach = options.trial.reach;
    options.paths->transfer.planner = value_named<PathPlanner>(command.path_planner).value();
    options.paths->check.collisions = !command.no_second_check;
  }
  if (!command.common.no_report) options.sections = kMostDetailed;
  if (command.uncertainty) options.robustness = true;
  if (command.rank == "probability") options.rank.by = RankBy::probability;
  if (command.rank == "success") options.rank.by = RankBy::success;
  return options;
}

// Has the command's model order the candidates, where it names one. Throws InputError for a model
// that does not fit it.
void add_model(const PlanCommand& command, const CompiledScene& scene, PlanOptions& options) {
  if (command.model.empty()) return;
  auto model = std::make_shared<const TreeModel>(read_tree_model(command.model));
  try {
    require_fit(*model, scene.scene.hand.name);
  } catch (const InputError& error) {
    throw error.in_file(command.model);
  }
  options.search.learned = LearnedOrder{.model = std::move(model)};
}

// Where no arm carries the hand: what is missing and where it is stated.
[[noreturn]] void refuse_paths(const PlanCommand& command, const Scene& scene) {
  const std::string& hand = scene.hand_source;
  const bool has_arm =
      is_file(hand) && find_platform(hand, foreign_options(command.packages, {})).robots.size() > 1;
  const std::string problem =
      has_arm ? hand +
                    " has an arm, but nothing says where it stands and where the object lies: "
                    "write a scene file, {\"object\": {\"mesh\": FILE, \"unit\": \"m\", "
                    "\"pose\": {\"position\": [0.5, 0, 0.1]}}, \"robot\": {\"platform\": " +
                    "\"" + hand + "\"}}, and plan that"
              : "no arm to plan paths for, the hand flies free; a scene file names one in "
                "\"robot\", as docs/reference/scene-file.md says";
  throw InputError({.file = scene.name, .field = "--path", .problem = problem});
}

}  // namespace

SceneSource source_of(const PlanCommand& command, const ObjectChoice& choice) {
  return {.hand = command.hand,
          .unit = command.unit,
          .repair = command.repair,
          .foreign = foreign_options(command.packages, {}),
          .choice = choice,
          .friction = command.friction};
}

PlanTask load_task(const PlanCommand& command, const ObjectChoice& choice, Stopwatch& watch) {
  return make_task(command, choice, load_scene(command.scene, source_of(command, choice)), watch);
}

PlanTask make_task(const PlanCommand& command, const ObjectChoice& choice, Scene loaded,
                   Stopwatch& watch) {
  const std::string unit = unit_of_source(command.scene, loaded);
  print_notes(loaded);
  if (command.path && !loaded.carrier) refuse_paths(command, loaded);
  watch.lap(Stage::load);
  CompiledScene scene = compile(std::move(loaded));
  watch.lap(Stage::compile);
  RunRecord record{scene_reference(command.scene),
                   unit,
                   command.hand,
                   options_of(command, scene.scene.object.mesh),
                   command.repair,
                   choice,
                   command.friction};
  add_model(command, scene, record.options);
  return {std::move(scene), std::move(record)};
}

}  // namespace prehend
