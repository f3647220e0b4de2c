#include "planner/show/exports/export_formats.h"

#include <nlohmann/json.hpp>

#include "planner/plan/grasp_text.h"
#include "planner/plan/plan_result.h"
#include "planner/show/exports/csv.h"
#include "planner/show/exports/end_effector.h"
#include "planner/show/exports/isaac.h"
#include "planner/show/exports/mjcf.h"
#include "planner/show/exports/moveit.h"
#include "planner/show/exports/moveit_scene.h"
#include "planner/show/grasp_bodies.h"
#include "planner/show/picture/glb_bytes.h"
#include "sim/base/input_error.h"
#include "sim/scene/compiled_arm.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/approach_line.h"

namespace prehend {

ExportGrasp export_of(const CompiledScene& scene, const ScoredGrasp& grasp, int rank) {
  const Trial& trial = grasp.trial;
  ExportGrasp exported;
  exported.rank = rank;
  exported.outcome = name_of(trial.outcome);
  exported.epsilon = trial.outcome == Outcome::stable ? trial.epsilon.lower : 0.0;
  exported.volume = grasp.volume.value_or(0.0);
  exported.X_OH = trial.X_OH;
  exported.X_WH = scene.scene.object.X_WO * hand_in_scene(trial);
  exported.preshape = preshape_name(scene, grasp.candidate);
  exported.strategy = strategy_of(scene.scene.hand, grasp.candidate);
  exported.dofs = trial.dofs;
  // The joints with which the hand started: of the preshape, or as given with the candidate.
  exported.pregrasp_joints = approach_line(scene, grasp.candidate, trial).hand_joints;
  exported.closed_joints = trial.joints;
  exported.approach_O = grasp.candidate.approach_O;
  exported.approach_distance = trial.travel;
  exported.path = grasp.path;
  return exported;
}

namespace {

using Files = std::vector<ExportFile>;

// One file for each grasp with a path: text_of(path).
template <typename Name, typename Text>
void add_paths(const ExportInput& input, const Name& file_name, const Text& text_of, Files& files) {
  for (const ExportGrasp& grasp : input.grasps) {
    if (grasp.path) files.push_back({file_name(grasp.rank), text_of(*grasp.path)});
  }
}

Files csv_files(const ExportInput& input) {
  Files files = {{"grasps.csv", grasps_csv(input.header, input.grasps)}};
  add_paths(input, path_file_name, path_csv, files);
  return files;
}

Files isaac_files(const ExportInput& input) {
  return {{"grasps_isaac.yaml", isaac_grasps_yaml(input.header, input.grasps)}};
}

Files moveit_files(const ExportInput& input) {
  Files files = {{"grasps_moveit.yaml", moveit_grasps_yaml(input.header, input.grasps)}};
  if (input.scene.arm) {
    const std::vector<std::string> names = driver_names(input.scene.arm->robot());
    add_paths(
        input, [](int rank) { return "path_" + std::to_string(rank) + "_moveit.yaml"; },
        [&](const Trajectory& path) { return moveit_trajectories_yaml(path, names); }, files);
  }
  files.push_back({"planning_scene_moveit.yaml", moveit_scene_yaml(input.scene)});
  return files;
}

// The grasp with all that stands around it.
ExportFile gltf_file(const CompiledScene& scene, const ScoredGrasp& grasp,
                     const ExportGrasp& exported) {
  const PosedGrasp posed = posed_grasp(scene, grasp);
  const std::vector<DrawnBody> bodies = grasp_bodies(scene, posed).all();
  const std::string rank = std::to_string(exported.rank);
  return {"grasp_" + rank + ".glb", glb_bytes(bodies, "grasp " + rank,
                                              {{"rank", exported.rank},
                                               {"outcome", exported.outcome},
                                               {"epsilon", exported.epsilon},
                                               {"volume", exported.volume}})};
}

Files gltf_files(const ExportInput& input) {
  Files files;
  for (std::size_t g = 0; g < input.grasps.size(); ++g) {
    files.push_back(gltf_file(input.scene, input.result.grasps[g], input.grasps[g]));
  }
  return files;
}

Files mjcf_files(const ExportInput& input) {
  require(input.scene.scene.hand.hand->cups.empty(),
          {.field = "--export",
           .problem = "mjcf holds no suction cups, whose vacuum is not simulated",
           .value = input.scene.scene.hand.name});
  Files files;
  const MjcfShapes shapes = input.grasps.empty() ? MjcfShapes{} : mjcf_shapes(input.scene);
  for (const ExportGrasp& grasp : input.grasps) {
    if (grasp.closed_joints.empty()) continue;
    files.push_back({mjcf_file_name(grasp.rank), mjcf_text(input.scene, shapes, grasp)});
  }
  return files;
}

}  // namespace

std::span<const ExportFormat> export_formats() {
  static const std::vector<ExportFormat> formats = {
      {.name = "csv",
       .files = {"grasps.csv", "path_#.csv"},
       .summary = "Tables of grasps and paths.",
       .make = csv_files},
      {.name = "isaac",
       .files = {"grasps_isaac.yaml"},
       .summary = "The grasp file of Isaac Sim and Isaac ROS.",
       .make = isaac_files},
      {.name = "moveit",
       .files = {"grasps_moveit.yaml", "path_#_moveit.yaml", "planning_scene_moveit.yaml"},
       .summary = "Messages of MoveIt, as YAML.",
       .make = moveit_files},
      {.name = "gltf",
       .files = {"grasp_#.glb"},
       .summary = "Each grasp with its scene as a model to look at.",
       .is_text = false,
       .make = gltf_files},
      {.name = "mjcf",
       .files = {"grasp_#.xml"},
       .summary = "Each grasp as a model of MuJoCo.",
       .make = mjcf_files}};
  return formats;
}

}  // namespace prehend
