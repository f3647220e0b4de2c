#include "sim/robot/files/xrdf_text.h"

#include <algorithm>
#include <yaml-cpp/yaml.h>

#include "sim/base/formatted.h"
#include "sim/base/index.h"

namespace prehend {
namespace {

constexpr const char* kSpheres = "spheres";
constexpr double kAcceleration = 15.0;
constexpr double kJerk = 500.0;

// Degrees of freedom that joints follow, in the order of the robots.
std::vector<const DegreeOfFreedom*> drives_of(const SphereModel& model) {
  std::vector<const DegreeOfFreedom*> drives;
  for (const Robot& robot : model.robots) {
    for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
      const bool is_driven = std::any_of(robot.joints.begin(), robot.joints.end(),
                                         [&](auto& joint) { return index(joint.dof) == d; });
      if (is_driven) drives.push_back(&robot.dofs[d]);
    }
  }
  return drives;
}

void write_joints(const SphereModel& model, YAML::Emitter& yaml) {
  const std::vector<const DegreeOfFreedom*> drives = drives_of(model);
  yaml << YAML::Key << "default_joint_positions" << YAML::Value << YAML::BeginMap;
  for (const DegreeOfFreedom* drive : drives) {
    yaml << YAML::Key << drive->name << YAML::Value << drive->initial;
  }
  yaml << YAML::EndMap;
  yaml << YAML::Key << "cspace" << YAML::Value << YAML::BeginMap;
  yaml << YAML::Key << "joint_names" << YAML::Value << YAML::Flow << YAML::BeginSeq;
  for (const DegreeOfFreedom* drive : drives) yaml << drive->name;
  yaml << YAML::EndSeq;
  yaml << YAML::Key << "acceleration_limits" << YAML::Value << YAML::Flow << YAML::BeginSeq;
  for (const DegreeOfFreedom* drive : drives) {
    yaml << (drive->max_acceleration > 0.0 ? drive->max_acceleration : kAcceleration);
  }
  yaml << YAML::EndSeq;
  yaml << YAML::Key << "jerk_limits" << YAML::Value << YAML::Flow << YAML::BeginSeq;
  for (std::size_t d = 0; d < drives.size(); ++d) yaml << kJerk;
  yaml << YAML::EndSeq << YAML::EndMap;
}

void write_tool_frames(const SphereModel& model, YAML::Emitter& yaml) {
  yaml << YAML::Key << "tool_frames" << YAML::Value << YAML::Flow << YAML::BeginSeq;
  for (const Robot& robot : model.robots) {
    for (const RobotFrame& frame : robot.frames) {
      if (frame.role == FrameRole::tool) yaml << frame.name;
    }
  }
  yaml << YAML::EndSeq;
}

void write_unchecked(const SphereModel& model, YAML::Emitter& yaml) {
  yaml << YAML::Key << "ignore" << YAML::Value << YAML::BeginMap;
  for (std::size_t l = 0; l < model.links.size(); ++l) {
    std::vector<std::string> others;
    for (const SphereModel::Pair& pair : model.unchecked) {
      if (index(pair.a) == l) others.push_back(model.links[index(pair.b)].name);
    }
    if (others.empty()) continue;
    yaml << YAML::Key << model.links[l].name << YAML::Value << YAML::Flow << others;
  }
  yaml << YAML::EndMap;
}

void write_spheres(const SphereModel& model, YAML::Emitter& yaml) {
  yaml << YAML::Key << "geometry" << YAML::Value << YAML::BeginMap;
  yaml << YAML::Key << kSpheres << YAML::Value << YAML::BeginMap;
  yaml << YAML::Key << "spheres" << YAML::Value << YAML::BeginMap;
  for (const SphereLink& link : model.links) {
    if (link.spheres.empty()) continue;
    yaml << YAML::Key << link.name << YAML::Value << YAML::BeginSeq;
    yaml << YAML::Comment(formatted("beyond the mesh by at most %.1f mm", 1e3 * link.error));
    for (const CoverSphere& sphere : link.spheres) {
      const Vector3& c = sphere.center_M;
      yaml << YAML::Flow << YAML::BeginMap;
      yaml << YAML::Key << "center" << YAML::Value << YAML::Flow
           << std::vector<double>{c.x(), c.y(), c.z()};
      yaml << YAML::Key << "radius" << YAML::Value << sphere.radius << YAML::EndMap;
    }
    yaml << YAML::EndSeq;
  }
  yaml << YAML::EndMap << YAML::EndMap << YAML::EndMap;
}

}  // namespace

std::string xrdf_text(const SphereModel& model) {
  YAML::Emitter yaml;
  yaml.SetDoublePrecision(6);
  yaml << YAML::BeginMap;
  yaml << YAML::Key << "format" << YAML::Value << "xrdf";
  yaml << YAML::Key << "format_version" << YAML::Value << "1.0";
  write_joints(model, yaml);
  write_tool_frames(model, yaml);
  yaml << YAML::Key << "collision" << YAML::Value << YAML::BeginMap;
  yaml << YAML::Key << "geometry" << YAML::Value << kSpheres << YAML::EndMap;
  yaml << YAML::Key << "self_collision" << YAML::Value << YAML::BeginMap;
  yaml << YAML::Key << "geometry" << YAML::Value << kSpheres;
  write_unchecked(model, yaml);
  yaml << YAML::EndMap;
  write_spheres(model, yaml);
  yaml << YAML::EndMap;
  return std::string(yaml.c_str()) + "\n";
}

}  // namespace prehend
