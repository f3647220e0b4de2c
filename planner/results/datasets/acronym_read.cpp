#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "planner/results/datasets/acronym_file.h"
#include "planner/results/datasets/acronym_layout.h"
#include "planner/results/datasets/hdf5/hdf5_reader.h"
#include "planner/results/datasets/pose_matrix.h"

namespace prehend {
namespace {

std::string row_of(const std::string& path, std::size_t row) {
  return path + "[" + std::to_string(row) + "]";
}

Vector3 vector_at(const std::vector<double>& values, std::size_t row) {
  return {values[3 * row], values[3 * row + 1], values[3 * row + 2]};
}

std::vector<Pose> read_poses(const Hdf5Reader& file, const std::string& path, std::size_t count) {
  const std::vector<double> values = file.numbers(path, {count, 4, 4});
  std::vector<Pose> poses;
  poses.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::span<const double, kMatrixSize> matrix(&values[i * kMatrixSize], kMatrixSize);
    const std::optional<Pose> pose = pose_of_matrix(matrix);
    if (!pose) throw file.error(row_of(path, i), "must be a rigid transform");
    poses.push_back(*pose);
  }
  return poses;
}

std::string in_qualities(const std::string& name) {
  return std::string(acronym::kQualities).append("/").append(name);
}

// Ours, else theirs, else the only one.
std::string quality_group(const Hdf5Reader& file) {
  const std::vector<std::string> names = file.members(acronym::kQualities);
  for (const std::string& name : {acronym::kOurQuality, acronym::kTheirQuality}) {
    if (std::find(names.begin(), names.end(), name) != names.end()) {
      return in_qualities(name);
    }
  }
  if (names.size() == 1) return in_qualities(names.front());
  throw file.error(acronym::kQualities, "must have a group prehend or flex, or one group only");
}

std::vector<bool> read_held(const Hdf5Reader& file, const std::string& path, std::size_t count) {
  std::vector<bool> held;
  for (const std::int64_t value : file.integers(path, {count})) {
    if (value != 0 && value != 1) {
      throw file.error(row_of(path, held.size()), "must be 0 or 1", std::to_string(value));
    }
    held.push_back(value == 1);
  }
  return held;
}

void read_motion(const Hdf5Reader& file, const std::string& path, GraspSet& set,
                 std::optional<ObjectShift> GraspSetEntry::*motion) {
  if (!file.has(path + "_linear") && !file.has(path + "_angular")) return;
  const auto linear = file.numbers_or_nan(path + "_linear", {set.grasps.size()});
  const auto angular = file.numbers_or_nan(path + "_angular", {set.grasps.size()});
  for (std::size_t i = 0; i < set.grasps.size(); ++i) {
    if (std::isnan(linear[i]) && std::isnan(angular[i])) continue;
    if (!std::isfinite(linear[i])) throw file.error(row_of(path + "_linear", i), "must be finite");
    if (!std::isfinite(angular[i])) {
      throw file.error(row_of(path + "_angular", i), "must be finite");
    }
    set.grasps[i].*motion = ObjectShift{linear[i], angular[i]};
  }
}

void read_their_grasps(const Hdf5Reader& file, GraspSet& set) {
  const Hdf5Shape shape = file.shape(acronym::kTransforms);
  const std::size_t count = shape.empty() ? 0 : shape.front();
  const std::vector<Pose> poses = read_poses(file, acronym::kTransforms, count);
  const std::string quality = quality_group(file);
  const std::vector<bool> held = read_held(file, quality + acronym::kHeld, count);
  set.grasps.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    set.grasps[i].X_OH = poses[i];
    set.grasps[i].X_OH_aim = poses[i];
    set.grasps[i].outcome = held[i] ? Outcome::stable : Outcome::not_force_closure;
  }
  read_motion(file, quality + acronym::kClosing, set, &GraspSetEntry::closing);
  read_motion(file, quality + acronym::kShaking, set, &GraspSetEntry::shaking);
}

void read_gripper(const Hdf5Reader& file, GraspSet& set) {
  if (file.has(acronym::kGripperType)) set.hand = file.text(acronym::kGripperType);
  if (file.has(acronym::kConfiguration)) {
    set.configuration = file.numbers(acronym::kConfiguration, {1}).front();
  }
}

