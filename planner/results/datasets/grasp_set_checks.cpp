#include "planner/results/datasets/grasp_set_checks.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <span>
#include <string>

#include "planner/results/datasets/pose_matrix.h"
#include "sim/base/input_error.h"

namespace prehend {
namespace {

[[noreturn]] void refuse(const std::string& field, const std::string& problem) {
  throw InputError({.field = field, .problem = problem});
}

std::string indexed(const std::string& list, std::size_t index) {
  return list + "[" + std::to_string(index) + "]";
}

template <typename T>
void require_finite(const std::string& field, std::span<const T> values) {
  const auto finite = [](T value) { return std::isfinite(value); };
  if (!std::all_of(values.begin(), values.end(), finite)) refuse(field, "must be finite");
}

void require_finite(const std::string& field, std::initializer_list<double> values) {
  require_finite(field, std::span<const double>(values.begin(), values.size()));
}

void require_finite(const std::string& field, const Vector3& v) {
  require_finite(field, {v.x(), v.y(), v.z()});
}

void require_unit(const std::string& field, const Vector3& v) {
  if (!is_unit(v)) refuse(field, "must be a unit vector");
}

void require_rigid(const std::string& field, const Pose& pose) {
  std::vector<double> values;
  append_matrix(pose, values);
  if (!is_exactly_rigid(std::span<const double, kMatrixSize>(values))) {
    refuse(field, "must be a rigid transform");
  }
}

void require_texts(const std::string& field, std::span<const std::string> texts) {
  for (const std::string& text : texts) {
    if (text.find('\0') != std::string::npos) refuse(field, "must not contain a byte 0");
  }
}

void require_count(const std::string& field, std::size_t count, std::size_t names) {
  if (count != 0 && count != names) refuse(field, "must be as many as their names, or none");
}

void require_motion(const std::string& field, const std::optional<ObjectShift>& motion) {
  if (motion) require_finite(field, {motion->linear, motion->angular});
}

void require_sound_object(const GraspSetObject& object) {
  require_texts("object.file", {&object.file, 1});
  require_finite("object.scale", {object.scale});
  if (!(object.scale > 0.0)) refuse("object.scale", "must be above 0");
  require_finite("object.density", {object.density});
  require_finite("object.friction", {object.friction});
  require_finite("object.mass", {object.mass});
  require_finite("object.volume", {object.volume});
  require_finite("object.com_O", object.com_O);
  require_finite("object.inertia", std::span<const double>(object.inertia.data(), 9));
}

void require_sound_contact(const std::string& field, const GraspSetContact& contact,
                           std::size_t links) {
  require_finite(field + ".p_O", contact.p_O);
  require_unit(field + ".n_O", contact.n_O);
  if (contact.link < 0 || static_cast<std::size_t>(contact.link) >= links) {
    refuse(field + ".link", "must be the index of a link");
  }
}

void require_sound_grasp(const std::string& field, const GraspSetEntry& grasp,
                         const GraspSet& set) {
  require_rigid(field + ".X_OH", grasp.X_OH);
  require_rigid(field + ".X_OH_aim", grasp.X_OH_aim);
  if (grasp.approach_O != Vector3::Zero()) require_unit(field + ".approach_O", grasp.approach_O);
  require_finite(field + ".epsilon", {grasp.epsilon.lower, grasp.epsilon.upper});
  require_count(field + ".dofs", grasp.dofs.size(), set.dofs.size());
  require_finite(field + ".dofs", std::span<const double>(grasp.dofs));
  require_count(field + ".joints", grasp.joints.size(), set.joints.size());
  require_finite(field + ".joints", std::span<const double>(grasp.joints));
  require_count(field + ".features", grasp.features.size(), set.feature_names.size());
  require_finite(field + ".features", std::span<const float>(grasp.features));
  require_motion(field + ".closing", grasp.closing);
  require_motion(field + ".shaking", grasp.shaking);
  for (std::size_t c = 0; c < grasp.contacts.size(); ++c) {
    require_sound_contact(indexed(field + ".contacts", c), grasp.contacts[c], set.links.size());
  }
}

}  // namespace

void require_sound(const GraspSet& set) {
  require_sound_object(set.object);
  require_texts("hand", {&set.hand, 1});
  if (set.configuration) require_finite("configuration", {*set.configuration});
  require_texts("dofs", set.dofs);
  require_texts("joints", set.joints);
  require_texts("links", set.links);
  require_texts("feature_names", set.feature_names);
  require_texts("version", {&set.version, 1});
  require_texts("settings", {&set.settings, 1});
  for (std::size_t g = 0; g < set.grasps.size(); ++g) {
    require_sound_grasp(indexed("grasps", g), set.grasps[g], set);
  }
}

}  // namespace prehend
