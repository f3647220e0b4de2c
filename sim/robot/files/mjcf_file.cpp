#include "sim/robot/files/mjcf_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "sim/base/index.h"
#include "sim/robot/files/loop_closure.h"
#include "sim/robot/files/mjcf_geometry.h"
#include "sim/robot/files/mjcf_parts.h"

namespace prehend {
namespace {

// What a hinge without a range may turn to either side.
constexpr double kFreeTurn = 2.0 * std::numbers::pi;
constexpr double kFreeWay = 1.0;  // of a slide joint without range [m]

bool has_joint_below(const XmlElement& body) {
  const std::vector<XmlElement> bodies = body.children("body");
  return body.child("joint") || std::any_of(bodies.begin(), bodies.end(), has_joint_below);
}

// The one body with joints that turn or slide, where it is free: a robot that flies.
std::optional<std::size_t> free_robot(const std::vector<XmlElement>& bodies) {
  std::optional<std::size_t> only;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (!has_joint_below(bodies[b])) continue;
    if (only || !bodies[b].child("freejoint")) return std::nullopt;
    only = b;
  }
  return only;
}

class MjcfReader {
 public:
  explicit MjcfReader(const XmlFile& file)
      : root_(file.root()), defaults_(root_), geometry_(root_, defaults_) {}

  JointTree read();

 private:
  void read_world();
  void read_body(const XmlElement& body, int parent, const Pose& X_PB, const std::string& around);
  int add_joints(const XmlElement& body, const std::string& name, int parent, const Pose& X_PB,
                 const std::string& childclass);
  TreeJoint read_joint(const XmlElement& element, const std::string& name,
                       const std::string& childclass);
  void read_range(const XmlElement& element, const std::string& childclass, TreeJoint& joint);
  Inertial read_inertial(const XmlElement& body) const;
  void add_fixed(const std::string& name, int parent, int child, const Pose& X,
                 const XmlElement& of);
  int add_link(const std::string& name, const XmlElement& of);
  void read_loop(const XmlElement& element);
  std::set<int> driven_joints() const;
  void read_couplings();
  void couple(const XmlElement& element);
  void read_tendons();
  void read_exclusions();
  void read_efforts();
  void read_home();
  void note_unread();
  int joint_called(const XmlElement& at, const std::string& attribute) const;
  int body_called(const XmlElement& at, const std::string& attribute) const;

  XmlElement root_;
  MjcfDefaults defaults_;
  MjcfGeometry geometry_;
  JointTree tree_;
  std::map<std::string, int> body_of_;
  std::map<std::string, int> joint_of_;
  std::map<int, double> ref_;  // of joints that have one
  std::vector<int> moving_;    // joints in the order of the file
  std::set<std::string> names_;
  std::vector<Loop> loops_;
};

JointTree MjcfReader::read() {
  tree_.file = root_.file().string();
  tree_.name = root_.text_or("model", root_.file().stem().string());
  if (const auto found = root_.child("extension")) {
    found->fail("cannot be read; save the model without plugins");
  }
  read_world();
  read_couplings();
  read_tendons();
  read_exclusions();
  read_efforts();
  read_home();
  close_loops(loops_, driven_joints(), tree_);
  note_unread();
  return std::move(tree_);
}

int MjcfReader::add_link(const std::string& name, const XmlElement& of) {
  if (!names_.insert(name).second) of.fail("name used twice", name);
  tree_.links.push_back({.name = name, .place = of.place()});
  return static_cast<int>(tree_.links.size()) - 1;
}

void MjcfReader::add_fixed(const std::string& name, int parent, int child, const Pose& X,
                           const XmlElement& of) {
  tree_.joints.push_back(
      {.name = name, .parent = parent, .child = child, .X_LJ = X, .place = of.place()});
}

void MjcfReader::read_world() {
  std::vector<XmlElement> bodies;
  for (const XmlElement& world : root_.children("worldbody")) {
    for (const XmlElement& body : world.children("body")) bodies.push_back(body);
    if (world.child("geom")) {
      tree_.notes.push_back("geoms of the world itself are left out");
    }
    for (const char* maker : {"composite", "flexcomp", "attach"}) {
      if (const auto found = world.child(maker))
        found->fail("cannot be read; save the model as one file (mj_saveLastXML)");
    }
  }
  if (bodies.empty()) root_.fail("there is no body in <worldbody>");
  if (const std::optional<std::size_t> only = free_robot(bodies)) {
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      if (b != *only)
        tree_.notes.push_back(bodies[b].place() + ": a body beside the robot is left out");
    }
    read_body(bodies[*only], -1, Pose::Identity(), "");
    return;
  }
  const bool has_joint = bodies.front().child("joint").has_value();
  if (bodies.size() == 1 && !has_joint) {
    read_body(bodies.front(), -1, Pose::Identity(), "");
    return;
  }
  const int world = add_link("world", root_);
  for (const XmlElement& body : bodies) {
    const bool free = body.child("freejoint").has_value();
    if (free) {
      tree_.notes.push_back(body.place() + ": a free body beside the robot is left out");
      continue;
    }
    read_body(body, world, defaults_.pose(body, ""), "");
  }
}

