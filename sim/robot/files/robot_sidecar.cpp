#include "sim/robot/files/robot_sidecar.h"

#include "sim/base/index.h"
#include "sim/base/material.h"
#include "sim/base/range.h"
#include "sim/robot/files/robot_file_parts.h"

namespace prehend {
namespace {

constexpr const char* kAllLinks = "*";

int link_called(const JsonField& field, const std::string& name, const JointTree& tree) {
  for (std::size_t l = 0; l < tree.links.size(); ++l) {
    if (tree.links[l].name == name) return static_cast<int>(l);
  }
  field.fail("no link is called " + name);
}

void read_materials(const JsonField& field, JointTree& tree) {
  const auto material = [](const JsonField& name) {
    return with_field_errors(name,
                             [&] { return std::string(name_of(material_named(name.text()))); });
  };
  if (field.has(kAllLinks)) {
    for (TreeLink& link : tree.links) link.material = material(field[kAllLinks]);
  }
  for (const std::string& name : field.keys()) {
    if (name == kAllLinks) continue;
    tree.links[index(link_called(field[name], name, tree))].material = material(field[name]);
  }
}

void read_exempt_links(const JsonField& field, JointTree& tree) {
  for (const JsonField& pair : field.items()) {
    const std::vector<JsonField> names = pair.items();
    if (names.size() != 2) pair.fail("must be the names of two links");
    tree.exempt_pairs.emplace_back(link_called(names[0], names[0].text(), tree),
                                   link_called(names[1], names[1].text(), tree));
  }
}

void read_motion_of(const JsonField& field, const FileUnits& units, Platform& platform) {
  field.allow_only({"name", "initial", "closing_velocity", "velocity", "acceleration", "coupling",
                    "breakaway_effort", "stiffness", "damping"});
  for (MountedRobot& mounted : platform.robots) {
    for (std::size_t d = 0; d < mounted.robot.dofs.size(); ++d) {
      if (mounted.robot.dofs[d].name != field["name"].text()) continue;
      read_motion(field, units, static_cast<int>(d), mounted.robot);
      return;
    }
  }
  field["name"].fail("no degree of freedom of this name");
}

void read_spring_of(const JsonField& field, const std::string& name, const FileUnits& units,
                    Platform& platform) {
  for (MountedRobot& mounted : platform.robots) {
    for (Joint& joint : mounted.robot.joints) {
      if (joint.name != name) continue;
      joint.spring = read_spring(field, joint.type, units);
      return;
    }
  }
  field.fail("no joint is called " + name);
}

}  // namespace

RobotSidecar::RobotSidecar(const std::filesystem::path& file) : file_(file) {
  file_.root().allow_only({"units", "packages", "srdf", "arguments", "scale", "materials",
                           "hand_root", "dofs", "springs", "hand", "exempt_collisions"});
}

std::filesystem::path RobotSidecar::path_beside(const std::filesystem::path& robot_file) {
  std::filesystem::path path = robot_file;
  return path.replace_extension(".prehend.json");
}

ForeignRobotOptions RobotSidecar::options(ForeignRobotOptions options) const {
  const JsonField root = file_.root();
  const std::filesystem::path folder = file_.path().parent_path();
  if (root.has("packages")) {
    for (const std::string& name : root["packages"].keys()) {
      options.packages.emplace(name, folder / root["packages"][name].text());
    }
  }
  if (root.has("srdf") && options.srdf.empty()) options.srdf = folder / root["srdf"].text();
  if (root.has("arguments")) {
    for (const std::string& name : root["arguments"].keys()) {
      options.arguments.emplace(name, root["arguments"][name].text());
    }
  }
  if (root.has("scale") && options.scale == 1.0) {
    options.scale = root["scale"].number(kLengthAbove0);
  }
  return options;
}

void RobotSidecar::complete(JointTree& tree) const {
  const JsonField root = file_.root();
  if (root.has("materials")) read_materials(root["materials"], tree);
  if (root.has("exempt_collisions")) read_exempt_links(root["exempt_collisions"], tree);
}

std::optional<std::string> RobotSidecar::hand_root() const {
  const JsonField root = file_.root();
  if (!root.has("hand_root")) return std::nullopt;
  if (root["hand_root"].is_null()) return "";
  return root["hand_root"].text();
}

void RobotSidecar::complete(Platform& platform) const {
  const JsonField root = file_.root();
  const FileUnits units = read_units(root);
  if (root.has("dofs")) {
    for (const JsonField& field : root["dofs"].items()) read_motion_of(field, units, platform);
  }
  if (root.has("springs")) {
    for (const std::string& name : root["springs"].keys()) {
      read_spring_of(root["springs"][name], name, units, platform);
    }
  }
  if (root.has("hand")) {
    Robot& robot = platform.robots.back().robot;
    robot.hand = read_hand(root["hand"], units, robot);
  }
}

}  // namespace prehend
