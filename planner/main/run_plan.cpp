#include <cstdint>
#include <iostream>
#include <optional>

#include "planner/main/option_values.h"
#include "planner/main/print_notes.h"
#include "planner/main/progress_bar.h"
#include "planner/main/requested_scene.h"
#include "planner/main/result_table.h"
#include "planner/main/shared_options.h"
#include "planner/plan/learn/tree_model_file.h"
#include "planner/plan/plan.h"
#include "planner/plan/shake_grasps.h"
#include "planner/results/grasps_file.h"
#include "planner/results/timings_file.h"
#include "planner/show/best_viewpoint.h"
#include "planner/show/exports/export_files.h"
#include "planner/show/exports/export_formats.h"
#include "planner/show/exports/result_files.h"
#include "planner/show/grasp_picture.h"
#include "planner/show/posed_grasp.h"
#include "planner/show/report/plan_report.h"
#include "planner/show/report/report_html.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/joined.h"
#include "sim/base/output_file.h"
#include "sim/manipulation/grasp_world.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_library.h"

namespace prehend {
namespace {

// Arguments of `plan`.
struct PlanCommand {
  std::string scene = "mug";  // name, scene file or mesh file
  std::string hand;           // empty: the scene's
  std::string unit;           // empty: the likely one
  bool repair = true;         // of an object's mesh file
  int top = 10;
  std::optional<int> trials;  // empty: those of the accuracy
  std::optional<int> enough;  // grasps that hold, after which the search ends; as above
  std::string approach;       // directions in which hands may move; empty: all
  std::string model;          // file of a model that orders the candidates; empty: none
  bool path = false;          // paths of the arm as well
  std::string path_planner = "rrt_connect";
  std::optional<double> primitive_tolerance;  // mm; empty: that of DecomposeOptions
  std::vector<std::string> exports;           // formats besides grasps.json
  std::string shake;                          // protocol: name or file; empty: none
  bool uncertainty = false;                   // grasps are tried again on disturbed poses
  std::string rank = "epsilon";               // "shake", "probability", "success"
  bool dynamic = false;                       // hands close in time, on an object that gives way
  bool still = false;                         // hands are judged on an object that stands still
  std::vector<std::string> packages;          // of a hand or platform: NAME=FOLDER
  ChoiceWords choice;
  std::optional<bool> picture;  // of the best grasp; empty: where there is a report
  CommonOptions common;
};

void declare(CLI::App& command, PlanCommand& options) {
  command.add_option("scene", options.scene, "scene name, scene file or mesh file")
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
  CLI::Option* path =
      command.add_flag("--path", options.path, "plan the arm's way to each grasp as well");
  command.add_option("--path-planner", options.path_planner, "how ways are searched for")
      ->check(CLI::IsMember(texts(enum_names(PathPlanner{}))))
      ->needs(path)
      ->capture_default_str();
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
  add_packages(command, options.packages);
  add_common(command, options.common);
  add_accuracy(command, options.common);
  add_contacts(command, options.common);
  add_no_report(command, options.common.no_report);
  command.add_flag_function(
      "--picture,!--no-picture", [&options](std::int64_t count) { options.picture = count > 0; },
      "draw best.png or do without; else it is there where the report is");
}

// Pictures of the best grasp, by file name, from `side` if it is known already.
std::vector<std::pair<std::string, Image>> best_pictures(const CompiledScene& scene,
                                                         const PlanResult& result,
                                                         const std::optional<Vector3>& side) {
  std::vector<std::pair<std::string, Image>> pictures;
  if (result.grasps.empty()) return pictures;
  const ScoredGrasp& best = result.grasps.front();
  const PosedGrasp posed = posed_grasp(scene, best, grasp_title(best, 1));
  pictures.emplace_back("best.png",
                        grasp_picture(scene, posed, side ? *side : best_viewpoint(scene, posed)));
  if (scene.arm) pictures.emplace_back("best_arm.png", arm_picture(scene, posed));
  return pictures;
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
}

PlanOptions options_of(const PlanCommand& command, const TriangleMesh& object) {
  PlanOptions options = requested_accuracy(command.common.accuracy);
  if (command.primitive_tolerance) {
    options.primitives.tolerance = requested_tolerance(object, *command.primitive_tolerance);
  }
  options.seed = command.common.seed;
  if (command.common.hard_contacts) options.trial.soft_fingers = false;
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

// The steps of the command, with what they share.
class PlanProgram {
 public:
  PlanProgram(const PlanCommand& command, Interrupts& interrupts)
      : command_(command), interrupts_(interrupts), folder_(command.common.out) {}

  int run() {
    check_together(command_);
    require_writable(folder_);
    const std::optional<TestProcedure> procedure = requested_test_procedure(command_.shake);
    const ObjectChoice choice = object_choice(command_.choice);
    Scene loaded = load_scene(command_.scene, {.hand = command_.hand,
                                               .unit = command_.unit,
                                               .repair = command_.repair,
                                               .foreign = foreign_options(command_.packages, {}),
                                               .choice = choice});
    const std::string unit = unit_of_source(command_.scene, loaded);
    print_notes(loaded);
    watch_.lap(Stage::load);
    const CompiledScene scene = compile(std::move(loaded));
    if (procedure) require_support(scene, *procedure);
    watch_.lap(Stage::compile);
    RunRecord record{scene_reference(command_.scene),
                     unit,
                     command_.hand,
                     options_of(command_, scene.scene.object.mesh),
                     command_.repair,
                     choice};
    add_model(command_, scene, record.options);
    PlanResult result = plan_grasps(scene, record.options);
    shake(scene, procedure, result);
    if (result.status == PlanStatus::cancelled) return write_cancelled(scene, result, record);
    const bool late = result.status == PlanStatus::out_of_time;
    if (late && result.tried.empty()) {
      interrupts_.use_up_budget();
      return say_interrupted("nothing is written");
    }
    if (!late && result.status != PlanStatus::complete) {
      throw InputError(no_candidates_text(scene, result));
    }
    write_grasps(scene, result, record);
    // Report and pictures can be made from grasps.json later, so an interrupt does not wait for
    // them.
    interrupts_.end_at_once("the grasps are written, not the report and the pictures");
    if (interrupted(result)) return say_interrupted("no report, no pictures");
    write_report(scene, result, record);
    const std::string pictures = write_pictures(scene, result);
    // Written again with the times of report and pictures.
    write_timings(result);
    std::cout << "wrote " << folder_.string() << ": " << written_ << ", timings.json" << pictures
              << "\n";
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
    watch_.add(result.times);
    return result;
  }

  void shake(const CompiledScene& scene, const std::optional<TestProcedure>& procedure,
             PlanResult& result) {
    if (!procedure || result.grasps.empty() || result.status == PlanStatus::cancelled) return;
    shake_grasps(scene, *procedure,
                 {command_.common.threads, interrupts_.cancellation(), {}, interrupts_.deadline()},
                 result);
    if (command_.rank == "shake") rank_by_shake(result);
    watch_.lap(Stage::shake);
  }

  // Writes what is quick to make: no exports, no report and no pictures.
  int write_cancelled(const CompiledScene& scene, const PlanResult& result,
                      const RunRecord& record) {
    const std::size_t tried = result.tried.size();
    if (tried == 0) return say_interrupted("nothing is written");
    write_files(scene.scene, {{"grasps.json", grasps_json(scene, result, record)}});
    write_timings(result);
    print_result(scene, result);
    std::cout << "wrote " << folder_.string() << ": " << written_ << ", timings.json\n";
    return say_interrupted(std::to_string(tried) + " of " +
                           std::to_string(tried + index(result.untested)) +
                           " candidates were tried; no report, no pictures");
  }

  void write_grasps(const CompiledScene& scene, const PlanResult& result, const RunRecord& record) {
    std::vector<ExportFile> files = {{"grasps.json", grasps_json(scene, result, record)}};
    for (const std::string& format : command_.exports) {
      for (ExportFile& file : export_files(scene, result, format)) files.push_back(std::move(file));
    }
    write_files(scene.scene, files);
    write_timings(result);
    print_result(scene, result);
  }

  void write_report(const CompiledScene& scene, const PlanResult& result, const RunRecord& record) {
    if (command_.common.no_report) return;
    const RunContext context{.threads = command_.common.threads};
    const Report report = plan_report(scene, result, record, kMostDetailed, context);
    interrupts_.write(folder_ / "report.html", report_html(report));
    if (!report.grasps.empty()) best_side_ = report.grasps.front().side;
    written_ += ", report.html";
    watch_.lap(Stage::report);
  }

  std::string write_pictures(const CompiledScene& scene, const PlanResult& result) {
    if (!command_.picture.value_or(!command_.common.no_report)) return "";
    std::string names;
    for (const auto& [name, image] : best_pictures(scene, result, best_side_)) {
      interrupts_.write(folder_ / name, png_bytes(image));
      names += ", " + name;
    }
    watch_.lap(Stage::picture);
    return names;
  }

  void write_files(const Scene& scene, const std::vector<ExportFile>& files) {
    make_folder(folder_);
    for (const ExportFile& file : files) {
      interrupts_.write(folder_ / file.name, file.content);
      // Once the first is written, all that is of earlier grasps goes.
      if (&file == &files.front()) {
        remove_earlier_results(folder_, {file.name}, scene, command_.scene);
      }
    }
    written_ = joined(files, ", ", &ExportFile::name);
  }

  void write_timings(const PlanResult& result) {
    interrupts_.write(folder_ / "timings.json",
                      timings_json(watch_.laps(), result.trial_seconds, command_.common.threads));
  }

  // Whether a signal, not the end of the budget, came after the plan had ended.
  bool interrupted(const PlanResult& result) const {
    return result.status != PlanStatus::out_of_time && interrupts_.cancellation().requested();
  }

  void print_result(const CompiledScene& scene, const PlanResult& result) const {
    std::cout << grasp_table(scene, result, index(command_.top)) << outcome_line(result) << "\n"
              << untested_line(result) << blocker_line(result) << advice_lines(result)
              << std::flush;
  }

  int say_interrupted(const std::string& words) const {
    std::cerr << "prehend: " << interrupts_.reason() << ", " << words << "\n";
    return interrupts_.exit_status();
  }

  const PlanCommand& command_;
  Interrupts& interrupts_;
  const std::filesystem::path folder_;
  Stopwatch watch_;
  std::string written_;               // names of the files, with commas
  std::optional<Vector3> best_side_;  // of the best grasp, where the report has found it
};

int run_plan(const PlanCommand& command, Interrupts& interrupts) {
  return PlanProgram(command, interrupts).run();
}

}  // namespace

void add_plan(CLI::App& app, CommandRequest& request) {
  add_command(app, request, "plan", "plan grasps of an object and rank them", declare, run_plan);
}

}  // namespace prehend
