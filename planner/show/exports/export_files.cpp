#include "planner/show/exports/export_files.h"

#include <nlohmann/json.hpp>

#include "planner/plan/grasp_text.h"
#include "planner/show/exports/csv.h"
#include "planner/show/exports/isaac.h"
#include "planner/show/exports/mjcf.h"
#include "planner/show/exports/moveit.h"
#include "planner/show/grasp_bodies.h"
#include "planner/show/picture/glb_bytes.h"
#include "sim/base/input_error.h"
#include "sim/trial/approach_line.h"

namespace prehend {
namespace {

// What the formats need is gathered once (ExportHeader, ExportGrasp), so that they know neither
// scenes nor trials. Files are made in memory; the caller writes them.

ExportHeader header_of(const CompiledScene& scene) {
  const Robot& hand = scene.scene.hand;
  ExportHeader header;
  header.object = scene.scene.object.name;
  header.hand = hand.name;
  // Poses of the hand are those of its base link, which is the first (Robot::links).
  header.hand_base = hand.links[0].name;
  for (const DegreeOfFreedom& dof : hand.dofs) header.hand_dofs.push_back(dof.name);
  for (const Joint& joint : hand.joints) header.hand_joints.push_back(joint.name);
  return header;
}

}  // namespace

ExportGrasp export_of(const CompiledScene& scene, const ScoredGrasp& grasp, int rank) {
  const Trial& trial = grasp.trial;
  ExportGrasp exported;
  exported.rank = rank;
  exported.outcome = outcome_name(trial.outcome);
  exported.epsilon = trial.outcome == Outcome::stable ? trial.epsilon.lower : 0.0;
  exported.volume = grasp.volume.value_or(0.0);
  exported.X_OH = trial.X_OH;
  exported.X_WH = scene.scene.object.X_WO * hand_in_scene(trial);
  exported.preshape = preshape_name(scene, grasp.candidate);
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

}  // namespace

std::vector<std::string> export_formats() {
  return {"json", "csv", "isaac", "moveit", "gltf", "mjcf"};
}

std::vector<ExportFile> export_files(const CompiledScene& scene, const PlanResult& result,
                                     const std::string& format) {
  const ExportHeader header = header_of(scene);
  std::vector<ExportGrasp> grasps;
  // Ranks count from 1.
  for (const ScoredGrasp& grasp : result.grasps) {
    grasps.push_back(export_of(scene, grasp, static_cast<int>(grasps.size()) + 1));
  }
  std::vector<ExportFile> files;
  const auto add_paths = [&](const auto& name_of, const auto& text_of) {
    for (const ExportGrasp& grasp : grasps) {
      if (grasp.path) files.push_back({name_of(grasp.rank), text_of(*grasp.path)});
    }
  };
  // grasps.json is written in any case, so it is accepted as a format and adds nothing.
  if (format == "json") return files;
  if (format == "csv") {
    files.push_back({"grasps.csv", grasps_csv(header, grasps)});
    add_paths(path_file_name, path_csv);
  } else if (format == "isaac") {
    files.push_back({"grasps_isaac.yaml", isaac_grasps_yaml(header, grasps)});
  } else if (format == "moveit") {
    files.push_back({"grasps_moveit.yaml", moveit_grasps_yaml(header, grasps)});
    add_paths([](int rank) { return "path_" + std::to_string(rank) + "_moveit.yaml"; },
              [](const Trajectory& path) { return moveit_trajectory_yaml(path); });
  } else if (format == "gltf") {
    for (std::size_t g = 0; g < grasps.size(); ++g) {
      files.push_back(gltf_file(scene, result.grasps[g], grasps[g]));
    }
  } else if (format == "mjcf") {
    const MjcfShapes shapes = grasps.empty() ? MjcfShapes{} : mjcf_shapes(scene);
    for (const ExportGrasp& grasp : grasps) {
      if (grasp.closed_joints.empty()) continue;
      files.push_back({mjcf_file_name(grasp.rank), mjcf_text(scene, shapes, grasp)});
    }
  } else {
    std::string known;
    for (const std::string& name : export_formats()) known += (known.empty() ? "" : ", ") + name;
    throw InputError({.field = "--export", .problem = "none of " + known, .value = format});
  }
  return files;
}

}  // namespace prehend
