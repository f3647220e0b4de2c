#include "planner/main/plan_output.h"

#include <utility>

#include "planner/main/result_table.h"
#include "planner/results/timings_file.h"
#include "planner/show/best_viewpoint.h"
#include "planner/show/exports/export_formats.h"
#include "planner/show/exports/result_files.h"
#include "planner/show/grasp_picture.h"
#include "planner/show/posed_grasp.h"
#include "planner/show/report/plan_report.h"
#include "planner/show/report/report_html.h"
#include "sim/base/joined.h"
#include "sim/base/output_file.h"

namespace prehend {
namespace {

// Pictures of the best grasp, by file name, from `side` if it is known already.
std::vector<std::pair<std::string, Image>> best_pictures(const CompiledScene& scene,
                                                         const PlanResult& result,
                                                         const std::optional<Vector3>& side,
                                                         const RunContext& context) {
  std::vector<std::pair<std::string, Image>> pictures;
  if (result.grasps.empty()) return pictures;
  const ScoredGrasp& best = result.grasps.front();
  const PosedGrasp posed = posed_grasp(scene, best, grasp_title(best, 1));
  pictures.emplace_back("best.png",
                        grasp_picture(scene, posed, side ? *side : best_viewpoint(scene, posed),
                                      kGraspPicture, context));
  if (scene.arm) {
    pictures.emplace_back("best_arm.png", arm_picture(scene, posed, kGraspPicture, context));
  }
  return pictures;
}

}  // namespace

void PlanOutput::write_grasps(const CompiledScene& scene, const PlanResult& result,
                              const RunRecord& record) {
  std::vector<ExportFile> files = {{"grasps.json", grasps_json(scene, result, record)}};
  for (const std::string& format : command_.exports) {
    for (ExportFile& file : export_files(scene, result, format)) files.push_back(std::move(file));
  }
  write_files(scene.scene, files);
  write_timings(result);
}

void PlanOutput::write_report(const CompiledScene& scene, const PlanResult& result,
                              const RunRecord& record) {
  if (command_.common.no_report) return;
  const RunContext context{.threads = command_.common.threads};
  const Report report = plan_report(scene, result, record, kMostDetailed, context);
  interrupts_.write(folder_ / "report.html", report_html(report));
  if (!report.grasps.empty()) best_side_ = report.grasps.front().side;
  written_ += ", report.html";
  watch_.lap(Stage::report);
}

std::string PlanOutput::write_pictures(const CompiledScene& scene, const PlanResult& result) {
  if (!command_.picture.value_or(!command_.common.no_report)) return "";
  std::string names;
  for (const auto& [name, image] :
       best_pictures(scene, result, best_side_, {.threads = command_.common.threads})) {
    interrupts_.write(folder_ / name, png_bytes(image));
    names += ", " + name;
  }
  watch_.lap(Stage::picture);
  return names;
}

void PlanOutput::write_files(const Scene& scene, const std::vector<ExportFile>& files) {
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

void PlanOutput::write_timings(const PlanResult& result) {
  interrupts_.write(folder_ / "timings.json",
                    timings_json(watch_.laps(), result.trial_seconds, command_.common.threads));
}

}  // namespace prehend