Inertial MjcfReader::read_inertial(const XmlElement& body) const {
  const std::optional<XmlElement> element = body.child("inertial");
  if (!element) return {};
  Inertial inertial{.mass = element->number("mass")};
  if (inertial.mass < 0.0) element->fail("attribute mass must not be negative");
  if (inertial.mass == 0.0) return {};
  if (element->has("fullinertia")) {
    const std::vector<double> i = element->numbers("fullinertia");
    if (i.size() != 6) element->fail("attribute fullinertia must have 6 numbers");
    inertial.inertia << i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2];
  } else {
    inertial.inertia = element->vector3_or("diaginertia", Vector3::Zero()).asDiagonal();
  }
  const std::string defect = inertia_defect(inertial.inertia);
  if (!defect.empty()) element->fail("the inertia " + defect);
  return transformed(inertial, defaults_.pose(*element, ""));
}

void MjcfReader::read_body(const XmlElement& body, int parent, const Pose& X_PB,
                           const std::string& around) {
  for (const char* maker : {"composite", "flexcomp", "attach"}) {
    if (const auto found = body.child(maker))
      found->fail("cannot be read; save the model as one file (mj_saveLastXML)");
  }
  const std::string childclass = body.text_or("childclass", around);
  const std::string name = body.text_or("name", "body_" + std::to_string(tree_.links.size()));
  const int link =
      parent < 0 ? add_link(name, body) : add_joints(body, name, parent, X_PB, childclass);
  body_of_[name] = link;
  tree_.links[index(link)].mesh = geometry_.read(body.children("geom"), childclass);
  tree_.links[index(link)].inertial = read_inertial(body);
  for (const XmlElement& child : body.children("body")) {
    read_body(child, link, defaults_.pose(child, childclass), childclass);
  }
}

