#include <iostream>

#include "planner/main/bulk/bulk_commands.h"
#include "planner/main/other_programs.h"
#include "planner/main/print_notes.h"
#include "planner/main/progress_bar.h"
#include "planner/main/requested_scene.h"
#include "planner/main/shared_options.h"
#include "planner/show/validation/compare_executions.h"
#include "planner/show/validation/validation_page.h"
#include "planner/show/validation/validation_text.h"
#include "sim/base/json/json_field.h"
#include "sim/base/output_file.h"

namespace prehend {
namespace {

// Arguments of `truth`.
struct TruthCommand {
  std::filesystem::path file;
  bool volumes = true;   // the volume of each grasp is a score as well
  int resamples = 2000;  // of the bootstrap
  std::string groups;    // object, session, both or each; empty: natural_grouping
  CommonOptions common = {.out = "out/truth"};
};

void declare(CLI::App& command, TruthCommand& options) {
  add_examples(command, {"truth executed.json", "truth executed.json --groups both --no-volumes"});
  command
      .add_option("file", options.file, "file of executed grasps (docs/reference/truth-file.md)")
      ->required();
  command.add_flag("!--no-volumes", options.volumes, "do without the volume: half of the time");
  command.add_option("--resamples", options.resamples, "how many samples make the intervals")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command
      .add_option("--groups", options.groups,
                  "what is drawn whole: object (where there are several), session, both or each")
      ->check(CLI::IsMember({"object", "session", "both", "each"}));
  add_common(command, options.common);
  add_accuracy(command, options.common);
  add_contacts(command, options.common);
  command.add_flag("--no-report", options.common.no_report, "do without options.html");
}

CompareOptions truth_options(const TruthCommand& command) {
  const PlanOptions accuracy = requested_accuracy(command.common.accuracy);
  CompareOptions options;
  options.evaluation.seed = command.common.seed;
  options.evaluation.trial = accuracy.trial;
  options.evaluation.uncertainty = accuracy.uncertainty;
  if (command.common.contacts) options.evaluation.trial.contacts = *command.common.contacts;
  options.volumes = command.volumes;
  options.grouping = value_named<Grouping>(command.groups);
  options.resamples = command.resamples;
  return options;
}

// The parsed file, which takes several times the memory of the grasps, ends here.
ExecutedGrasps read_asked(const TruthCommand& command) {
  ExecutedGrasps truth = read_executed_grasps(JsonFile(command.file));
  for (const ExecutedObject& object : truth.objects) print_notes(object.scene.scene);
  return truth;
}

int run_truth(const TruthCommand& command, Interrupts& interrupts) {
  require_writable(command.common.out);
  const CompareOptions options = truth_options(command);
  const ExecutedGrasps truth = read_asked(command);
  ProgressBar bar(command.common.progress);
  const RunContext context{command.common.threads,
                           interrupts.cancellation(),
                           [&](const Progress& progress) { bar.show(progress); },
                           {}};
  interrupts.cancel_first();
  ValidationReport report;
  try {
    report = compare_executions(truth, command.file, options, context);
  } catch (const Cancelled&) {
    bar.clear();
    std::cerr << "prehend: " << interrupts.reason() << ", nothing is written\n";
    return interrupts.exit_status();
  }
  bar.clear();
  interrupts.end_at_once("not all files are written");
  make_folder(command.common.out);
  interrupts.write(command.common.out / "truth.json", validation_json(report));
  if (command.common.no_report) {
    remove_file(command.common.out / "truth.html");
  } else {
    interrupts.write(command.common.out / "truth.html", validation_page(report));
  }
  std::cout << validation_table(report) << "wrote " << command.common.out.string() << ": truth.json"
            << (command.common.no_report ? "" : ", truth.html") << "\n";
  return 0;
}

}  // namespace

void add_validate(CLI::App& app, CommandRequest& request) {
  add_command(app, request, kTruth.name, kTruth.summary, declare, run_truth);
}

}  // namespace prehend
