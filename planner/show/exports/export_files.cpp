#include "planner/show/exports/export_files.h"

#include "planner/plan/plan_result.h"
#include "planner/show/exports/export_formats.h"
#include "sim/base/input_error.h"
#include "sim/base/joined.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {
namespace {

// What the formats need is gathered once (ExportHeader, ExportGrasp), so that they know neither
// scenes nor trials. Files are made in memory; the caller writes them.

ExportHeader header_of(const CompiledScene& scene) {
  const Robot& hand = scene.scene.hand;
  ExportHeader header;
  header.object = scene.scene.object.name;
  header.hand = hand.name;
  header.end_effector = end_effector(scene.scene);
  for (const DegreeOfFreedom& dof : hand.dofs) header.hand_dofs.push_back(dof.name);
  for (const Joint& joint : hand.joints) {
    header.hand_joints.push_back(joint.name);
    header.driver_joints.push_back(driver_name(joint));
  }
  return header;
}

}  // namespace

std::vector<std::string> export_names() {
  std::vector<std::string> names = {"json"};
  for (const ExportFormat& format : export_formats()) names.emplace_back(format.name);
  return names;
}

std::vector<ExportFile> export_files(const CompiledScene& scene, const PlanResult& result,
                                     const std::string& format) {
  // grasps.json is written in any case, so it is accepted as a format and adds nothing.
  if (format == "json") return {};
  for (const ExportFormat& known : export_formats()) {
    if (known.name != format) continue;
    ExportInput input{scene, result, header_of(scene), {}};
    // Ranks count from 1.
    for (const ScoredGrasp& grasp : result.grasps) {
      input.grasps.push_back(export_of(scene, grasp, static_cast<int>(input.grasps.size()) + 1));
    }
    return known.make(input);
  }
  throw InputError(
      {.field = "--export", .problem = "none of " + joined(export_names()), .value = format});
}

}  // namespace prehend