// The joints of a body turn one after the other, the first one nearest to the parent, each about
// its own point of the body. Returns the link of the body behind them.
int MjcfReader::add_joints(const XmlElement& body, const std::string& name, int parent,
                           const Pose& X_PB, const std::string& childclass) {
  const std::vector<XmlElement> joints = body.children("joint");
  if (body.child("freejoint")) {
    body.fail("a free joint below another body cannot be planned with", name);
  }
  Pose X = X_PB;  // of the body, at rest, in the frame that the next joint hangs on
  int carrier = parent;
  for (const XmlElement& element : joints) {
    const std::string joint_name = element.text_or(
        "name", name + "_joint" + (&element == &joints.front() ? "" : std::to_string(carrier)));
    TreeJoint joint = read_joint(element, joint_name, childclass);
    Vector3 p = Vector3::Zero();
    if (const auto at = defaults_.saying("pos", element, childclass)) p = at->vector3("pos");
    const bool last = &element == &joints.back();
    const bool ends_here = last && p == Vector3::Zero();
    joint.parent = carrier;
    std::string link_name = name;
    if (!ends_here) link_name.append("_at_").append(joint_name);
    joint.child = add_link(link_name, body);
    joint.X_LJ = X * translation(p) * joint.X_LJ;  // which held the motion to its reference
    X = translation(-p);
    carrier = joint.child;
    if (!joint_of_.emplace(joint_name, static_cast<int>(tree_.joints.size())).second) {
      element.fail("name used twice", joint_name);
    }
    moving_.push_back(static_cast<int>(tree_.joints.size()));
    tree_.joints.push_back(std::move(joint));
    if (ends_here) return carrier;
  }
  const int link = add_link(name, body);
  add_fixed(name + "_fixed", carrier, link, X, body);
  return link;
}

void MjcfReader::read_range(const XmlElement& element, const std::string& childclass,
                            TreeJoint& joint) {
  const bool turns = joint.type == TreeJointType::revolute;
  const double unit = turns ? defaults_.angle_unit() : 1.0;
  const auto range = defaults_.saying("range", element, childclass);
  const auto limited = defaults_.saying("limited", element, childclass);
  const std::string words = limited ? limited->text("limited") : "auto";
  const bool has_range = range && (words == "true" || (words == "auto" && defaults_.autolimits()));
  if (!has_range) {
    const double far = turns ? kFreeTurn : kFreeWay;
    joint.lower = -far;
    joint.upper = far;
    tree_.notes.push_back("joint " + joint.name + " has no range: it may " +
                          (turns ? "turn once" : "slide 1 m") + " to either side");
    return;
  }
  const std::vector<double> limits = range->numbers("range");
  if (limits.size() != 2 || limits[0] > limits[1]) {
    range->fail("attribute range must be two numbers, the lower one first", range->text("range"));
  }
  joint.lower = limits[0] * unit;
  joint.upper = limits[1] * unit;
}

TreeJoint MjcfReader::read_joint(const XmlElement& element, const std::string& name,
                                 const std::string& childclass) {
  const auto with_type = defaults_.saying("type", element, childclass);
  const std::string type = with_type ? with_type->text("type") : "hinge";
  if (type != "hinge" && type != "slide") {
    element.fail("joints of type " + type + " cannot be planned with; known are hinge and slide",
                 name);
  }
  TreeJoint joint{.name = name,
                  .type = type == "hinge" ? TreeJointType::revolute : TreeJointType::prismatic,
                  .axis = Vector3::UnitZ(),
                  .place = element.place()};
  if (const auto at = defaults_.saying("axis", element, childclass)) {
    const Vector3 axis = at->vector3("axis");
    if (!(axis.norm() > 1e-100)) at->fail("attribute axis must not be 0");
    joint.axis = axis.stableNormalized();
  }
  const auto positive = [&](const char* attribute) {
    const auto at = defaults_.saying(attribute, element, childclass);
    return at ? std::max(0.0, at->number(attribute)) : 0.0;
  };
  joint.friction = {.coulomb = positive("frictionloss"), .viscous = positive("damping")};
  joint.spring.stiffness = positive("stiffness");
  if (const auto at = defaults_.saying("springref", element, childclass)) {
    const bool slides = joint.type == TreeJointType::prismatic;
    joint.spring.rest = at->number("springref") * (slides ? 1.0 : defaults_.angle_unit());
  }
  read_range(element, childclass, joint);
  if (const auto at = defaults_.saying("ref", element, childclass)) {
    // The value in which the file shows the body.
    const double ref = at->number("ref");
    ref_[static_cast<int>(tree_.joints.size())] =
        ref * (joint.type == TreeJointType::prismatic ? 1.0 : defaults_.angle_unit());
    joint.X_LJ = joint.type == TreeJointType::prismatic
                     ? translation(-ref * joint.axis)
                     : Pose(Eigen::AngleAxisd(-ref * defaults_.angle_unit(), joint.axis));
  }
  return joint;
}

