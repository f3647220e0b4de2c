#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/robot/closed_form.h"
#include "sim/robot/files/joint_tree.h"
#include "sim/robot/sound_robot.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

// The edge of the cube that stands for a base without geometry [m].
constexpr double kBaseMark = 1e-3;
// Directions typed with few digits are still meant to be opposite [length of their sum].
constexpr double kOpposedFingers = 1e-6;
constexpr double kTimeToFullSpeed = 0.5;  // where no acceleration is said [s]
// Limits of a joint that leave less than this part of the range of the joint that it mimics are
// mistakes: multiplier and limits have different signs.
constexpr double kLeftToLeader = 0.1;

// Where a link is: the joint that moves it (-1: the base) and its pose in the frame after that.
struct LinkPlace {
  int joint = -1;
  Pose X_AL = Pose::Identity();
};

// Builds the robot chain by chain: each is followed from its first joint to where the path branches
// or ends.
class TreeRobot {
 public:
  explicit TreeRobot(const JointTree& tree)
      : tree_(tree),
        below_(joints_below(tree)),
        mimics_(resolved_mimics(tree)),
        place_(tree.links.size()),
        dof_of_(tree.joints.size(), -1) {}

  Robot build();

 private:
  // A joint that begins a chain.
  struct Start {
    int joint = -1;   // of the tree
    int parent = -1;  // of the robot
  };

  std::vector<int> gather(int link);
  void add_frame(const TreeLink& link, const LinkPlace& place);
  void follow(const Start& start);
  void add_joint(int joint, int parent);
  void add_dofs();
  void assume_accelerations();
  void set_linkages();
  void add_exempt_pairs();
  void mark_base();

  const JointTree& tree_;
  std::vector<std::vector<int>> below_;
  std::vector<Mimic> mimics_;
  std::vector<LinkPlace> place_;
  std::vector<int> dof_of_;        // of a joint of the tree that mimics none
  std::vector<int> joint_source_;  // of a joint of the robot: that of the tree
  std::vector<int> robot_link_ = std::vector<int>(tree_.links.size(), -1);
  std::vector<Start> starts_;  // to be followed, the next one last
  Robot robot_;
};

// What frames are for is said by their names alone: "flange" and "tool0" are those of
// ROS-Industrial arms; tool centre points are called tcp somehow.
FrameRole role_of(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (name == "flange" || name == "tool0") return FrameRole::flange;
  return name.find("tcp") != std::string::npos ? FrameRole::tool : FrameRole::none;
}

// Keeps the frame of a link where no link of the robot has it.
void TreeRobot::add_frame(const TreeLink& link, const LinkPlace& place) {
  if (!link.mesh.empty() && is_identity(place.X_AL)) return;
  robot_.frames.push_back({link.name, role_of(link.name), place.joint, place.X_AL});
}

// Places the links that fixed joints hold to `link`, which is placed, and adds those with triangles
// to the robot. Returns the joints that move something beyond them, in the order of the file.
std::vector<int> TreeRobot::gather(int link) {
  std::vector<int> moving;
  std::vector<int> todo = {link};
  while (!todo.empty()) {
    const int at = todo.back();
    todo.pop_back();
    const TreeLink& body = tree_.links[index(at)];
    const LinkPlace& place = place_[index(at)];
    add_frame(body, place);
    if (!body.mesh.empty()) {
      robot_link_[index(at)] = static_cast<int>(robot_.links.size());
      robot_.links.push_back({.name = body.name,
                              .material = body.material,
                              .joint = place.joint,
                              .mesh = transformed(body.mesh, place.X_AL),
                              .inertial = body.inertial.mass > 0.0
                                              ? transformed(body.inertial, place.X_AL)
                                              : Inertial{}});
    }
    const std::vector<int>& below = below_[index(at)];
    for (std::size_t k = below.size(); k-- > 0;) {
      const int joint = below[k];
      const TreeJoint& held = tree_.joints[index(joint)];
      if (held.type != TreeJointType::fixed) {
        moving.push_back(joint);
        continue;
      }
      place_[index(held.child)] = {place.joint, place.X_AL * held.X_LJ};
      todo.push_back(held.child);
    }
  }
  std::sort(moving.begin(), moving.end());
  return moving;
}

