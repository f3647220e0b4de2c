#include "planner/results/contacts_file.h"

#include <cmath>

#include "planner/results/json_contact.h"
#include "sim/base/range.h"
#include "sim/quality/ranges.h"

namespace prehend {
namespace {

// Every object is read with the list of its permitted fields, so that a misspelt optional field is
// refused instead of ignored.

std::vector<Contact> read_list(const JsonField& list) {
  std::vector<Contact> contacts;
  for (const JsonField& field : list.items()) {
    FieldReader fields(field);
    contact_fields(fields, contacts.emplace_back());
    fields.finish();
  }
  return contacts;
}

// A force or a torque.
Vector3 read_load(const JsonField& field) {
  const Vector3 load = field.vector3();
  if (load.cwiseAbs().maxCoeff() > kLargestLoad) field.fail("must be within 1e9 of 0");
  return load;
}

// {"force", "torque"}, each zero where it is missing. Files have torques in N m. Inside, the
// torques of a wrench are multiplied by the torque scale.
Wrench read_wrench(const JsonField& field, const WrenchFrame& frame) {
  field.allow_only({"force", "torque"});
  Wrench wrench = Wrench::Zero();
  if (field.has("force")) wrench.head<3>() = read_load(field["force"]);
  if (field.has("torque")) wrench.tail<3>() = frame.torque_scale * read_load(field["torque"]);
  return wrench;
}

Task read_task(const JsonField& field, const WrenchFrame& frame) {
  field.allow_only({"wrenches", "ellipsoid", "gravity"});
  if (field.has("wrenches")) {
    TaskWrenches task;
    for (const JsonField& wrench : field["wrenches"].items()) {
      task.wrenches.push_back(read_wrench(wrench, frame));
    }
    return task;
  }
  if (field.has("ellipsoid")) {
    const std::vector<JsonField> axes = field["ellipsoid"].items();
    // Each axis is a wrench; together they are the columns of a 6 x 6 matrix.
    if (axes.size() != 6) field["ellipsoid"].fail("needs six axes");
    TaskEllipsoid task;
    for (std::size_t i = 0; i < 6; ++i) {
      task.axes.col(static_cast<Eigen::Index>(i)) = read_wrench(axes[i], frame);
    }
    return task;
  }
  if (!field.has("gravity")) field.fail("needs wrenches, an ellipsoid or gravity");
  const JsonField gravity = field["gravity"];
  gravity.allow_only({"direction", "weight"});
  return TaskGravity{gravity["direction"].vector3(), gravity.number_or("weight", 1.0)};
}

Eigen::MatrixXd read_matrix(const JsonField& field, std::size_t rows, std::size_t columns) {
  const std::vector<JsonField> lines = field.items();
  if (lines.size() != rows) field.fail("needs " + std::to_string(rows) + " rows");
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
  for (std::size_t i = 0; i < rows; ++i) {
    const std::vector<double> line = lines[i].numbers(columns);
    for (const double entry : line) {
      if (std::abs(entry) > kLargestJacobian) lines[i].fail("entries must be within 1e6 of 0");
    }
    matrix.row(static_cast<Eigen::Index>(i)) =
        Eigen::Map<const Eigen::RowVectorXd>(line.data(), static_cast<Eigen::Index>(columns));
  }
  return matrix;
}

// The number of joints is that of the torque limits; the matrices must have as many columns.
HandTorques read_hand(const JsonField& field, std::size_t contacts) {
  field.allow_only({"jacobian", "torque_limits", "spin"});
  HandTorques hand;
  const std::size_t joints = field["torque_limits"].items().size();
  const std::vector<double> limits = field["torque_limits"].numbers(joints);
  for (const double limit : limits) {
    const bool accepted = limit == 0.0 || (limit >= kSmallestLoad && limit <= kLargestLoad);
    if (!accepted) field["torque_limits"].fail("must be 0, or from 1e-9 to 1e9 N m");
  }
  hand.limits = Eigen::Map<const Eigen::VectorXd>(limits.data(), static_cast<Eigen::Index>(joints));
  hand.jacobian = read_matrix(field["jacobian"], 3 * contacts, joints);
  if (field.has("spin")) hand.spin = read_matrix(field["spin"], contacts, joints);
  return hand;
}

}  // namespace

ContactsFile load_contacts(const std::filesystem::path& file) {
  return read_contacts(JsonFile(file));
}

ContactsFile read_contacts(const JsonFile& file) {
  const JsonField root = file.root();
  root.allow_only(
      {"contacts", "torque_origin", "torque_scale", "task", "surface", "hand", "external", "name"});
  ContactsFile read;
  // The wrench frame comes first: the wrenches of task and external are scaled by it.
  if (root.has("torque_origin")) read.frame.torque_origin = root["torque_origin"].vector3();
  read.frame.torque_scale = root.number_or("torque_scale", 1.0);
  try {
    check_frame(read.frame);
  } catch (const InputError& error) {
    root.fail(error);
  }
  read.contacts = read_list(root["contacts"]);
  if (root.has("surface")) read.surface = read_list(root["surface"]);
  if (root.has("task")) read.task = read_task(root["task"], read.frame);
  if (root.has("hand")) read.hand = read_hand(root["hand"], read.contacts.size());
  if (root.has("external")) read.external = read_wrench(root["external"], read.frame);
  return read;
}

}  // namespace prehend
