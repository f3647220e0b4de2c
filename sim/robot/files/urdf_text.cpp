#include "sim/robot/files/urdf_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/json/wrapped_json.h"
#include "sim/base/number_text.h"
#include "sim/base/xml/xml_text.h"
#include "sim/robot/files/robot_text_parts.h"
#include "sim/robot/files/urdf_form.h"
#include "sim/robot/files/urdf_geometry.h"
#include "sim/robot/sound_robot.h"
#include "sim/shape/files/mesh_text.h"

namespace prehend {
namespace {

using Json = nlohmann::ordered_json;

std::string digits(const Vector3& v) {
  return shortest_text(v.x()) + " " + shortest_text(v.y()) + " " + shortest_text(v.z());
}

void write_origin(XmlText& xml, const Pose& pose) {
  if (is_identity(pose)) return;
  XmlAttributes attributes{{"xyz", digits(Vector3(pose.translation()))}};
  if (pose.linear() != Matrix3::Identity()) {
    attributes.emplace_back("rpy", digits(urdf_angles(pose.linear())));
  }
  xml.element("origin", attributes);
}

void write_inertial(XmlText& xml, const Inertial& inertial) {
  if (!(inertial.mass > 0.0)) return;
  const Matrix3& I = inertial.inertia;
  xml.open("inertial");
  xml.element("origin", {{"xyz", digits(inertial.center_of_mass)}});
  xml.element("mass", {{"value", shortest_text(inertial.mass)}});
  xml.element("inertia", {{"ixx", shortest_text(I(0, 0))},
                          {"ixy", shortest_text(I(0, 1))},
                          {"ixz", shortest_text(I(0, 2))},
                          {"iyy", shortest_text(I(1, 1))},
                          {"iyz", shortest_text(I(1, 2))},
                          {"izz", shortest_text(I(2, 2))}});
  xml.close();
}

class UrdfWriter {
 public:
  UrdfWriter(const Platform& platform, const std::filesystem::path& name)
      : platform_(platform), name_(name), folder_(name.stem().string() + "_meshes") {}

  std::vector<RobotTextFile> write();

 private:
  void write_robot(const Robot& robot);
  void write_joint(const Robot& robot, std::size_t j);
  void write_link(const Link& link, const Pose& X_AL = Pose::Identity());
  void write_mount(const MountedRobot& mounted, const Robot& robot);
  void write_fixed(const std::string& name, const std::string& parent, const std::string& child,
                   const Pose& X);
  std::string mesh_file(const std::string& link);
  std::string sidecar() const;

  // `wanted`, or the first of wanted_2, wanted_3, ... that no link has.
  std::string new_link(const std::string& wanted);
  void write_frame(const std::string& link) { xml_.element("link", {{"name", link}}); }

