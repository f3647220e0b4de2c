#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "planner/main/progress_bar.h"
#include "planner/main/requested_scene.h"
#include "planner/main/result_table.h"
#include "planner/main/shared_options.h"
#include "planner/plan/plan.h"
#include "planner/plan/shake_grasps.h"
#include "planner/results/datasets/acronym_file.h"
#include "planner/results/datasets/graspgen_file.h"
#include "planner/results/datasets/hdf5/hdf5_reader.h"
#include "planner/results/datasets/set_candidates.h"
#include "planner/results/timings_file.h"
#include "planner/show/exports/result_files.h"
#include "planner/show/report/plan_report.h"
#include "planner/show/report/report_html.h"
#include "sim/base/json/json_field.h"
#include "sim/base/output_file.h"
#include "sim/manipulation/grasp_world.h"
#include "sim/scene/scene_text.h"

namespace prehend {

namespace {

// Arguments of `evaluate`.
struct EvaluateCommand {
  std::filesystem::path grasps;
  std::string scene;  // empty: the file's
  std::string hand;
  std::string unit;
  bool repair = true;
  std::optional<double> friction;       // of the object; empty: as of the file
  std::string shake;                    // protocol: name or file; empty: none
  bool uncertainty = false;             // grasps are tried again on disturbed poses
  bool dynamic = false;                 // hands close in time, on an object that gives way
  std::size_t volumes = kMostDetailed;  // of so many grasps: those that the report shows in detail
  CommonOptions common = {.out = "out/evaluate"};
};

void declare(CLI::App& command, EvaluateCommand& options) {
  add_examples(command, {"evaluate out/grasps.json",
                         "evaluate out/grasps.json --hand franka_hand --shake acronym"});
  command
      .add_option("grasps", options.grasps,
                  "grasp file (docs/reference/grasps-file.md), or a set of grasps "
                  "(docs/reference/datasets.md)")
      ->required();
  add_scene_options(command, options.scene, options.hand, options.unit, options.repair);
  add_friction(command, options.friction);
  command
      .add_option("--volumes", options.volumes,
                  "for how many grasps the volume and the weight that they hold are computed, "
                  "much slower than the rest")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  add_shake(command, options.shake);
  add_uncertainty(command, options.uncertainty);
  add_dynamic(command, options.dynamic);
  add_common(command, options.common);
  add_accuracy(command, options.common);
  add_contacts(command, options.common);
  add_no_report(command, options.common.no_report);
}

struct Given {
  LoadedScene loaded;
  std::vector<Candidate> candidates;
  std::vector<bool> labels;  // of a set of grasps: whether it says that they hold
  std::string scaled = {};   // the text of kScaledScene; empty: none
};

// The scene of a set whose object is not as large as in its mesh file, which grasps.json refers to.
constexpr const char* kScaledScene = "evaluated_scene.json";

SceneReference asked_reference(const EvaluateCommand& command) {
  return {command.scene, command.hand, command.unit, command.repair, {}, command.friction};
}

Given given_set(const EvaluateCommand& command, const GraspSet& set) {
  const std::filesystem::path scaled = command.common.out / kScaledScene;
  Given given{load_asked_scene(set, command.grasps, asked_reference(command), scaled), {}, {}};
  const Scene& scene = given.loaded.scene.scene;
  if (std::holds_alternative<std::monostate>(scene.object.source)) given.scaled = scene_text(scene);
  given.candidates = set_candidates(set, given.loaded.scene);
  given.labels = set_labels(set);
  return given;
}

// A set of grasps in one of the formats of data sets, or a file of grasps. What was read, which
// takes several times the memory of the candidates, ends here.
Given read_given(const EvaluateCommand& command) {
  if (is_hdf5_file(command.grasps)) return given_set(command, read_acronym(command.grasps));
  const JsonFile file(command.grasps);
  if (is_graspgen(file)) return given_set(command, read_graspgen(file));
  LoadedScene loaded = load_asked_scene(file, asked_reference(command));
  std::vector<Candidate> candidates =
      given_candidates(read_grasps(file, loaded.scene), loaded.scene);
  return {std::move(loaded), std::move(candidates), {}};
}

// Whether there is something to write: not after an interrupt, nor where the budget ended before
// the first trial. Says so on stderr.
bool goes_on(PlanResult& result, Interrupts& interrupts) {
  const bool time_is_up = interrupts.unlimit_time();
  if (time_is_up && result.status == PlanStatus::cancelled) result.status = PlanStatus::out_of_time;
  const bool nothing = result.status == PlanStatus::out_of_time && result.tried.empty();
  if (nothing) interrupts.use_up_budget();
  if (!nothing && result.status != PlanStatus::cancelled) return true;
  std::cerr << "prehend: " << interrupts.reason() << ", nothing is written\n";
  return false;
}

EvaluateOptions options_of(const EvaluateCommand& command) {
  const PlanOptions accuracy = requested_accuracy(command.common.accuracy);
  EvaluateOptions options;
  options.seed = command.common.seed;
  options.trial = accuracy.trial;
  options.robustness = command.uncertainty || accuracy.robustness;
  options.uncertainty = accuracy.uncertainty;
  if (command.common.contacts) options.trial.contacts = *command.common.contacts;
  if (command.dynamic) options.trial.formation.dynamic = true;
  options.volumes = command.volumes;
  if (!command.common.no_report) options.sections = kMostDetailed;
  return options;
}

// The record of the run that made the grasps, with the settings of this one.
RunRecord record_of(RunRecord record, const EvaluateOptions& options) {
  record.options.seed = options.seed;
  record.options.trial = options.trial;
  record.options.robustness = options.robustness;
  record.options.uncertainty = options.uncertainty;
  return record;
}

// The table, how all trials ended, how far that agrees with the labels of a set, and what was
// written.
void print_result(const Given& given, const PlanResult& result, const std::filesystem::path& out,
                  bool report) {
  constexpr std::size_t kMostRows = 20;
  std::cout << grasp_table(given.loaded.scene, result, kMostRows);
  if (result.grasps.size() > kMostRows) {
    std::cout << "... and " << result.grasps.size() - kMostRows << " more\n";
  }
  std::cout << outcome_line(result) << "\n";
  if (!given.labels.empty()) {
    std::cout << agreement_text(compare_labels(given.labels, result.tried)) << "\n";
  }
  std::cout << untested_line(result) << "wrote " << out.string() << ": grasps.json, timings.json"
            << (report ? ", report.html" : "")
            << (given.scaled.empty() ? "" : std::string(", ") + kScaledScene) << "\n";
}

int run_evaluate(const EvaluateCommand& command, Interrupts& interrupts) {
  require_writable(command.common.out);
  const std::optional<TestProcedure> protocol = requested_test_procedure(command.shake);
  Stopwatch watch;
  const Given given = read_given(command);
  const LoadedScene& loaded = given.loaded;
  if (protocol) require_support(loaded.scene, *protocol);
  watch.lap(Stage::load);

  ProgressBar bar(command.common.progress);
  const EvaluateOptions options = options_of(command);
  const RunContext context{command.common.threads, interrupts.cancellation(),
                           [&](const Progress& progress) { bar.show(progress); },
                           interrupts.deadline()};
  interrupts.cancel_first();
  PlanResult result = evaluate(loaded.scene, given.candidates, options, context);
  bar.clear();
  if (protocol && result.status == PlanStatus::complete) {
    watch.add(result.times);
    shake_grasps(loaded.scene, *protocol, context, result);
    watch.lap(Stage::shake);
  }
  if (!goes_on(result, interrupts)) return interrupts.exit_status();
  interrupts.end_at_once("nothing is written");
  if (!protocol) watch.add(result.times);

  const RunRecord record = record_of(loaded.record, options);
  std::string report;
  if (!command.common.no_report) {
    report = report_html(
        plan_report(loaded.scene, result, record, kMostDetailed, {command.common.threads}));
    watch.lap(Stage::report);
  }
  make_folder(command.common.out);
  interrupts.end_at_once("not all files are written");
  if (!given.scaled.empty()) interrupts.write(command.common.out / kScaledScene, given.scaled);
  interrupts.write(command.common.out / "grasps.json", [&](std::ostream& stream) {
    write_grasps(stream, loaded.scene, result, record);
  });
  remove_earlier_results(command.common.out, {"grasps.json"}, loaded.scene.scene, command.grasps);
  interrupts.write(command.common.out / "timings.json",
                   timings_json(watch.laps(), result.trial_seconds, command.common.threads));
  if (!report.empty()) interrupts.write(command.common.out / "report.html", report);
  print_result(given, result, command.common.out, !report.empty());
  return 0;
}

}  // namespace

void add_evaluate(CLI::App& app, CommandRequest& request) {
  add_command(app, request, "evaluate", "simulate and score given grasps", declare, run_evaluate);
}

}  // namespace prehend
