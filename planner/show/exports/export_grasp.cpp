#include "planner/show/exports/export_grasp.h"

#include "sim/base/input_error.h"

namespace prehend {
namespace {

void check(const std::string& field, std::size_t values, std::size_t names) {
  if (values == names) return;
  throw InputError(
      {.field = field,
       .problem = std::to_string(values) + " numbers for " + std::to_string(names) + " names"});
}

}  // namespace

// The formats write names and values side by side; with a number of values that differs they would
// write wrong pairs, or read beyond the end.
void check_sizes(const ExportHeader& header, const ExportGrasp& grasp) {
  const std::string name = "grasp " + std::to_string(grasp.rank);
  check(name + ".dofs", grasp.dofs.size(), header.hand_dofs.size());
  check(name + ".pregrasp_joints", grasp.pregrasp_joints.size(), header.hand_joints.size());
  check(name + ".closed_joints", grasp.closed_joints.size(), header.hand_joints.size());
}

void check_sizes(const Trajectory& path) {
  if (path.positions.size() != path.times.size() || path.velocities.size() != path.times.size()) {
    throw InputError({.field = "path",
                      .problem = std::to_string(path.positions.size()) + " positions and " +
                                 std::to_string(path.velocities.size()) + " velocities for " +
                                 std::to_string(path.times.size()) + " times"});
  }
  for (std::size_t i = 0; i < path.times.size(); ++i) {
    const std::string place = "[" + std::to_string(i) + "]";
    check("path.positions" + place, path.positions[i].size(), path.joints.size());
    check("path.velocities" + place, path.velocities[i].size(), path.joints.size());
  }
}

}  // namespace prehend