double number_or_0(const Hdf5Reader& file, const std::string& path) {
  return file.has(path) ? file.numbers(path, {}).front() : 0.0;
}

GraspSetObject read_object(const Hdf5Reader& file) {
  GraspSetObject object;
  object.file = file.text("object/file");
  object.scale = file.numbers("object/scale", {}).front();
  if (!(object.scale > 0.0)) {
    throw file.error("object/scale", "must be above 0", std::to_string(object.scale));
  }
  object.density = number_or_0(file, "object/density");
  object.friction = number_or_0(file, "object/friction");
  object.mass = number_or_0(file, "object/mass");
  object.volume = number_or_0(file, "object/volume");
  if (file.has("object/com")) object.com_O = vector_at(file.numbers("object/com", {3}), 0);
  if (file.has("object/inertia")) {
    const std::vector<double> inertia = file.numbers("object/inertia", {3, 3});
    for (Eigen::Index row = 0; row < 3; ++row) {
      object.inertia.row(row) = vector_at(inertia, static_cast<std::size_t>(row));
    }
  }
  return object;
}

// The outcomes go by their names: numbers may mean others in files of other versions.
std::vector<Outcome> read_outcome_names(const Hdf5Reader& file) {
  const std::string path = "prehend/outcome_names";
  std::vector<Outcome> outcomes;
  for (const std::string& name : file.texts(path)) {
    const auto* found = std::find_if(kAll<Outcome>.begin(), kAll<Outcome>.end(),
                                     [&](Outcome outcome) { return name_of(outcome) == name; });
    if (found == kAll<Outcome>.end()) {
      throw file.error(row_of(path, outcomes.size()), "is no outcome that is known", name);
    }
    outcomes.push_back(*found);
  }
  return outcomes;
}

void read_outcomes(const Hdf5Reader& file, GraspSet& set) {
  const std::string path = "prehend/outcome";
  const std::vector<Outcome> names = read_outcome_names(file);
  const std::vector<std::int64_t> values = file.integers(path, {set.grasps.size()});
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] < 0 || static_cast<std::size_t>(values[i]) >= names.size()) {
      throw file.error(row_of(path, i), "must be an index of outcome_names",
                       std::to_string(values[i]));
    }
    const Outcome outcome = names[static_cast<std::size_t>(values[i])];
    const bool held = set.grasps[i].outcome == Outcome::stable;
    if (held != (outcome == Outcome::stable)) {
      throw file.error(row_of(path, i), "does not agree with object_in_gripper",
                       std::string(name_of(outcome)));
    }
    set.grasps[i].outcome = outcome;
  }
}

void require_unit_row(const Hdf5Reader& file, const std::string& path, std::size_t row,
                      const Vector3& v) {
  if (!is_unit(v)) throw file.error(row_of(path, row), "must be a unit vector");
}

void read_approaches(const Hdf5Reader& file, GraspSet& set) {
  const std::string path = "prehend/approach";
  const std::vector<double> values = file.numbers(path, {set.grasps.size(), 3});
  for (std::size_t i = 0; i < set.grasps.size(); ++i) {
    Vector3& approach = set.grasps[i].approach_O = vector_at(values, i);
    if (approach != Vector3::Zero()) require_unit_row(file, path, i, approach);
  }
}

// Rows as lists of each grasp, those of nothing but NaN as empty ones.
template <typename T>
void spread_rows(const Hdf5Reader& file, const std::string& path, std::size_t width,
                 const std::vector<T>& values, GraspSet& set, std::vector<T> GraspSetEntry::*list) {
  for (std::size_t i = 0; i < set.grasps.size(); ++i) {
    const std::span<const T> row = std::span<const T>(values).subspan(i * width, width);
    if (std::all_of(row.begin(), row.end(), [](T value) { return std::isnan(value); })) continue;
    if (!std::all_of(row.begin(), row.end(), [](T value) { return std::isfinite(value); })) {
      throw file.error(row_of(path, i), "must be finite");
    }
    (set.grasps[i].*list).assign(row.begin(), row.end());
  }
}

