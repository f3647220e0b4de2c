#include "planner/exports/csv.h"

#include "planner/exports/number_text.h"
#include "sim/base/pose.h"

namespace prehend {
namespace {

// A row that grows. A text with a comma, a quote or a line break is put in quotes, with quotes
// inside it doubled (RFC 4180, section 2).
class Row {
 public:
  void text(const std::string& value) {
    separate();
    if (value.find_first_of(",\"\r\n") == std::string::npos) {
      line_ += value;
      return;
    }
    line_ += '"';
    for (const char c : value) {
      if (c == '"') line_ += '"';
      line_ += c;
    }
    line_ += '"';
  }

  void texts(const std::string& prefix, const std::vector<std::string>& names,
             const std::string& suffix) {
    for (const std::string& name : names) text(std::string(prefix).append(name).append(suffix));
  }

  void number(double value) { text(number_text(value)); }

  void numbers(const std::vector<double>& values) {
    for (const double value : values) number(value);
  }

  void vector(const Vector3& v) { numbers({v.x(), v.y(), v.z()}); }

  void pose(const Pose& pose) {
    const Eigen::Quaterniond q = quaternion_of(pose).normalized();
    vector(pose.translation());
    numbers({q.w(), q.x(), q.y(), q.z()});
  }

  std::string line() const { return line_ + "\n"; }

 private:
  void separate() {
    if (!first_) line_ += ',';
    first_ = false;
  }

  std::string line_;
  bool first_ = true;
};

// The columns of the header must be those of grasp_row, in the same order. Units and frames are in
// docs/exports.md.
std::string grasps_header(const ExportHeader& header) {
  Row row;
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
  Row row;
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
  Row header;
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
    Row row;
    row.number(path.times[i]);
    row.text(segment < path.segments.size() ? path.segments[segment].name : "");
    row.numbers(path.positions[i]);
    row.numbers(path.velocities[i]);
    text += row.line();
  }
  return text;
}

}  // namespace prehend
