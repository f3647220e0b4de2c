#include <iostream>
#include <utility>
#include <vector>

#include "planner/files/json_settings.h"
#include "planner/files/result_files.h"
#include "planner/files/timings_file.h"
#include "planner/main/asked_scene.h"
#include "planner/main/commands.h"
#include "planner/main/progress_bar.h"
#include "planner/main/result_table.h"
#include "planner/report/plan_report.h"
#include "planner/report/report_html.h"
#include "planner/search/shake_grasps.h"
#include "sim/base/output_file.h"
#include "sim/json/json_field.h"
#include "sim/manipulation/grasp_world.h"

namespace prehend {

namespace {

struct Given {
  LoadedScene loaded;
  std::vector<Candidate> candidates;
};

// The parsed file, which takes several times the memory of the candidates, ends here.
Given read_given(const EvaluateCommand& command) {
  const JsonFile file(command.grasps);
  LoadedScene loaded =
      load_asked_scene(file, {command.scene, command.hand, command.unit, command.repair});
  std::vector<Candidate> candidates =
      given_candidates(read_grasps(file, loaded.scene), loaded.scene);
  return {std::move(loaded), std::move(candidates)};
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
  const PlanOptions accuracy = read_accuracy(command.common.accuracy);
  EvaluateOptions options;
  options.seed = command.common.seed;
  options.trial = accuracy.trial;
  options.robustness = command.uncertainty || accuracy.robustness;
  options.uncertainty = accuracy.uncertainty;
  if (command.common.hard_contacts) options.trial.soft_fingers = false;
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

}  // namespace

int run_evaluate(const EvaluateCommand& command, Interrupts& interrupts) {
  require_writable(command.common.out);
  const std::optional<Protocol> protocol = asked_protocol(command.shake);
  Stopwatch watch;
  const Given given = read_given(command);
  const LoadedScene& loaded = given.loaded;
  if (protocol) require_support(loaded.scene, *protocol);
  watch.lap(Stage::load);

  ProgressBar bar(command.common.progress);
  const EvaluateOptions options = options_of(command);
  const RunContext context{command.common.threads, interrupts.cancellation(),
                           [&](const Progress& progress) { bar.show(progress); },
                           command.common.deadline};
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
    report = report_html(plan_report(loaded.scene, result, record, {}, {command.common.threads}));
    watch.lap(Stage::report);
  }
  make_folder(command.common.out);
  interrupts.end_at_once("not all files are written");
  interrupts.write(command.common.out / "grasps.json", [&](std::ostream& stream) {
    write_grasps(stream, loaded.scene, result, record);
  });
  interrupts.write(command.common.out / "timings.json",
                   timings_json(watch.laps(), result.trial_seconds, command.common.threads));
  remove_earlier_results(command.common.out, {"grasps.json", "timings.json"}, loaded.scene.scene,
                         command.grasps);
  if (!report.empty()) interrupts.write(command.common.out / "report.html", report);
  constexpr std::size_t kMostRows = 20;
  std::cout << grasp_table(loaded.scene, result, kMostRows);
  if (result.grasps.size() > kMostRows) {
    std::cout << "... and " << result.grasps.size() - kMostRows << " more\n";
  }
  std::cout << outcome_line(result) << "\n"
            << untested_line(result) << "wrote " << command.common.out.string()
            << ": grasps.json, timings.json" << (report.empty() ? "" : ", report.html") << "\n";
  return 0;
}

}  // namespace prehend
