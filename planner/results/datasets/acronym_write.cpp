#include <limits>
#include <span>
#include <string>
#include <vector>

#include "planner/results/datasets/acronym_file.h"
#include "planner/results/datasets/acronym_layout.h"
#include "planner/results/datasets/grasp_set_checks.h"
#include "planner/results/datasets/hdf5_writer.h"
#include "planner/results/datasets/pose_matrix.h"

namespace prehend {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

void append_vector(const Vector3& v, std::vector<double>& values) {
  values.insert(values.end(), {v.x(), v.y(), v.z()});
}

// One value of each grasp.
template <typename T, typename Get>
std::vector<T> column(const GraspSet& set, const Get& get) {
  std::vector<T> values;
  values.reserve(set.grasps.size());
  for (const GraspSetEntry& grasp : set.grasps) values.push_back(get(grasp));
  return values;
}

// The list of each grasp as a row of `width` values; NaN where it is empty.
template <typename T, typename Get>
std::vector<T> rows(const GraspSet& set, std::size_t width, const Get& get) {
  std::vector<T> values;
  values.reserve(set.grasps.size() * width);
  for (const GraspSetEntry& grasp : set.grasps) {
    const std::vector<T>& row = get(grasp);
    values.insert(values.end(), row.begin(), row.end());
    if (row.empty()) values.insert(values.end(), width, std::numeric_limits<T>::quiet_NaN());
  }
  return values;
}

void write_poses(Hdf5Writer& file, const std::string& path, const GraspSet& set,
                 Pose GraspSetEntry::*pose) {
  std::vector<double> values;
  values.reserve(set.grasps.size() * kMatrixSize);
  for (const GraspSetEntry& grasp : set.grasps) append_matrix(grasp.*pose, values);
  file.array(path, {set.grasps.size(), 4, 4}, std::span<const double>(values));
}

void write_column(Hdf5Writer& file, const std::string& path, const std::vector<double>& values) {
  file.array(path, {values.size()}, std::span<const double>(values));
}

// Nothing where no grasp has the motion.
void write_motion(Hdf5Writer& file, const std::string& path, const GraspSet& set,
                  std::optional<ObjectShift> GraspSetEntry::*motion) {
  bool known = false;
  for (const GraspSetEntry& grasp : set.grasps) known = known || (grasp.*motion).has_value();
  if (!known) return;
  write_column(file, path + "_linear", column<double>(set, [&](const GraspSetEntry& grasp) {
                 return grasp.*motion ? (grasp.*motion)->linear : kUnknown;
               }));
  write_column(file, path + "_angular", column<double>(set, [&](const GraspSetEntry& grasp) {
                 return grasp.*motion ? (grasp.*motion)->angular : kUnknown;
               }));
}

void write_grasps(Hdf5Writer& file, const GraspSet& set) {
  const std::string quality = acronym::kQualities + "/" + acronym::kOurQuality;
  file.group("grasps");
  file.group(acronym::kQualities);
  file.group(quality);
  write_poses(file, acronym::kTransforms, set, &GraspSetEntry::X_OH);
  const auto held = column<std::int64_t>(
      set, [](const GraspSetEntry& grasp) { return grasp.outcome == Outcome::stable ? 1 : 0; });
  file.array(quality + acronym::kHeld, {held.size()}, std::span<const std::int64_t>(held));
  write_motion(file, quality + acronym::kClosing, set, &GraspSetEntry::closing);
  write_motion(file, quality + acronym::kShaking, set, &GraspSetEntry::shaking);
}

void write_gripper(Hdf5Writer& file, const GraspSet& set) {
  file.group("gripper");
  file.text(acronym::kGripperType, set.hand);
  if (set.configuration) write_column(file, acronym::kConfiguration, {*set.configuration});
}

void write_object(Hdf5Writer& file, const GraspSetObject& object) {
  file.group("object");
  file.text("object/file", object.file);
  file.scalar("object/scale", object.scale);
  file.scalar("object/density", object.density);
  file.scalar("object/friction", object.friction);
  file.scalar("object/mass", object.mass);
  file.scalar("object/volume", object.volume);
  std::vector<double> com;
  append_vector(object.com_O, com);
  write_column(file, "object/com", com);
  std::vector<double> inertia;
  for (Eigen::Index row = 0; row < 3; ++row) append_vector(object.inertia.row(row), inertia);
  file.array("object/inertia", {3, 3}, std::span<const double>(inertia));
}

// The contacts of all grasps one after the other; those of grasp i are start[i] to start[i + 1]
// - 1.
void write_contacts(Hdf5Writer& file, const GraspSet& set) {
  std::vector<std::int64_t> start = {0};
  std::vector<double> positions;
  std::vector<double> normals;
  std::vector<std::int32_t> links;
  for (const GraspSetEntry& grasp : set.grasps) {
    for (const GraspSetContact& contact : grasp.contacts) {
      append_vector(contact.p_O, positions);
      append_vector(contact.n_O, normals);
      links.push_back(contact.link);
    }
    start.push_back(static_cast<std::int64_t>(links.size()));
  }
  file.group("prehend/contacts");
  file.array("prehend/contacts/start", {start.size()}, std::span<const std::int64_t>(start));
  file.array("prehend/contacts/position", {links.size(), 3}, std::span<const double>(positions));
  file.array("prehend/contacts/normal", {links.size(), 3}, std::span<const double>(normals));
  file.array("prehend/contacts/link", {links.size()}, std::span<const std::int32_t>(links));
  file.texts("prehend/contacts/link_names", set.links);
}

void write_outcomes(Hdf5Writer& file, const GraspSet& set) {
  const auto outcomes = column<std::int8_t>(
      set, [](const GraspSetEntry& grasp) { return static_cast<std::int8_t>(grasp.outcome); });
  file.array("prehend/outcome", {outcomes.size()}, std::span<const std::int8_t>(outcomes));
  std::vector<std::string> names;
  for (const Outcome outcome : kAll<Outcome>) names.emplace_back(name_of(outcome));
  file.texts("prehend/outcome_names", names);
}

// What ACRONYM has no place for.
void write_ours(Hdf5Writer& file, const GraspSet& set) {
  file.group("prehend");
  file.scalar(acronym::kFormatNumber, std::int64_t{acronym::kFormat});
  file.text("prehend/version", set.version);
  file.text("prehend/settings", set.settings);
  write_outcomes(file, set);
  write_poses(file, "prehend/aim", set, &GraspSetEntry::X_OH_aim);
  std::vector<double> approach;
  for (const GraspSetEntry& grasp : set.grasps) append_vector(grasp.approach_O, approach);
  file.array("prehend/approach", {set.grasps.size(), 3}, std::span<const double>(approach));
  write_column(file, "prehend/epsilon_lower",
               column<double>(set, [](const GraspSetEntry& grasp) { return grasp.epsilon.lower; }));
  write_column(file, "prehend/epsilon_upper",
               column<double>(set, [](const GraspSetEntry& grasp) { return grasp.epsilon.upper; }));
  const auto dofs = rows<double>(
      set, set.dofs.size(), [](const GraspSetEntry& grasp) -> auto& { return grasp.dofs; });
  file.array("prehend/dofs", {set.grasps.size(), set.dofs.size()}, std::span<const double>(dofs));
  file.texts("prehend/dof_names", set.dofs);
  const auto joints = rows<double>(
      set, set.joints.size(), [](const GraspSetEntry& grasp) -> auto& { return grasp.joints; });
  file.array("prehend/joints", {set.grasps.size(), set.joints.size()},
             std::span<const double>(joints));
  file.texts("prehend/joint_names", set.joints);
  const auto features = rows<float>(
      set, set.feature_names.size(),
      [](const GraspSetEntry& grasp) -> auto& { return grasp.features; });
  file.array("prehend/features", {set.grasps.size(), set.feature_names.size()},
             std::span<const float>(features));
  file.texts("prehend/feature_names", set.feature_names);
  write_contacts(file, set);
}

}  // namespace

std::string acronym_bytes(const GraspSet& set) {
  require_sound(set);
  Hdf5Writer file;
  write_grasps(file, set);
  write_gripper(file, set);
  write_object(file, set.object);
  write_ours(file, set);
  return file.bytes();
}

}  // namespace prehend