void TreeRobot::add_joint(int joint, int parent) {
  const TreeJoint& source = tree_.joints[index(joint)];
  const Mimic& mimic = mimics_[index(joint)];
  robot_.joints.push_back(
      {.name = source.name,
       .type = source.type == TreeJointType::prismatic ? JointType::prismatic : JointType::revolute,
       .X_PJ = place_[index(source.parent)].X_AL * source.X_LJ,
       .axis = source.axis,
       .lower = source.lower,
       .upper = source.upper,
       .ratio = mimic.ratio,
       .offset = mimic.offset,
       .parent = parent,
       .chain = static_cast<int>(robot_.chains.size()),
       .max_effort = source.max_effort,
       .friction = source.friction,
       .spring = source.spring});
  joint_source_.push_back(joint);
  place_[index(source.child)] = {static_cast<int>(robot_.joints.size()) - 1, Pose::Identity()};
}

void TreeRobot::follow(const Start& start) {
  Chain chain{.name = "", .first_joint = static_cast<int>(robot_.joints.size())};
  Start next = start;
  for (;;) {
    add_joint(next.joint, next.parent);
    const int child = tree_.joints[index(next.joint)].child;
    const int here = static_cast<int>(robot_.joints.size()) - 1;
    const std::vector<int> moving = gather(child);
    if (moving.size() == 1) {
      next = {moving.front(), here};
      continue;
    }
    for (std::size_t k = moving.size(); k-- > 0;) starts_.push_back({moving[k], here});
    chain.name = tree_.links[index(child)].name;
    break;
  }
  chain.joint_count = static_cast<int>(robot_.joints.size()) - chain.first_joint;
  chain.closed_form = closed_form_of(robot_, chain);
  robot_.chains.push_back(chain);
}

// Two fingers on one drive that slide in opposite directions on one body.
bool slides_apart(const Robot& robot, int dof) {
  std::vector<const Joint*> fingers;
  for (const Joint& joint : robot.joints) {
    if (joint.dof == dof) fingers.push_back(&joint);
  }
  if (fingers.size() != 2 || fingers[0]->parent != fingers[1]->parent) return false;
  const auto direction = [](const Joint& joint) {
    return Vector3(joint.ratio * (joint.X_PJ.linear() * joint.axis));
  };
  return fingers[0]->type == JointType::prismatic &&
         (direction(*fingers[0]) + direction(*fingers[1])).norm() < kOpposedFingers;
}

// Whether it turns joints behind several first joints of the robot: fingers.
bool turns_several(const Robot& robot, int dof) {
  std::set<int> first;
  for (int j = 0; j < static_cast<int>(robot.joints.size()); ++j) {
    const Joint& joint = robot.joints[index(j)];
    if (joint.dof != dof) continue;
    if (joint.type != JointType::revolute) return false;
    first.insert(joints_to(robot, j).front());
  }
  return first.size() > 1;
}

// The formats hardly ever say accelerations.
void TreeRobot::assume_accelerations() {
  bool assumed = false;
  for (DegreeOfFreedom& dof : robot_.dofs) {
    if (!(dof.max_velocity > 0.0) || dof.max_acceleration > 0.0) continue;
    dof.max_acceleration = dof.max_velocity / kTimeToFullSpeed;
    assumed = true;
  }
  if (!assumed) return;
  robot_.notes.push_back(formatted(
      "accelerations are not in the file: joints are taken to reach their velocities in %g s",
      kTimeToFullSpeed));
}

