#include "planner/show/exports/csv.h"

#include "sim/base/csv_row.h"

namespace prehend {
namespace {

// The columns of the header must be those of grasp_row, in the same order. Units and frames are in
// docs/reference/exports.md.
std::string grasps_header(const ExportHeader& header) {
  CsvRow row;
  row.texts("", {"rank", "outcome", "epsilon", "volume"}, "");
  for (const std::string frame : {"object_hand_", "world_hand_"}) {
    row.texts(frame, {"x", "y", "z", "qw", "qx", "qy", "qz"}, "");
  }
  row.text("preshape");
  row.texts("approach_object_", {"x", "y", "z"}, "");
  row.text("approach_distance");
  row.texts("dof_", header.hand_dofs, "");
  row.texts("pregrasp_", header.hand_joints, "");
  row.texts("closed_", header.hand_joints, "");
  row.text("path");
  return row.line();
}

std::string grasp_row(const ExportGrasp& grasp) {
  CsvRow row;
  row.text(std::to_string(grasp.rank));
  row.text(grasp.outcome);
  row.number(grasp.epsilon);
  row.number(grasp.volume);
  row.pose(grasp.X_OH);
  row.pose(grasp.X_WH);
  row.text(grasp.preshape);
  row.vector(grasp.approach_O);
  row.number(grasp.approach_distance);
  row.numbers(grasp.dofs);
  row.numbers(grasp.pregrasp_joints);
  row.numbers(grasp.closed_joints);
  row.text(grasp.path ? path_file_name(grasp.rank) : "");
  return row.line();
}

}  // namespace

std::string grasps_csv(const ExportHeader& header, const std::vector<ExportGrasp>& grasps) {
  std::string text = grasps_header(header);
  for (const ExportGrasp& grasp : grasps) {
    check_sizes(header, grasp);
    text += grasp_row(grasp);
  }
  return text;
}

std::string path_file_name(int rank) { return "path_" + std::to_string(rank) + ".csv"; }

std::string path_csv(const Trajectory& path) {
  check_sizes(path);
  CsvRow header;
  header.text("time");
  header.text("segment");
  header.texts("", path.joints, "");
  header.texts("", path.joints, "_velocity");
  std::string text = header.line();
  std::size_t segment = 0;
  for (std::size_t i = 0; i < path.times.size(); ++i) {
    // Neighbouring segments share a sample. It is written with the earlier one: the next segment
    // begins only behind its `last`.
    while (segment < path.segments.size() &&
           static_cast<std::size_t>(path.segments[segment].last) < i) {
      ++segment;
    }
    CsvRow row;
    row.number(path.times[i]);
    row.text(segment < path.segments.size() ? path.segments[segment].name : "");
    row.numbers(path.positions[i]);
    row.numbers(path.velocities[i]);
    text += row.line();
  }
  return text;
}

}  // namespace prehend
