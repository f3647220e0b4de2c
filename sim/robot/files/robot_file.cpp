#include "sim/robot/files/robot_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "sim/base/input_error.h"
#include "sim/base/json/json_field.h"
#include "sim/base/range.h"
#include "sim/robot/files/foreign_robot.h"
#include "sim/robot/files/robot_file_parts.h"
#include "sim/robot/sound_robot.h"
#include "sim/robot/spherical_wrist.h"
#include "sim/robot/ur_arm.h"

namespace prehend {
namespace {

constexpr int kUndriven = -1;

// Reads one file into one robot, in the order that later parts need earlier ones:
// named geometry, base, joints, degrees of freedom, links, hand.
class RobotReader {
 public:
  explicit RobotReader(const JsonField& root) : root_(root) {}

  Robot read();

 private:
  void read_named_geometry();
  void read_base_links();
  void read_exempt_pairs();
  void read_frames();
  void add_link(const JsonField& field, int joint);
  void read_chain(const JsonField& field);
  int read_parent(const JsonField& field) const;
  void add_joint(const JsonField& field, int parent, const Pose& X_PC);
  void read_dof(const JsonField& field);
  void read_drive(const JsonField& field, int dof);
  void read_across(const JsonField& drive);
  void derive_limits(const JsonField& field, int dof);
  void read_chain_links(const JsonField& chain_field, const Chain& chain);

  double unit_of(JointType type) const {
    return type == JointType::revolute ? units_.angle : units_.length;
  }

