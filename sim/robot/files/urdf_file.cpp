#include "sim/robot/files/urdf_file.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/range.h"
#include "sim/robot/files/loop_closure.h"
#include "sim/robot/files/urdf_geometry.h"

namespace prehend {
namespace {

// A continuous joint turns without end; a whole turn to either side reaches all postures.
constexpr double kWholeTurn = 2.0 * std::numbers::pi;
constexpr double kFreeSlide = 1.0;  // [m]
constexpr double kShortestAxis = 1e-100;

// Elements that need no word: they do not matter to planning, or say what else is said.
const std::set<std::string>& silent_tags() {
  static const std::set<std::string> tags = {"link",
                                             "joint",
                                             "loop_joint",
                                             "material",
                                             "transmission",
                                             "gazebo",
                                             "ros2_control",
                                             "inertial",
                                             "visual",
                                             "limit",
                                             "safety_controller",
                                             "calibration",
                                             "collision",
                                             "origin",
                                             "parent",
                                             "child",
                                             "axis",
                                             "dynamics",
                                             "mimic",
                                             "sensor",
                                             "verbose",
                                             "self_collision_checking",
                                             "drake:rotor_inertia",
                                             "drake:collision_filter_group"};
  return tags;
}

class UrdfReader {
 public:
  UrdfReader(const XmlFile& file, const ForeignRobotOptions& options)
      : root_(file.root()), geometry_(options.packages) {}

  JointTree read();

 private:
  void read_link(const XmlElement& element);
  void read_joint(const XmlElement& element);
  void read_limits(const XmlElement& element, bool continuous, TreeJoint& joint);
  void read_mimic(const XmlElement& element);
  void read_filter_groups();
  void read_loops();
  int link_named(const XmlElement& element) const;
  void look_for_unread(const XmlElement& element);
  void note_all();