void TreeRobot::add_dofs() {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<double> initial;
  for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
    const int source = joint_source_[j];
    if (mimics_[index(source)].joint != source) continue;
    const TreeJoint& leader = tree_.joints[index(source)];
    dof_of_[index(source)] = static_cast<int>(robot_.dofs.size());
    initial.push_back(leader.initial.value_or(0.0));
    robot_.dofs.push_back({.name = leader.name,
                           .lower = -kInfinity,
                           .upper = kInfinity,
                           .max_velocity = leader.max_velocity,
                           .max_acceleration = leader.max_acceleration});
  }
  // Leaders come first: where their followers' limits leave next to nothing, these are widened.
  for (const bool leads : {true, false}) {
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
      Joint& joint = robot_.joints[j];
      const int leader = mimics_[index(joint_source_[j])].joint;
      if ((leader == joint_source_[j]) != leads) continue;
      joint.dof = dof_of_[index(leader)];
      if (joint.ratio == 0.0) continue;
      DegreeOfFreedom& dof = robot_.dofs[index(joint.dof)];
      const double from = (joint.lower - joint.offset) / joint.ratio;
      const double to = (joint.upper - joint.offset) / joint.ratio;
      // Nothing becomes -0.
      const double lower = std::max(dof.lower, std::min(from, to)) + 0.0;
      const double upper = std::min(dof.upper, std::max(from, to)) + 0.0;
      if (lower > upper || (!leads && upper - lower < kLeftToLeader * (dof.upper - dof.lower))) {
        const double low = joint.ratio * dof.lower + joint.offset;
        const double high = joint.ratio * dof.upper + joint.offset;
        joint.lower = std::min(low, high);
        joint.upper = std::max(low, high);
        robot_.notes.push_back("joint " + joint.name + ": its limits leave (nearly) no value to " +
                               dof.name + ", which it mimics; they are ignored");
        continue;
      }
      dof.lower = lower;
      dof.upper = upper;
    }
  }
  set_linkages();
  assume_accelerations();
  for (std::size_t d = 0; d < robot_.dofs.size(); ++d) {
    DegreeOfFreedom& dof = robot_.dofs[d];
    dof.initial = std::clamp(initial[d], dof.lower, dof.upper);
    if (turns_several(robot_, static_cast<int>(d))) {
      dof.coupling = Coupling::by_finger;
      robot_.notes.push_back("degree of freedom " + dof.name +
                             " bends several fingers: taken as coupled by finger, where one that "
                             "touches waits for the others");
    }
    if (!slides_apart(robot_, static_cast<int>(d))) continue;
    dof.coupling = Coupling::self_centering;
    robot_.notes.push_back("degree of freedom " + dof.name +
                           " moves two opposed fingers: taken as self-centering");
  }
}

void TreeRobot::set_linkages() {
  for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
    const Mimic& mimic = mimics_[index(joint_source_[j])];
    if (mimic.across < 0) continue;
    const auto found = std::find(joint_source_.begin(), joint_source_.end(), mimic.across);
    robot_.joints[j].across = static_cast<int>(found - joint_source_.begin());
    robot_.joints[j].ahead = mimic.ahead;
  }
}

void TreeRobot::add_exempt_pairs() {
  for (const auto& [a, b] : tree_.exempt_pairs) {
    const int first = robot_link_[index(a)];
    const int second = robot_link_[index(b)];
    if (first < 0 || second < 0 || first == second) continue;
    robot_.exempt_pairs.emplace_back(std::min(first, second), std::max(first, second));
  }
  std::sort(robot_.exempt_pairs.begin(), robot_.exempt_pairs.end());
  robot_.exempt_pairs.erase(std::unique(robot_.exempt_pairs.begin(), robot_.exempt_pairs.end()),
                            robot_.exempt_pairs.end());
}

// links[0] is the base link.
void TreeRobot::mark_base() {
  if (!robot_.links.empty()) return;
  robot_.links.push_back({.name = tree_.links[index(root_of(tree_))].name,
                          .material = "plastic",
                          .mesh = make_box(Vector3::Constant(kBaseMark))});
  robot_.frames.erase(robot_.frames.begin());  // of the root, which that link has now
  robot_.notes.push_back("link " + robot_.links.front().name +
                         ", the base, has no geometry: a cube of 1 mm stands for it");
}

Robot TreeRobot::build() {
  robot_.name = tree_.name;
  robot_.notes = tree_.notes;
  const std::vector<int> moving = gather(root_of(tree_));
  mark_base();
  for (std::size_t k = moving.size(); k-- > 0;) starts_.push_back({moving[k], -1});
  while (!starts_.empty()) {
    const Start start = starts_.back();
    starts_.pop_back();
    follow(start);
  }
  add_dofs();
  add_exempt_pairs();
  if (robot_.joints.empty()) {
    throw InputError({.file = tree_.file, .problem = "no joint moves", .value = tree_.name});
  }
  require_sound(robot_, tree_.file);
  return std::move(robot_);
}

}  // namespace

Robot to_robot(const JointTree& tree) { return TreeRobot(tree).build(); }

}  // namespace prehend