// Checks that the contacts of grasp after grasp follow each other, to the last.
std::vector<std::int64_t> read_starts(const Hdf5Reader& file, std::size_t grasps,
                                      std::size_t contacts) {
  const std::string path = "prehend/contacts/start";
  std::vector<std::int64_t> starts = file.integers(path, {grasps + 1});
  if (starts.front() != 0 || starts.back() != static_cast<std::int64_t>(contacts) ||
      !std::is_sorted(starts.begin(), starts.end())) {
    throw file.error(path, "must rise from 0 to the number of contacts");
  }
  return starts;
}

void read_contacts(const Hdf5Reader& file, GraspSet& set) {
  const std::string group = "prehend/contacts/";
  set.links = file.texts(group + "link_names");
  const Hdf5Shape shape = file.shape(group + "link");
  const std::size_t count = shape.empty() ? 0 : shape.front();
  const std::vector<std::int64_t> links = file.integers(group + "link", {count});
  const std::vector<double> positions = file.numbers(group + "position", {count, 3});
  const std::vector<double> normals = file.numbers(group + "normal", {count, 3});
  std::vector<GraspSetContact> contacts(count);
  for (std::size_t c = 0; c < count; ++c) {
    if (links[c] < 0 || static_cast<std::size_t>(links[c]) >= set.links.size()) {
      throw file.error(row_of(group + "link", c), "must be an index of link_names",
                       std::to_string(links[c]));
    }
    contacts[c] = {vector_at(positions, c), vector_at(normals, c), static_cast<int>(links[c])};
    require_unit_row(file, group + "normal", c, contacts[c].n_O);
  }
  const std::vector<std::int64_t> starts = read_starts(file, set.grasps.size(), count);
  for (std::size_t i = 0; i < set.grasps.size(); ++i) {
    set.grasps[i].contacts.assign(contacts.begin() + starts[i], contacts.begin() + starts[i + 1]);
  }
}

void read_our_grasps(const Hdf5Reader& file, GraspSet& set) {
  const std::size_t count = set.grasps.size();
  read_outcomes(file, set);
  read_approaches(file, set);
  const std::vector<Pose> aims = read_poses(file, "prehend/aim", count);
  const std::vector<double> lower = file.numbers("prehend/epsilon_lower", {count});
  const std::vector<double> upper = file.numbers("prehend/epsilon_upper", {count});
  for (std::size_t i = 0; i < count; ++i) {
    set.grasps[i].X_OH_aim = aims[i];
    set.grasps[i].epsilon = {lower[i], upper[i]};
  }
  set.joints = file.texts("prehend/joint_names");
  spread_rows(file, "prehend/joints", set.joints.size(),
              file.numbers_or_nan("prehend/joints", {count, set.joints.size()}), set,
              &GraspSetEntry::joints);
  set.dofs = file.texts("prehend/dof_names");
  spread_rows(file, "prehend/dofs", set.dofs.size(),
              file.numbers_or_nan("prehend/dofs", {count, set.dofs.size()}), set,
              &GraspSetEntry::dofs);
  set.feature_names = file.texts("prehend/feature_names");
  spread_rows(file, "prehend/features", set.feature_names.size(),
              file.floats_or_nan("prehend/features", {count, set.feature_names.size()}), set,
              &GraspSetEntry::features);
  read_contacts(file, set);
}

void read_ours(const Hdf5Reader& file, GraspSet& set) {
  const std::int64_t format = file.integers(acronym::kFormatNumber, {}).front();
  if (format != acronym::kFormat) {
    throw file.error(acronym::kFormatNumber, "is a version that is not known",
                     std::to_string(format));
  }
  set.version = file.text("prehend/version");
  set.settings = file.text("prehend/settings");
  read_our_grasps(file, set);
}

GraspSet read_set(const Hdf5Reader& file) {
  GraspSet set;
  read_their_grasps(file, set);
  read_gripper(file, set);
  set.object = read_object(file);
  if (file.has("prehend")) read_ours(file, set);
  return set;
}

}  // namespace

GraspSet read_acronym(const std::filesystem::path& path) { return read_set(Hdf5Reader(path)); }

GraspSet read_acronym(const std::string& name, const std::string& bytes) {
  return read_set(Hdf5Reader(name, bytes));
}

}  // namespace prehend