  XmlElement root_;
  UrdfGeometry geometry_;
  JointTree tree_;
  std::map<std::string, int> link_of_;
  std::map<std::string, int> joint_of_;
  std::vector<std::string> endless_;
  std::vector<std::string> continuous_;
  std::vector<std::string> massless_;
  std::map<std::string, std::string> unread_;  // tag -> place of the first
};

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMostNamed = 8;
  std::string text;
  for (std::size_t k = 0; k < std::min(names.size(), kMostNamed); ++k) {
    text += (k > 0 ? ", " : "") + names[k];
  }
  const std::size_t more = names.size() - std::min(names.size(), kMostNamed);
  return more > 0 ? text + " and " + std::to_string(more) + " more" : text;
}

// `massless`: names of links whose inertia no body has get there.
Inertial read_urdf_inertial(const XmlElement& link, const TriangleMesh& mesh,
                            std::vector<std::string>& massless) {
  const std::optional<XmlElement> element = link.child("inertial");
  if (!element) return {};
  const XmlElement mass = (*element)["mass"];
  Inertial inertial{.mass = mass.number("value")};
  if (inertial.mass < 0.0) mass.fail("must not be negative", mass.text("value"));
  if (inertial.mass == 0.0) return {};
  const XmlElement moments = (*element)["inertia"];
  const double xy = moments.number_or("ixy", 0.0);
  const double xz = moments.number_or("ixz", 0.0);
  const double yz = moments.number_or("iyz", 0.0);
  const double xx = moments.number("ixx");
  const double yy = moments.number("iyy");
  const double zz = moments.number("izz");
  inertial.inertia << xx, xy, xz,  //
      xy, yy, yz,                  //
      xz, yz, zz;
  const Pose X_LI = urdf_origin(*element);
  if (!inertia_defect(inertial.inertia).empty()) {
    massless.push_back(link.text("name"));
    return mesh.empty() ? Inertial{} : inertial_of_mass(mesh, inertial.mass);
  }
  return transformed(inertial, X_LI);
}

JointTree UrdfReader::read() {
  tree_.file = root_.file().string();
  tree_.name = root_.text_or("name", root_.file().stem().string());
  look_for_unread(root_);
  for (const XmlElement& link : root_.children("link")) read_link(link);
  for (const XmlElement& joint : root_.children("joint")) read_joint(joint);
  for (const XmlElement& joint : root_.children("joint")) read_mimic(joint);
  read_filter_groups();
  note_all();
  read_loops();
  return std::move(tree_);
}

void UrdfReader::read_link(const XmlElement& element) {
  const std::string name = element.text("name");
  if (!link_of_.emplace(name, static_cast<int>(tree_.links.size())).second) {
    element.fail("name used twice", name);
  }
  look_for_unread(element);
  TreeLink link{.name = name, .place = element.place()};
  link.mesh = geometry_.read(element);
  link.inertial = read_urdf_inertial(element, link.mesh, massless_);
  tree_.links.push_back(std::move(link));
}

int UrdfReader::link_named(const XmlElement& element) const {
  const auto found = link_of_.find(element.text("link"));
  if (found == link_of_.end()) element.fail("no link of this name", element.text("link"));
  return found->second;
}

// What many files write for a joint without limits.
std::optional<double> infinity_in(const XmlElement& limit, const char* attribute) {
  std::string word = limit.has(attribute) ? limit.text(attribute) : "";
  const bool negative = word.starts_with('-');
  std::erase_if(word, [](char c) { return c == '-' || c == '+' || c == '.' || c == ' '; });
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (word != "inf" && word != "infinity") return std::nullopt;
  return negative ? -1.0 : 1.0;
}

// Limits that are not positive mean that they are not known, huge ones that there are none.
double known_or_zero(const XmlElement& element, const char* attribute) {
  if (infinity_in(element, attribute)) return 0.0;
  const double value = element.number_or(attribute, 0.0);
  return kRateAbove0.contains(value) ? value : 0.0;
}

bool endless(const XmlElement& limit) {
  return infinity_in(limit, "lower") || infinity_in(limit, "upper");
}

// An infinite limit becomes `far`.
double limit_or(const XmlElement& limit, const char* attribute, double far) {
  const std::optional<double> side = infinity_in(limit, attribute);
  return side ? *side * far : limit.number_or(attribute, 0.0);
}

void UrdfReader::read_limits(const XmlElement& element, bool continuous, TreeJoint& joint) {
  const std::optional<XmlElement> limit = element.child("limit");
  if (!limit && !continuous) element.fail("<limit> is missing inside", joint.name);
  if (continuous) {
    joint.lower = -kWholeTurn;
    joint.upper = kWholeTurn;
    continuous_.push_back(joint.name);
  } else {
    const double far = joint.type == TreeJointType::prismatic ? kFreeSlide : kWholeTurn;
    joint.lower = limit_or(*limit, "lower", far);
    joint.upper = limit_or(*limit, "upper", far);
    if (endless(*limit)) endless_.push_back(joint.name);
    if (joint.lower > joint.upper)
      limit->fail("the lower limit must be at most the upper one", joint.name);
  }
  if (!limit) return;
  joint.max_effort = known_or_zero(*limit, "effort");
  joint.max_velocity = known_or_zero(*limit, "velocity");
  joint.max_acceleration = known_or_zero(*limit, "drake:acceleration");
  if (limit->has("acceleration")) joint.max_acceleration = known_or_zero(*limit, "acceleration");
}

void UrdfReader::read_joint(const XmlElement& element) {
  TreeJoint joint{.name = element.text("name"), .place = element.place()};
  if (!joint_of_.emplace(joint.name, static_cast<int>(tree_.joints.size())).second) {
    element.fail("name used twice", joint.name);
  }
  look_for_unread(element);
  const std::string type = element.text("type");
  if (type == "floating" || type == "planar") {
    element.fail("joints of type " + type +
                     " cannot be planned with; write them as revolute and prismatic joints",
                 joint.name);
  }
  const bool continuous = type == "continuous";
  if (type == "revolute" || continuous) {
    joint.type = TreeJointType::revolute;
  } else if (type == "prismatic") {
    joint.type = TreeJointType::prismatic;
  } else if (type != "fixed") {
    element.fail("unknown joint type, known are revolute, continuous, prismatic and fixed", type);
  }
  joint.parent = link_named(element["parent"]);
  joint.child = link_named(element["child"]);
  joint.X_LJ = urdf_origin(element);
  if (joint.type != TreeJointType::fixed) {
    if (const auto axis = element.child("axis")) {
      const Vector3 direction = axis->vector3("xyz");
      if (!(direction.norm() > kShortestAxis)) axis->fail("must not be 0", axis->text("xyz"));
      joint.axis = direction.stableNormalized();
    }
    read_limits(element, continuous, joint);
    if (const auto dynamics = element.child("dynamics")) {
      joint.friction = {.coulomb = known_or_zero(*dynamics, "friction"),
                        .viscous = known_or_zero(*dynamics, "damping")};
    }
  }
  tree_.joints.push_back(std::move(joint));
}

// After all joints: the one that is mimicked may stand behind.
void UrdfReader::read_mimic(const XmlElement& element) {
  const std::optional<XmlElement> mimic = element.child("mimic");
  TreeJoint& joint = tree_.joints[index(joint_of_.at(element.text("name")))];
  if (!mimic || joint.type == TreeJointType::fixed) return;
  const auto found = joint_of_.find(mimic->text("joint"));
  if (found == joint_of_.end()) mimic->fail("no joint of this name", mimic->text("joint"));
  const TreeJointType other = tree_.joints[index(found->second)].type;
  if (other != joint.type && other != TreeJointType::fixed) {
    tree_.notes.push_back(mimic->place() + ": joint " + joint.name + " mimics " +
                          mimic->text("joint") +
                          ", a joint of another type: left out, they move independently");
    return;
  }
  joint.mimic = Mimic{.joint = found->second,
                      .ratio = mimic->number_or("multiplier", 1.0),
                      .offset = mimic->number_or("offset", 0.0)};
}

// Drake's way to close loops: a point of one link stays on one of another. What a transmission
// moves is the drive.
void UrdfReader::read_loops() {
  std::vector<Loop> loops;
  for (const XmlElement& element : root_.children("loop_joint")) {
    const std::string type = element.text_or("type", "");
    if (type != "revolute" && type != "continuous" && type != "ball") {
      tree_.notes.push_back(element.place() + ": a loop that is not closed by a hinge is left out");
      continue;
    }
    const XmlElement first = element["link1"];
    const XmlElement second = element["link2"];
    const auto point = [](const XmlElement& link) {
      const Vector3 p = link.vector3_or("xyz", Vector3::Zero());
      if (!(p.cwiseAbs().maxCoeff() <= kFarthest)) link.fail("must not be farther away than 1e6 m");
      return p;
    };
    loops.push_back({link_named(first), link_named(second), point(first), point(second)});
  }
  if (loops.empty()) return;
  (void)root_of(tree_);
  std::set<int> driven;
  for (const XmlElement& transmission : root_.children("transmission")) {
    for (const XmlElement& joint : transmission.children("joint")) {
      const auto found = joint_of_.find(joint.text_or("name", ""));
      if (found != joint_of_.end()) driven.insert(found->second);
    }
  }
  close_loops(loops, driven, tree_);
}

// Drake's way to exempt pairs of links: each group names groups that its members are not checked
// against.
void UrdfReader::read_filter_groups() {
  std::map<std::string, std::vector<int>> members;
  const std::vector<XmlElement> groups = root_.children("drake:collision_filter_group");
  for (const XmlElement& group : groups) {
    for (const XmlElement& member : group.children("drake:member")) {
      members[group.text("name")].push_back(link_named(member));
    }
  }
  for (const XmlElement& group : groups) {
    for (const XmlElement& other : group.children("drake:ignored_collision_filter_group")) {
      const auto found = members.find(other.text("name"));
      if (found == members.end()) continue;
      for (const int a : members[group.text("name")]) {
        for (const int b : found->second) tree_.exempt_pairs.emplace_back(a, b);
      }
    }
  }
}

void UrdfReader::look_for_unread(const XmlElement& element) {
  for (const XmlElement& child : element.children()) {
    if (!silent_tags().contains(child.name())) unread_.emplace(child.name(), child.place());
  }
}

void UrdfReader::note_all() {
  const auto note = [&](const std::string& text) { tree_.notes.push_back(text); };
  if (!geometry_.visual_links().empty()) {
    note("links without collision geometry, whose visual geometry is used: " +
         listed(geometry_.visual_links()));
  }
  std::vector<std::string> frames;
  for (const TreeLink& link : tree_.links) {
    if (link.mesh.empty()) frames.push_back(link.name);
  }
  if (!frames.empty()) note("links without geometry, which are frames only: " + listed(frames));
  if (!continuous_.empty()) {
    note("joints without limits, which may turn once to either side: " + listed(continuous_));
  }
  if (!endless_.empty()) {
    note("joints with infinite limits, taken as one turn or 1 m to that side: " + listed(endless_));
  }
  for (const std::string& remark : geometry_.remarks()) note(remark);
  if (!massless_.empty()) {
    note("links with an inertia that no body has, found from their geometry in its place: " +
         listed(massless_));
  }
  for (const auto& [tag, place] : unread_) note(place + ": is not read");
}

}  // namespace

JointTree read_urdf(const XmlFile& file, const ForeignRobotOptions& options) {
  return UrdfReader(file, options).read();
}

}  // namespace prehend
