#include "sim/robot/files/hand_split.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "sim/base/index.h"

namespace prehend {
namespace {

// `link` and the links below it.
std::vector<bool> below_and_itself(const JointTree& tree, int link) {
  const std::vector<std::vector<int>> below = joints_below(tree);
  std::vector<bool> inside(tree.links.size(), false);
  std::vector<int> todo = {link};
  while (!todo.empty()) {
    const int at = todo.back();
    todo.pop_back();
    inside[index(at)] = true;
    for (const int joint : below[index(at)]) todo.push_back(tree.joints[index(joint)].child);
  }
  return inside;
}

// Where a link is: on the frame after a joint (-1: the root's), at a pose that fixed joints give.
struct RigidPlace {
  int joint = -1;
  Pose X_AL = Pose::Identity();
};

RigidPlace rigid_place(const JointTree& tree, int link) {
  const std::vector<int> carried_by = carriers_of(tree);
  RigidPlace place;
  for (int joint = carried_by[index(link)]; joint >= 0;) {
    const TreeJoint& held = tree.joints[index(joint)];
    if (held.type != TreeJointType::fixed) {
      place.joint = joint;
      break;
    }
    place.X_AL = held.X_LJ * place.X_AL;
    joint = carried_by[index(held.parent)];
  }
  return place;
}

// Joints that move something and hang on the rigid piece of `link`.
std::vector<int> moving_joints(const JointTree& tree, const std::vector<std::vector<int>>& below,
                               int link) {
  std::vector<int> moving;
  std::vector<int> todo = {link};
  while (!todo.empty()) {
    const int at = todo.back();
    todo.pop_back();
    for (const int joint : below[index(at)]) {
      if (tree.joints[index(joint)].type == TreeJointType::fixed) {
        todo.push_back(tree.joints[index(joint)].child);
      } else {
        moving.push_back(joint);
      }
    }
  }
  return moving;
}

// The part of the tree whose links are `kept`, with the joints between them.
JointTree part_of(const JointTree& tree, const std::vector<bool>& kept) {
  JointTree part{.file = tree.file, .name = tree.name};
  std::vector<int> link_in_part(tree.links.size(), -1);
  for (std::size_t l = 0; l < tree.links.size(); ++l) {
    if (!kept[l]) continue;
    link_in_part[l] = static_cast<int>(part.links.size());
    part.links.push_back(tree.links[l]);
  }
  std::vector<int> joint_in_part(tree.joints.size(), -1);
  for (std::size_t j = 0; j < tree.joints.size(); ++j) {
    TreeJoint joint = tree.joints[j];
    joint.parent = link_in_part[index(joint.parent)];
    joint.child = link_in_part[index(joint.child)];
    if (joint.parent < 0 || joint.child < 0) continue;
    joint_in_part[j] = static_cast<int>(part.joints.size());
    part.joints.push_back(std::move(joint));
  }
  for (TreeJoint& joint : part.joints) {
    if (joint.mimic) joint.mimic->joint = joint_in_part[index(joint.mimic->joint)];
  }
  for (const auto& [a, b] : tree.exempt_pairs) {
    if (!kept[index(a)] || !kept[index(b)]) continue;
    part.exempt_pairs.emplace_back(link_in_part[index(a)], link_in_part[index(b)]);
  }
  return part;
}

int chain_ending_at(const Robot& robot, const std::string& joint) {
  for (std::size_t c = 0; c < robot.chains.size(); ++c) {
    const Chain& chain = robot.chains[c];
    const int last = chain.first_joint + chain.joint_count - 1;
    if (robot.joints[index(last)].name == joint) return static_cast<int>(c);
  }
  assert(false);
  return 0;
}

// The frame of the arm that the hand is fixed to is the flange.
void mark_flange(const std::string& name, int joint, const Pose& X_AF, Robot& arm) {
  for (RobotFrame& frame : arm.frames) {
    if (frame.role == FrameRole::flange) frame.role = FrameRole::none;
  }
  const auto found = std::find_if(arm.frames.begin(), arm.frames.end(),
                                  [&](const RobotFrame& frame) { return frame.name == name; });
  if (found != arm.frames.end()) {
    found->role = FrameRole::flange;
  } else {
    arm.frames.push_back({name, FrameRole::flange, joint, X_AF});
  }
}

// The joints of both parts are still those of one file.
void keep_names(Robot& robot) {
  for (Joint& joint : robot.joints) joint.driver_name = joint.name;
}

}  // namespace

int carrier_of_all(const JointTree& tree, const std::vector<int>& links) {
  const std::vector<int> carried_by = carriers_of(tree);
  const auto path_to = [&](int link) {
    std::vector<int> path = {link};
    for (int joint = carried_by[index(link)]; joint >= 0;) {
      path.push_back(tree.joints[index(joint)].parent);
      joint = carried_by[index(path.back())];
    }
    std::reverse(path.begin(), path.end());
    return path;
  };
  std::vector<int> common = path_to(links.front());
  for (const int link : links) {
    const std::vector<int> path = path_to(link);
    const auto differ = std::mismatch(common.begin(), common.end(), path.begin(), path.end());
    common.erase(differ.first, common.end());
  }
  return common.back();
}

std::optional<int> inferred_hand(const JointTree& tree) {
  const std::vector<std::vector<int>> below = joints_below(tree);
  int link = root_of(tree);
  for (int joints = 0;; ++joints) {
    const std::vector<int> moving = moving_joints(tree, below, link);
    if (moving.empty()) return std::nullopt;
    if (moving.size() == 1) {
      link = tree.joints[index(moving.front())].child;
      continue;
    }
    if (joints < kFewestArmJoints) return std::nullopt;
    std::vector<int> carriers_of_fingers;
    for (const int joint : moving) carriers_of_fingers.push_back(tree.joints[index(joint)].parent);
    const int hand = carrier_of_all(tree, carriers_of_fingers);
    return can_be_parted(tree, hand) ? std::optional(hand) : std::nullopt;
  }
}

bool can_be_parted(const JointTree& tree, int hand) {
  const RigidPlace place = rigid_place(tree, hand);
  if (place.joint < 0) return false;
  const std::vector<bool> in_hand = below_and_itself(tree, hand);
  bool moves = false;
  for (const TreeJoint& joint : tree.joints) {
    const bool inside = in_hand[index(joint.parent)];
    if (inside && joint.type != TreeJointType::fixed) moves = true;
    if (!joint.mimic) continue;
    if (inside != in_hand[index(tree.joints[index(joint.mimic->joint)].parent)]) return false;
  }
  const int carried = tree.joints[index(place.joint)].child;
  for (const int joint : moving_joints(tree, joints_below(tree), carried)) {
    if (!in_hand[index(tree.joints[index(joint)].parent)]) return false;
  }
  return moves;
}

Platform parted(const JointTree& tree, int hand) {
  assert(can_be_parted(tree, hand));
  const RigidPlace place = rigid_place(tree, hand);
  const std::vector<bool> in_hand = below_and_itself(tree, hand);
  JointTree of_hand = part_of(tree, in_hand);
  of_hand.name = tree.name + " " + tree.links[index(hand)].name;
  of_hand.notes = tree.notes;
  // The arm keeps the link as a frame, which its last joint may need.
  std::vector<bool> in_arm = in_hand;
  in_arm.flip();
  in_arm[index(hand)] = true;
  JointTree frames = tree;
  frames.links[index(hand)].mesh = {};
  frames.links[index(hand)].inertial = {};
  JointTree of_arm = part_of(frames, in_arm);

  Platform platform;
  platform.name = tree.name;
  platform.robots.push_back({.name = "arm", .robot = to_robot(of_arm)});
  platform.robots.push_back({.name = "hand",
                             .robot = to_robot(of_hand),
                             .parent = 0,
                             .chain = chain_ending_at(platform.robots.front().robot,
                                                      tree.joints[index(place.joint)].name),
                             .X_MR = place.X_AL});
  Robot& arm = platform.robots.front().robot;
  const TreeJoint& holding = tree.joints[index(carriers_of(tree)[index(hand)])];
  if (holding.type == TreeJointType::fixed) {
    const Chain& chain = arm.chains[index(platform.robots.back().chain)];
    mark_flange(tree.links[index(holding.parent)].name, chain.first_joint + chain.joint_count - 1,
                rigid_place(tree, holding.parent).X_AL, arm);
  }
  for (MountedRobot& mounted : platform.robots) keep_names(mounted.robot);
  for (const auto& [a, b] : tree.exempt_pairs) {
    if (in_hand[index(a)] == in_hand[index(b)]) continue;
    const auto [first, second] = in_hand[index(a)] ? std::pair(b, a) : std::pair(a, b);
    platform.exempt_pairs.emplace_back("arm/" + tree.links[index(first)].name,
                                       "hand/" + tree.links[index(second)].name);
  }
  return platform;
}

}  // namespace prehend
