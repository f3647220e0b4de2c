#include "planner/results/datasets/grasp_table.h"

#include "planner/results/datasets/grasp_set_checks.h"
#include "sim/base/csv_row.h"
#include "sim/base/number_text.h"

namespace prehend {
namespace {

// Hands differ in their number of degrees of freedom: one cell for all.
std::string dofs_text(const GraspSetEntry& grasp) {
  std::string text;
  for (const double dof : grasp.dofs) text += (text.empty() ? "" : " ") + number_text(dof);
  return text;
}

// The cells have to be those of the header, in the same order.
std::string table_row(const std::string& name, const GraspSet& set, std::size_t index) {
  const GraspSetEntry& grasp = set.grasps[index];
  CsvRow row;
  row.text(name);
  row.text(set.object.file);
  row.text(set.hand);
  row.number(set.object.scale);
  row.number(set.object.friction);
  row.text(std::to_string(index));
  row.text(std::string(name_of(grasp.outcome)));
  row.number(grasp.epsilon.lower);
  row.number(grasp.epsilon.upper);
  row.text(std::to_string(grasp.contacts.size()));
  row.pose(grasp.X_OH);
  row.text(dofs_text(grasp));
  return row.line();
}

}  // namespace

void write_grasp_table_header(std::ostream& stream) {
  CsvRow row;
  row.texts("", {"set", "object", "hand", "scale", "friction", "index", "outcome"}, "");
  row.texts("", {"epsilon_lower", "epsilon_upper", "contacts"}, "");
  row.texts("object_hand_", {"x", "y", "z", "qw", "qx", "qy", "qz"}, "");
  row.text("dofs");
  stream << row.line();
}

void write_grasp_table_rows(std::ostream& stream, const std::string& name, const GraspSet& set) {
  require_sound(set);
  for (std::size_t i = 0; i < set.grasps.size(); ++i) stream << table_row(name, set, i);
}

}  // namespace prehend
