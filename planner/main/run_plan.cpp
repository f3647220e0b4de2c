#include <iostream>

#include "planner/exports/export_files.h"
#include "planner/files/grasps_file.h"
#include "planner/main/commands.h"
#include "planner/main/progress_bar.h"
#include "planner/main/result_table.h"
#include "planner/report/plan_report.h"
#include "planner/report/report_html.h"
#include "planner/show/grasp_picture.h"
#include "planner/show/posed_grasp.h"
#include "planner/show/telling_side.h"
#include "sim/base/output_file.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_library.h"

namespace prehend {
namespace {

// Pictures of the best grasp, by file name.
std::vector<std::pair<std::string, Image>> best_pictures(const CompiledScene& scene,
                                                         const PlanResult& result) {
  std::vector<std::pair<std::string, Image>> pictures;
  if (result.grasps.empty()) return pictures;
  const ScoredGrasp& best = result.grasps.front();
  const PosedGrasp posed = posed_grasp(scene, best, grasp_title(best, 1));
  pictures.emplace_back("best.png", grasp_picture(scene, posed, telling_side(scene, posed)));
  if (scene.arm) pictures.emplace_back("best_arm.png", arm_picture(scene, posed));
  return pictures;
}

// What this run may not write does not stay behind from an earlier one.
void remove_earlier(const std::filesystem::path& folder) {
  for (const char* name : {"best.png", "best_arm.png", "report.html"}) remove_file(folder / name);
}

std::string names_of(const std::vector<ExportFile>& files) {
  std::string names;
  for (const ExportFile& file : files) names += (names.empty() ? "" : ", ") + file.name;
  return names;
}

}  // namespace

int run_plan(const PlanCommand& command) {
  Stopwatch watch;
  const std::filesystem::path file = find_scene(command.scene);
  Scene loaded = load_scene(file, {command.hand, command.unit});
  watch.lap("load");
  const CompiledScene scene = compile(std::move(loaded));
  watch.lap("compile");

  ProgressBar bar;
  PlanOptions options;
  options.primitives.seed = command.common.seed;
  options.trials.threads = command.common.threads;
  options.trials.trial.soft_fingers = !command.common.hard_contacts;
  options.trials.progress = [&](const TrialProgress& progress) { bar.show(progress); };
  options.rank.top = command.top;
  options.trials.trial.reach.kinematics.seed = command.common.seed;
  if (command.path) {
    options.paths.emplace();
    options.paths->reach = options.trials.trial.reach;
    options.paths->transfer.seed = command.common.seed;
    options.paths->transfer.planner = path_planner_named(command.path_planner).value();
  }
  if (!command.common.no_report) options.sections = kMostDetailed;
  const PlanResult result = plan(scene, options);
  bar.clear();
  watch.add(result.times);

  const RunRecord record{scene_reference(file), command.unit, command.hand, command.common.seed,
                         options};
  std::vector<ExportFile> files = {{"grasps.json", grasps_json(scene, result, record)}};
  for (const std::string& format : command.exports) {
    for (ExportFile& file_of : export_files(scene, result, format)) {
      files.push_back(std::move(file_of));
    }
  }
  if (!command.common.no_report) {
    files.push_back(
        {"report.html", report_html(plan_report(scene, result, record, {command.common.threads}))});
    watch.lap("report");
  }
  make_folder(command.common.out);
  remove_earlier(command.common.out);
  for (const ExportFile& written : files) {
    write_file(command.common.out / written.name, written.content);
  }
  std::string written_last;
  for (const auto& [name, image] : best_pictures(scene, result)) {
    write_png(command.common.out / name, image);
    written_last += ", " + name;
  }
  watch.lap("picture");
  write_file(command.common.out / "timings.json",
             timings_json(watch.laps(), result.trial_seconds, command.common.threads));

  std::cout << grasp_table(scene, result, static_cast<std::size_t>(command.top))
            << outcome_line(result) << "\n"
            << blocker_line(result) << "wrote " << command.common.out.string() << ": "
            << names_of(files) << ", timings.json" << written_last << "\n";
  return 0;
}

}  // namespace prehend
