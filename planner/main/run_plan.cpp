#include <cstdint>
#include <iostream>
#include <optional>

#include "planner/main/option_values.h"
#include "planner/main/plan_command.h"
#include "planner/main/plan_output.h"
#include "planner/main/progress_bar.h"
#include "planner/main/requested_scene.h"
#include "planner/main/result_table.h"
#include "planner/main/shared_options.h"
#include "planner/plan/plan.h"
#include "planner/plan/shake_grasps.h"
#include "planner/results/grasps_file.h"
#include "planner/show/exports/export_files.h"
#include "planner/show/exports/export_formats.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/joined.h"
#include "sim/base/output_file.h"
#include "sim/manipulation/grasp_world.h"

namespace prehend {
namespace {

void declare_paths(CLI::App& command, PlanCommand& options) {
  CLI::Option* path =
      command.add_flag("--path", options.path, "plan the arm's way to each grasp as well");
  add_second_check(command, options.no_second_check);
  command.add_option("--path-planner", options.path_planner, "how ways are searched for")
      ->check(CLI::IsMember(texts(enum_names(PathPlanner{}))))
      ->needs(path)
      ->capture_default_str();
}

void declare(CLI::App& command, PlanCommand& options) {
  add_examples(command, {"plan mug", "plan bottle.obj --unit mm --hand franka_hand --top 3",
                         "plan panda_on_table --path --export csv,moveit",
                         "plan mug --approach down/30deg --friction 0.6 --budget 2s"});
  command
      .add_option("scene", options.scene,
                  "scene name, scene file, mesh file, or what depth cameras saw")
      ->capture_default_str();
  command.add_option("--hand", options.hand, "robot of the library or robot file");
  add_mesh_options(command, options.unit, options.repair);
  command.add_option("--top", options.top, "grasps to return")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command
      .add_option("--trials", options.trials,
                  "candidates to try at most, 800 for accuracy standard")
      ->check(CLI::Range(1, 1000000));
  command.add_option("--enough", options.enough, "grasps that hold after which the search ends")
      ->check(CLI::Range(1, 1000000));
  command.add_option("--approach", options.approach,
                     "directions in which the hand may move: down, +x, object:1,0,1 or others, and "
                     "the angle around: down/30deg");
  command.add_option("--model", options.model,
                     "file of a model that orders the candidates (docs/how-to/learning.md)");
  command.add_option("--primitive-tolerance", options.primitive_tolerance,
                     "how far the object's surface may be from its primitives, in mm");
  declare_paths(command, options);
  command
      .add_option("--export", options.exports,
                  "more files, with commas: " + joined(export_formats(), ", ", &ExportFormat::name))
      ->delimiter(',')
      ->check(CLI::IsMember(export_names()));
  add_shake(command, options.shake);
  command
      .add_option("--rank", options.rank,
                  "what comes first: larger epsilon, more survived of the tests of --shake, or "
                  "more held of the trials of --uncertainty, or how probably they lift")
      ->check(CLI::IsMember({"epsilon", "shake", "probability", "success"}))
      ->capture_default_str();
  add_uncertainty(command, options.uncertainty);
  add_dynamic(command, options.dynamic);
  command.add_flag("--still", options.still,
                   "judge by hands that close on an object that stands still, as in GraspIt!");
  add_choice(command, options.choice);
  add_friction(command, options.friction);
  command.add_flag("--any", options.any,
                   "whichever object of the scene: plan each among the others, and rank all");
  add_packages(command, options.packages);
  add_common(command, options.common);
  add_accuracy(command, options.common);
  add_contacts(command, options.common);
  add_no_report(command, options.common.no_report);
  command.add_flag_function(
      "--picture,!--no-picture", [&options](std::int64_t count) { options.picture = count > 0; },
      "draw best.png or do without; else it is there where the report is");
}

// Throws InputError for options that do not go together.
void check_together(const PlanCommand& command) {
  const auto check_rank = [&](bool fits, const char* needed) {
    require(fits, {.field = "--rank", .problem = needed, .value = command.rank});
  };
  if (command.rank == "shake") check_rank(!command.shake.empty(), "needs the tests of --shake");
  if (command.rank == "probability" || command.rank == "success") {
    check_rank(command.uncertainty, "needs the trials of --uncertainty");
  }
  require(!command.still || !command.dynamic,
          {.field = "--still", .problem = "not together with --dynamic, where objects give way"});
  require(!command.path || !command.dynamic,
          {.field = "--path",
           .problem = "not together with --dynamic: paths are planned among objects that stand "
                      "still"});
  const auto alone = [&](bool fits, const char* option) {
    require(fits || !command.any,
            {.field = "--any", .problem = std::string("not together with ") + option});
  };
  alone(command.choice.object.empty(), "--object");
  alone(command.choice.keep_out.empty(), "--keep-out, which is of one object");
  alone(command.choice.preferred.empty(), "--prefer, which is of one object");
  alone(command.shake.empty(), "--shake");
  alone(!command.primitive_tolerance, "--primitive-tolerance, which is of one object");
}

// The steps of the command, with what they share.
class PlanProgram {
 public:
  PlanProgram(const PlanCommand& command, Interrupts& interrupts)
      : command_(command),
        interrupts_(interrupts),
        output_(command, interrupts, command.common.out) {}