int MjcfReader::joint_called(const XmlElement& at, const std::string& attribute) const {
  const auto found = joint_of_.find(at.text(attribute));
  if (found == joint_of_.end()) at.fail("no joint of this name", at.text(attribute));
  return found->second;
}

int MjcfReader::body_called(const XmlElement& at, const std::string& attribute) const {
  const auto found = body_of_.find(at.text(attribute));
  if (found == body_of_.end()) at.fail("no body of this name", at.text(attribute));
  return found->second;
}

// joint1 = a + b joint2 + c joint2^2 + ..., each from its reference; without joint2 it stays where
// it is.
void MjcfReader::couple(const XmlElement& element) {
  TreeJoint& joint = tree_.joints[index(joint_called(element, "joint1"))];
  std::vector<double> poly = {0.0, 1.0};
  if (element.has("polycoef")) poly = element.numbers("polycoef");
  poly.resize(std::max<std::size_t>(poly.size(), 2), 0.0);
  const bool linear = std::all_of(poly.begin() + 2, poly.end(), [](double c) { return c == 0.0; });
  if (!element.has("joint2") || !linear || poly[1] == 0.0 || joint.mimic) {
    tree_.notes.push_back(element.place() +
                          ": a coupling that is not linear, or a second one, "
                          "is not read");
    return;
  }
  // It speaks of the ways from where the file shows the joints.
  const int leader = joint_called(element, "joint2");
  if (tree_.joints[index(leader)].type != joint.type) {
    tree_.notes.push_back(element.place() + ": joint " + joint.name + " follows " +
                          tree_.joints[index(leader)].name +
                          ", a joint of another type: left out, they move independently");
    return;
  }
  const auto ref = [&](int of) { return ref_.contains(of) ? ref_.at(of) : 0.0; };
  const double offset = poly[0] + ref(joint_called(element, "joint1")) - poly[1] * ref(leader);
  joint.mimic = Mimic{leader, poly[1], offset};
}

// The anchor is a point of body1, and of body2 where the file shows both.
void MjcfReader::read_loop(const XmlElement& element) {
  Loop loop{.a = body_called(element, "body1"),
            .b = element.has("body2") ? body_called(element, "body2") : 0,
            .p_A = element.vector3("anchor")};
  std::vector<double> shown(tree_.joints.size(), 0.0);
  for (const auto& [joint, value] : ref_) shown[index(joint)] = value;
  loop.p_B = link_in_root(tree_, loop.b, shown).inverse() *
             (link_in_root(tree_, loop.a, shown) * loop.p_A);
  loops_.push_back(loop);
}

// Joints that an actuator moves, by itself or through a tendon.
std::set<int> MjcfReader::driven_joints() const {
  std::set<int> driven;
  std::set<std::string> tendons;
  for (const XmlElement& actuators : root_.children("actuator")) {
    for (const XmlElement& actuator : actuators.children()) {
      if (actuator.has("joint")) driven.insert(joint_called(actuator, "joint"));
      tendons.insert(actuator.text_or("tendon", ""));
    }
  }
  for (const XmlElement& all : root_.children("tendon")) {
    for (const XmlElement& tendon : all.children("fixed")) {
      if (!tendons.contains(tendon.text_or("name", ""))) continue;
      for (const XmlElement& at : tendon.children("joint")) {
        driven.insert(joint_called(at, "joint"));
      }
    }
  }
  return driven;
}

void MjcfReader::read_couplings() {
  for (const XmlElement& equality : root_.children("equality")) {
    for (const XmlElement& element : equality.children()) {
      if (element.name() == "joint" && element.text_or("active", "true") != "false") {
        couple(element);
      } else if (element.name() == "connect" && element.has("anchor") &&
                 element.text_or("active", "true") != "false") {
        read_loop(element);
      } else if (element.name() != "joint") {
        tree_.notes.push_back(element.place() + ": closed loops are not read");
      }
    }
  }
}

