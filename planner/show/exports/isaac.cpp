#include "planner/show/exports/isaac.h"

#include <algorithm>

#include "planner/show/exports/yaml_text.h"
#include "sim/base/pose.h"

namespace prehend {
namespace {

void put_joints(YAML::Emitter& yaml, const std::vector<std::string>& names,
                const std::vector<double>& values) {
  yaml << YAML::BeginMap;
  for (std::size_t i = 0; i < names.size(); ++i) {
    yaml << YAML::Key;
    put_text(yaml, names[i]);
    yaml << YAML::Value;
    put_number(yaml, values[i]);
  }
  yaml << YAML::EndMap;
}

void put_grasp(YAML::Emitter& yaml, const ExportHeader& header, const ExportGrasp& grasp) {
  const Pose X_OB = grasp.X_OH * header.end_effector.base.X_HF;
  // Normalised, because the quaternion of a rotation matrix is of unit length only up to rounding.
  const Eigen::Quaterniond q = quaternion_of(X_OB).normalized();
  const Vector3 p = X_OB.translation();
  yaml << YAML::BeginMap;
  yaml << YAML::Key << "confidence" << YAML::Value;
  // Epsilon is not a probability, but larger is better for both (docs/reference/exports.md).
  put_number(yaml, std::clamp(grasp.epsilon, 0.0, 1.0));
  yaml << YAML::Key << "position" << YAML::Value;
  put_numbers(yaml, {p.x(), p.y(), p.z()});
  yaml << YAML::Key << "orientation" << YAML::Value << YAML::Flow << YAML::BeginMap;
  yaml << YAML::Key << "w" << YAML::Value;
  put_number(yaml, q.w());
  yaml << YAML::Key << "xyz" << YAML::Value;
  put_numbers(yaml, {q.x(), q.y(), q.z()});
  yaml << YAML::EndMap;
  yaml << YAML::Key << "cspace_position" << YAML::Value;
  put_joints(yaml, header.driver_joints, grasp.closed_joints);
  yaml << YAML::Key << "pregrasp_cspace_position" << YAML::Value;
  put_joints(yaml, header.driver_joints, grasp.pregrasp_joints);
  yaml << YAML::EndMap;
}

}  // namespace

std::string isaac_grasps_yaml(const ExportHeader& header, const std::vector<ExportGrasp>& grasps) {
  YAML::Emitter yaml;
  put_comment(yaml, frames_text(header.end_effector, header.end_effector.base));
  yaml << YAML::BeginMap;
  yaml << YAML::Key << "format" << YAML::Value << "isaac_grasp";
  yaml << YAML::Key << "format_version" << YAML::Value;
  put_number(yaml, 1.0);
  // Both spellings of these keys are documented. Isaac Sim does not look the names up.
  for (const std::string suffix : {"", "_link"}) {
    yaml << YAML::Key << "object_frame" + suffix << YAML::Value;
    put_text(yaml, header.object);
    yaml << YAML::Key << "gripper_frame" + suffix << YAML::Value;
    put_text(yaml, header.end_effector.base.name);
  }
  yaml << YAML::Key << "grasps" << YAML::Value << YAML::BeginMap;
  for (std::size_t i = 0; i < grasps.size(); ++i) {
    check_sizes(header, grasps[i]);
    // From 0, as the Grasp Editor counts: it names the next one by how many there are.
    yaml << YAML::Key << "grasp_" + std::to_string(i) << YAML::Value;
    put_grasp(yaml, header, grasps[i]);
  }
  yaml << YAML::EndMap << YAML::EndMap;
  return yaml_text(yaml);
}

}  // namespace prehend