  const Platform& platform_;
  std::filesystem::path name_;
  std::string folder_;
  XmlText xml_;
  std::vector<RobotTextFile> files_;
  std::set<std::string> links_;
  std::set<std::string> mesh_names_;
  std::vector<Robot> robots_;                     // in the form of URDF
  std::vector<std::vector<std::string>> frames_;  // of each robot: the link after each joint
};

std::string UrdfWriter::new_link(const std::string& wanted) {
  std::string name = wanted;
  for (int k = 2; !links_.insert(name).second; ++k) name = wanted + "_" + std::to_string(k);
  return name;
}

// Names of links may hold what names of files may not.
std::string UrdfWriter::mesh_file(const std::string& link) {
  std::string base = link.substr(0, 100);
  for (char& c : base) {
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-') c = '_';
  }
  std::string name = base;
  for (int k = 2; !mesh_names_.insert(name).second; ++k) name = base + "_" + std::to_string(k);
  return folder_ + "/" + name + ".obj";
}

void UrdfWriter::write_link(const Link& link, const Pose& X_AL) {
  const std::string file = mesh_file(link.name);
  const bool is_moved = !is_identity(X_AL);
  files_.push_back({file, obj_text(is_moved ? transformed(link.mesh, X_AL.inverse()) : link.mesh)});
  xml_.open("link", {{"name", link.name}});
  write_inertial(xml_, is_moved && link.inertial.mass > 0.0
                           ? transformed(link.inertial, X_AL.inverse())
                           : link.inertial);
  for (const char* use : {"visual", "collision"}) {
    xml_.open(use);
    xml_.open("geometry");
    xml_.element("mesh", {{"filename", file}});
    xml_.close();
    xml_.close();
  }
  xml_.close();
}

void UrdfWriter::write_fixed(const std::string& name, const std::string& parent,
                             const std::string& child, const Pose& X) {
  xml_.open("joint", {{"name", name}, {"type", "fixed"}});
  write_origin(xml_, X);
  xml_.element("parent", {{"link", parent}});
  xml_.element("child", {{"link", child}});
  xml_.close();
}

void UrdfWriter::write_joint(const Robot& robot, std::size_t j) {
  const Joint& joint = robot.joints[j];
  const std::vector<std::string>& frames = frames_.back();
  const bool turns = joint.type == JointType::revolute;
  Joint at_zero = joint;
  at_zero.X_JA = Pose::Identity();
  const bool has_after = !is_identity(joint.X_JA);
  const std::string child = has_after ? new_link(joint.name + "_axis") : frames[j];
  if (has_after) {
    write_frame(child);
    write_fixed(joint.name + "_after", child, frames[j], joint.X_JA);
  }
  const DegreeOfFreedom& dof = robot.dofs[index(joint.dof)];
  const std::string parent = joint.parent < 0 ? robot.links[0].name : frames[index(joint.parent)];
  if (joint.ratio ==
      0.0) {  // URDF knows no linkages: it stays where it is until they close further
    write_fixed(joint.name, parent, child, joint.X_PJ * across(at_zero, joint.offset));
    return;
  }
  xml_.open("joint", {{"name", joint.name}, {"type", turns ? "revolute" : "prismatic"}});
  write_origin(xml_, joint.X_PJ * across(at_zero, 0.0));
  xml_.element("parent", {{"link", parent}});
  xml_.element("child", {{"link", child}});
  xml_.element("axis", {{"xyz", digits(joint.axis)}});
  xml_.element("limit", {{"lower", shortest_text(joint.lower)},
                         {"upper", shortest_text(joint.upper)},
                         {"effort", shortest_text(joint.max_effort)},
                         {"velocity", shortest_text(dof.max_velocity * std::abs(joint.ratio))}});
  if (joint.friction.coulomb > 0.0 || joint.friction.viscous > 0.0) {
    xml_.element("dynamics", {{"damping", shortest_text(joint.friction.viscous)},
                              {"friction", shortest_text(joint.friction.coulomb)}});
  }
  if (dof.name != joint.name) {
    xml_.element("mimic", {{"joint", dof.name},
                           {"multiplier", shortest_text(joint.ratio)},
                           {"offset", shortest_text(joint.offset)}});
  }
  xml_.close();
}

void UrdfWriter::write_robot(const Robot& robot) {
  std::vector<std::string>& frames = frames_.emplace_back(robot.joints.size());
  std::vector<RobotFrame> held;  // links and frames that are fixed to another one
  for (const Link& link : robot.links) links_.insert(link.name);
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    const Link& link = robot.links[l];
    const Pose X_AL = own_frame(robot, l);
    write_link(link, X_AL);
    if (l == 0) continue;
    if (link.joint >= 0 && frames[index(link.joint)].empty() && is_identity(X_AL)) {
      frames[index(link.joint)] = link.name;
    } else {
      held.push_back({link.name, FrameRole::none, link.joint, X_AL});
    }
  }
  for (const RobotFrame& frame : robot.frames) {
    if (links_.contains(frame.name)) continue;
    write_frame(new_link(frame.name));
    if (frame.joint >= 0 && frames[index(frame.joint)].empty() && is_identity(frame.X_AF)) {
      frames[index(frame.joint)] = frame.name;
    } else {
      held.push_back(frame);
    }
  }
  for (std::size_t j = 0; j < frames.size(); ++j) {
    if (!frames[j].empty()) continue;
    frames[j] = new_link(robot.joints[j].name + "_link");
    write_frame(frames[j]);
  }
  for (const RobotFrame& frame : held) {
    write_fixed(frame.name + "_fixed",
                frame.joint < 0 ? robot.links[0].name : frames[index(frame.joint)], frame.name,
                frame.X_AF);
  }
  for (std::size_t j = 0; j < robot.joints.size(); ++j) write_joint(robot, j);
}

// What holds a robot to the one that carries it.
void UrdfWriter::write_mount(const MountedRobot& mounted, const Robot& robot) {
  const Robot& parent = robots_[index(mounted.parent)];
  const Chain& chain = parent.chains[index(mounted.chain)];
  const std::string& carrier =
      frames_[index(mounted.parent)][index(chain.first_joint + chain.joint_count - 1)];
  write_fixed(mounted.name + "_mounted", carrier, robot.links[0].name, mounted.X_MR);
  if (!mounted.mount) return;
  Link mount = *mounted.mount;
  mount.name = new_link(mounted.name + "_" + mount.name);
  write_link(mount);
  write_fixed(mount.name + "_fixed", carrier, mount.name, Pose::Identity());
}

std::string UrdfWriter::sidecar() const {
  Json json{{"materials", Json::object()}, {"hand_root", nullptr}, {"dofs", Json::array()}};
  for (std::size_t r = 0; r < robots_.size(); ++r) {
    const Robot& robot = robots_[r];
    const MountedRobot& mounted = platform_.robots[r];
    for (const Link& link : robot.links) json["materials"][link.name] = link.material;
    if (mounted.mount) {
      json["materials"][mounted.name + "_" + mounted.mount->name] = mounted.mount->material;
    }
    for (const DegreeOfFreedom& dof : robot.dofs) {
      Json of_dof{{"name", dof.name}, {"coupling", "rigid"}};
      of_dof.update(motion_json(dof));
      json["dofs"].push_back(of_dof);
    }
    for (const Joint& joint : robot.joints) {
      if (joint.spring.stiffness > 0.0) json["springs"][joint.name] = spring_json(joint.spring);
    }
    for (const auto& [a, b] : robot.exempt_pairs) {
      json["exempt_collisions"].push_back({robot.links[index(a)].name, robot.links[index(b)].name});
    }
    if (!robot.hand) continue;
    if (mounted.parent >= 0) json["hand_root"] = robot.links[0].name;
    json["hand"] = hand_json(robot);
  }
  return wrapped_json(json);
}

std::vector<RobotTextFile> UrdfWriter::write() {
  xml_.open("robot", {{"name", platform_.name}});
  for (const MountedRobot& mounted : platform_.robots) {
    require_sound(mounted.robot);
    require(!mounted.robot.hand || mounted.robot.hand->cups.empty(),
            {.field = mounted.robot.name, .problem = "URDF has no suction cups: write a .json"});
    robots_.push_back(urdf_form(platform_, mounted));
    write_robot(robots_.back());
    if (mounted.parent >= 0) write_mount(mounted, robots_.back());
  }
  xml_.close();
  std::filesystem::path beside = name_.filename();
  files_.push_back({beside.replace_extension(".prehend.json"), sidecar()});
  files_.push_back({name_.filename(), "<?xml version=\"1.0\"?>\n" + xml_.text()});
  return std::move(files_);
}

}  // namespace

std::vector<RobotTextFile> urdf_text(const Platform& platform, const std::filesystem::path& name) {
  return UrdfWriter(platform, name).write();
}

}  // namespace prehend