  JsonField root_;
  FileUnits units_;
  ShapeBudget budget_;
  NamedGeometry named_;
  std::map<std::string, int> joint_index_;
  std::vector<std::string> joint_field_;  // where each joint stands in the file
  Robot robot_;
};

template <typename Named>
void require_new_name(const JsonField& field, const std::vector<Named>& others) {
  const std::string name = field.text();
  for (const Named& other : others) {
    if (other.name == name) field.fail("name used twice");
  }
}

ClosedForm read_closed_form(const JsonField& field, const Robot& robot, const Chain& chain) {
  const std::string name = field.text();
  if (name != "spherical_wrist" && name != "ur") {
    field.fail("unknown closed form, known are spherical_wrist and ur");
  }
  const bool ur = name == "ur";
  const std::string defect =
      ur ? ur_arm_defect(robot, chain) : spherical_wrist_defect(robot, chain);
  if (!defect.empty()) field.fail(defect);
  return ur ? ClosedForm::ur : ClosedForm::spherical_wrist;
}

Robot RobotReader::read() {
  root_.allow_only({"name", "units", "geometries", "base", "links", "chains", "dofs", "hand",
                    "frames", "exempt_collisions"});
  robot_.name = root_["name"].text();
  units_ = read_units(root_);
  if (root_.has("geometries")) read_named_geometry();
  const JsonField base = root_["base"];
  base.allow_only({"name", "driver_name", "material", "geometry", "mass", "density",
                   "center_of_mass", "inertia"});
  add_link(base, -1);
  if (root_.has("links")) read_base_links();
  const std::vector<JsonField> chains = root_["chains"].items();
  for (const JsonField& chain : chains) read_chain(chain);
  for (const JsonField& dof : root_["dofs"].items()) read_dof(dof);
  for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
    if (robot_.joints[j].dof != kUndriven) continue;
    throw InputError({.file = root_.file().string(),
                      .field = joint_field_[j] + ".name",
                      .problem = "must be driven by a degree of freedom",
                      .value = robot_.joints[j].name});
  }
  for (std::size_t c = 0; c < chains.size(); ++c) read_chain_links(chains[c], robot_.chains[c]);
  if (root_.has("exempt_collisions")) read_exempt_pairs();
  if (root_.has("frames")) read_frames();
  if (root_.has("hand")) robot_.hand = read_hand(root_["hand"], units_, robot_);
  return std::move(robot_);
}

void RobotReader::read_named_geometry() {
  const JsonField all = root_["geometries"];
  for (const std::string& name : all.keys()) {
    const std::size_t before = budget_.made();
    // Named geometries do not refer to each other.
    TriangleMesh mesh = read_geometry(all[name], units_, {}, budget_);
    named_.emplace(name, Geometry{std::move(mesh), budget_.made() - before});
  }
}

void RobotReader::add_link(const JsonField& field, int joint) {
  require_new_name(field["name"], robot_.links);
  robot_.links.push_back(read_link(field, units_, named_, budget_, joint));
}

// Links beside the base that do not move either.
void RobotReader::read_base_links() {
  for (const JsonField& field : root_["links"].items()) {
    field.allow_only({"name", "driver_name", "material", "geometry", "mass", "density",
                      "center_of_mass", "inertia"});
    add_link(field, -1);
  }
}

void RobotReader::read_exempt_pairs() {
  const auto link_called = [&](const JsonField& name) {
    for (std::size_t l = 0; l < robot_.links.size(); ++l) {
      if (robot_.links[l].name == name.text()) return static_cast<int>(l);
    }
    name.fail("no link of this name");
  };
  for (const JsonField& pair : root_["exempt_collisions"].items()) {
    const std::vector<JsonField> names = pair.items();
    if (names.size() != 2) pair.fail("must be the names of two links");
    const auto [a, b] = std::minmax({link_called(names[0]), link_called(names[1])});
    if (a == b) pair.fail("must name two different links");
    robot_.exempt_pairs.emplace_back(a, b);
  }
}

void RobotReader::read_frames() {
  for (const JsonField& field : root_["frames"].items()) {
    field.allow_only({"name", "role", "joint", "pose"});
    require_new_name(field["name"], robot_.frames);
    RobotFrame frame{.name = field["name"].text()};
    if (field.has("role")) {
      const JsonField role = field["role"];
      const std::optional<FrameRole> known = value_named<FrameRole>(role.text());
      if (!known) role.fail("unknown role, known are base, flange, tool and none");
      frame.role = *known;
    }
    if (field.has("joint")) {
      const auto found = joint_index_.find(field["joint"].text());
      if (found == joint_index_.end()) field["joint"].fail("no joint of this name");
      frame.joint = found->second;
    }
    if (field.has("pose")) frame.X_AF = read_pose(field["pose"], units_);
    robot_.frames.push_back(std::move(frame));
  }
}

void RobotReader::read_chain(const JsonField& field) {
  field.allow_only({"name", "parent", "base", "joints", "links", "inverse_kinematics"});
  require_new_name(field["name"], robot_.chains);
  Chain chain{.name = field["name"].text()};
  const int parent = field.has("parent") ? read_parent(field["parent"]) : -1;
  const Pose X_PC = field.has("base") ? read_pose(field["base"], units_) : Pose::Identity();
  chain.first_joint = static_cast<int>(robot_.joints.size());
  const std::vector<JsonField> joints = field["joints"].items();
  if (joints.empty()) field["joints"].fail("a chain needs at least one joint");
  chain.joint_count = static_cast<int>(joints.size());
  add_joint(joints.front(), parent, X_PC);
  for (int k = 1; k < chain.joint_count; ++k) {
    add_joint(joints[static_cast<std::size_t>(k)], chain.first_joint + k - 1, Pose::Identity());
  }
  if (field.has("inverse_kinematics")) {
    chain.closed_form = read_closed_form(field["inverse_kinematics"], robot_, chain);
  }
  robot_.chains.push_back(std::move(chain));
}

int RobotReader::read_parent(const JsonField& field) const {
  const auto found = joint_index_.find(field.text());
  if (found == joint_index_.end())
    field.fail("must be the name of a joint in a chain before this one");
  return found->second;
}

// `X_PC`: the frame in which the file gives the joint, in the frame after its parent.
void RobotReader::add_joint(const JsonField& field, int parent, const Pose& X_PC) {
  Joint joint = read_joint(field, units_);
  require_new_name(field["name"], robot_.joints);
  joint.X_PJ = X_PC * joint.X_PJ;
  joint.dof = kUndriven;
  joint.parent = parent;
  joint.chain = static_cast<int>(robot_.chains.size());
  joint_index_.emplace(joint.name, static_cast<int>(robot_.joints.size()));
  joint_field_.push_back(field.name());
  robot_.joints.push_back(std::move(joint));
}

void RobotReader::read_dof(const JsonField& field) {
  field.allow_only({"name", "drives", "initial", "closing_velocity", "coupling", "breakaway_effort",
                    "velocity", "acceleration", "stiffness", "damping"});
  require_new_name(field["name"], robot_.dofs);
  const int dof = static_cast<int>(robot_.dofs.size());
  robot_.dofs.push_back({.name = field["name"].text()});
  const std::vector<JsonField> drives = field["drives"].items();
  if (drives.empty()) field["drives"].fail("a degree of freedom must drive at least one joint");
  for (const JsonField& drive : drives) read_drive(drive, dof);
  for (const JsonField& drive : drives) read_across(drive);
  derive_limits(field, dof);
  robot_.dofs.back().initial = std::clamp(0.0, robot_.dofs.back().lower, robot_.dofs.back().upper);
  (void)field["closing_velocity"];  // needed here
  read_motion(field, units_, dof, robot_);
}

void RobotReader::read_drive(const JsonField& field, int dof) {
  field.allow_only({"joint", "ratio", "offset", "across", "ahead"});
  const JsonField name = field["joint"];
  const auto found = joint_index_.find(name.text());
  if (found == joint_index_.end()) name.fail("no joint of this name");
  Joint& joint = robot_.joints[static_cast<std::size_t>(found->second)];
  if (joint.dof != kUndriven) name.fail("joint is driven twice");
  for (const Joint& other : robot_.joints) {
    if (other.dof == dof && other.type != joint.type) {
      name.fail("a degree of freedom drives joints of one type only");
    }
  }
  joint.ratio = field.number_or("ratio", 1.0);
  const bool rests = joint.ratio == 0.0 && field.has("across");
  if (!rests && !kRatioSize.contains(std::abs(joint.ratio))) {
    field["ratio"].fail("its size " + kRatioSize.words());
  }
  joint.offset = field.number_or("offset", 0.0, kCoordinate, unit_of(joint.type));
  joint.dof = dof;
}

// Once all drives of the degree of freedom are read.
void RobotReader::read_across(const JsonField& drive) {
  if (!drive.has("across")) {
    if (drive.has("ahead"))
      drive["ahead"].fail("says how far it goes ahead across a joint: add across");
    return;
  }
  const JsonField field = drive["across"];
  const int joint = joint_index_.find(drive["joint"].text())->second;
  const auto found = joint_index_.find(field.text());
  if (found == joint_index_.end()) field.fail("no joint of this name");
  Joint& own = robot_.joints[static_cast<std::size_t>(joint)];
  if (found->second == joint ||
      robot_.joints[static_cast<std::size_t>(found->second)].dof != own.dof) {
    field.fail("must be another joint that the same degree of freedom drives");
  }
  own.across = found->second;
  own.ahead = drive.number_or("ahead", 1.0, kCoordinate);
}

// The values at which ratio * value + offset is inside the limits of every driven joint.
void RobotReader::derive_limits(const JsonField& field, int dof) {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  for (const Joint& joint : robot_.joints) {
    if (joint.dof != dof || joint.ratio == 0.0) continue;
    const double from = (joint.lower - joint.offset) / joint.ratio;
    const double to = (joint.upper - joint.offset) / joint.ratio;
    lower = std::max(lower, std::min(from, to));
    upper = std::min(upper, std::max(from, to));
  }
  if (lower > upper) {
    field["drives"].fail("no value keeps every driven joint inside its limits");
  }
  robot_.dofs[static_cast<std::size_t>(dof)].lower = lower;
  robot_.dofs[static_cast<std::size_t>(dof)].upper = upper;
}

void RobotReader::read_chain_links(const JsonField& chain_field, const Chain& chain) {
  for (const JsonField& field : chain_field["links"].items()) {
    field.allow_only({"name", "driver_name", "joint", "material", "geometry", "mass", "density",
                      "center_of_mass", "inertia", "pad"});
    const JsonField name = field["joint"];
    const auto found = joint_index_.find(name.text());
    if (found == joint_index_.end() || found->second < chain.first_joint ||
        found->second >= chain.first_joint + chain.joint_count) {
      name.fail("no joint of this name in the link's chain");
    }
    add_link(field, found->second);
  }
}

}  // namespace

Robot load_robot(const std::filesystem::path& file, const ForeignRobotOptions& options) {
  if (auto foreign = read_foreign_robot(file, options)) return robot_alone(std::move(*foreign));
  return read_robot(JsonFile(file));
}

Robot read_robot(const JsonFile& file) { return RobotReader(file.root()).read(); }

}  // namespace prehend