// Joints on one tendon that a motor pulls: nothing says how they share its length, so they are
// taken to move alike.
void MjcfReader::read_tendons() {
  std::set<std::string> pulled;
  for (const XmlElement& actuators : root_.children("actuator")) {
    for (const XmlElement& actuator : actuators.children()) {
      if (actuator.has("tendon")) pulled.insert(actuator.text("tendon"));
    }
  }
  for (const XmlElement& tendons : root_.children("tendon")) {
    for (const XmlElement& tendon : tendons.children("fixed")) {
      const std::vector<XmlElement> joints = tendon.children("joint");
      if (!pulled.contains(tendon.text_or("name", "")) || joints.size() < 2) continue;
      const int leader = joint_called(joints.front(), "joint");
      if (tree_.joints[index(leader)].mimic) continue;
      for (const XmlElement& at : joints) {
        const int follower = joint_called(at, "joint");
        TreeJoint& joint = tree_.joints[index(follower)];
        if (follower == leader || joint.mimic || joint.type != tree_.joints[index(leader)].type) {
          continue;
        }
        joint.mimic = Mimic{leader, 1.0, 0.0};
        tree_.notes.push_back("joint " + joint.name + " shares a tendon with " +
                              tree_.joints[index(leader)].name + ": taken to move alike");
      }
    }
  }
}

void MjcfReader::read_exclusions() {
  for (const XmlElement& contact : root_.children("contact")) {
    for (const XmlElement& pair : contact.children("exclude")) {
      const auto a = body_called(pair, "body1");
      const auto b = body_called(pair, "body2");
      if (a != b) tree_.exempt_pairs.emplace_back(a, b);
    }
  }
}

void MjcfReader::read_efforts() {
  for (const XmlElement& actuators : root_.children("actuator")) {
    for (const XmlElement& actuator : actuators.children()) {
      if (!actuator.has("joint")) continue;
      TreeJoint& joint = tree_.joints[index(joint_called(actuator, "joint"))];
      const auto at = defaults_.saying("forcerange", actuator, "");
      if (!at) continue;
      const std::vector<double> range = at->numbers("forcerange");
      for (const double force : range)
        joint.max_effort = std::max(joint.max_effort, std::abs(force));
    }
  }
}

void MjcfReader::read_home() {
  for (const XmlElement& frames : root_.children("keyframe")) {
    for (const XmlElement& key : frames.children("key")) {
      if (key.text_or("name", "") != "home" || !key.has("qpos")) continue;
      const std::vector<double> values = key.numbers("qpos");
      if (values.size() != moving_.size()) {
        tree_.notes.push_back(key.place() + ": has values of more than the joints, is not read");
        continue;
      }
      for (std::size_t k = 0; k < values.size(); ++k) {
        TreeJoint& joint = tree_.joints[index(moving_[k])];
        if (values[k] >= joint.lower && values[k] <= joint.upper) joint.initial = values[k];
      }
      tree_.notes.push_back("starts in the keyframe home");
      return;
    }
  }
}

void MjcfReader::note_unread() {
  for (const std::string& remark : geometry_.remarks()) tree_.notes.push_back(remark);
  const std::set<std::string> read = {"compiler", "option",   "size",      "visual",  "statistic",
                                      "default",  "asset",    "worldbody", "contact", "equality",
                                      "tendon",   "actuator", "keyframe",  "sensor",  "custom"};
  for (const XmlElement& element : root_.children()) {
    if (!read.contains(element.name())) {
      tree_.notes.push_back(element.place() + ": is not read");
    }
  }
}

}  // namespace

JointTree read_mjcf(const XmlFile& file) {
  return has_mjcf_parts(file) ? MjcfReader(whole_mjcf(file)).read() : MjcfReader(file).read();
}

}  // namespace prehend