  int run() {
    require_writable(output_.folder());
    const std::optional<TestProcedure> procedure = requested_test_procedure(command_.shake);
    const PlanTask task = load_task(command_, object_choice(command_.choice), output_.watch());
    const auto& [scene, record] = task;
    if (procedure) require_support(scene, *procedure);
    PlanResult result = plan_grasps(scene, record.options);
    shake(scene, procedure, result);
    if (result.status == PlanStatus::cancelled) return write_cancelled(scene, result, record);
    const bool late = result.status == PlanStatus::out_of_time;
    if (late && result.tried.empty()) {
      interrupts_.use_up_budget();
      return say_interrupted("nothing is written");
    }
    if (!late && result.status != PlanStatus::complete) {
      // The folder then tells of this object, not of an earlier one.
      output_.write_grasps(scene, result, record);
      output_.write_report(scene, result, record);
      throw InputError(no_candidates_text(scene, result));
    }
    output_.write_grasps(scene, result, record);
    print_result(scene, result);
    // Report and pictures can be made from grasps.json later, so an interrupt does not wait for
    // them.
    interrupts_.end_at_once("the grasps are written, not the report and the pictures");
    if (interrupted(result)) return say_interrupted("no report, no pictures");
    output_.write_report(scene, result, record);
    const std::string pictures = output_.write_pictures(scene, result);
    // Written again with the times of report and pictures.
    output_.write_timings(result);
    std::cout << "wrote " << output_.folder().string() << ": " << output_.written()
              << ", timings.json" << pictures << "\n";
    return 0;
  }

 private:
  PlanResult plan_grasps(const CompiledScene& scene, const PlanOptions& options) {
    ProgressBar bar(command_.common.progress);
    // During planning an interrupt keeps what was found: the first one cancels, and plan() returns
    // its finished trials.
    interrupts_.cancel_first();
    PlanResult result =
        plan(scene, options,
             {command_.common.threads, interrupts_.cancellation(),
              [&](const Progress& progress) { bar.show(progress); }, interrupts_.deadline()});
    bar.clear();
    // A stage that the deadline alone does not end was cancelled at the end of the budget.
    const bool time_is_up = interrupts_.unlimit_time();
    if (time_is_up && result.status == PlanStatus::cancelled) {
      result.status = PlanStatus::out_of_time;
    }
    output_.watch().add(result.times);
    return result;
  }

  void shake(const CompiledScene& scene, const std::optional<TestProcedure>& procedure,
             PlanResult& result) {
    if (!procedure || result.grasps.empty() || result.status == PlanStatus::cancelled) return;
    shake_grasps(scene, *procedure,
                 {command_.common.threads, interrupts_.cancellation(), {}, interrupts_.deadline()},
                 result);
    if (command_.rank == "shake") rank_by_shake(result);
    output_.watch().lap(Stage::shake);
  }

  // Writes what is quick to make: no exports, no report and no pictures.
  int write_cancelled(const CompiledScene& scene, const PlanResult& result,
                      const RunRecord& record) {
    const std::size_t tried = result.tried.size();
    if (tried == 0) return say_interrupted("nothing is written");
    output_.write_files(scene.scene, {{"grasps.json", grasps_json(scene, result, record)}});
    output_.write_timings(result);
    print_result(scene, result);
    std::cout << "wrote " << output_.folder().string() << ": " << output_.written()
              << ", timings.json\n";
    return say_interrupted(std::to_string(tried) + " of " +
                           std::to_string(tried + index(result.untested)) +
                           " candidates were tried; no report, no pictures");
  }

  // Whether a signal, not the end of the budget, came after the plan had ended.
  bool interrupted(const PlanResult& result) const {
    return result.status != PlanStatus::out_of_time && interrupts_.cancellation().requested();
  }

  void print_result(const CompiledScene& scene, const PlanResult& result) const {
    std::cout << grasp_table(scene, result, index(command_.top)) << outcome_line(result) << "\n"
              << preferred_line(scene, result) << shapes_line(result) << untested_line(result)
              << blocker_line(result) << advice_lines(result) << std::flush;
  }

  int say_interrupted(const std::string& words) const {
    std::cerr << "prehend: " << interrupts_.reason() << ", " << words << "\n";
    return interrupts_.exit_status();
  }

  const PlanCommand& command_;
  Interrupts& interrupts_;
  PlanOutput output_;
};

int run_plan(const PlanCommand& command, Interrupts& interrupts) {
  check_together(command);
  return command.any ? run_plan_any(command, interrupts) : PlanProgram(command, interrupts).run();
}

}  // namespace

void add_plan(CLI::App& app, CommandRequest& request) {
  add_command(app, request, "plan", "plan grasps of an object and rank them", declare, run_plan);
}

}  // namespace prehend
