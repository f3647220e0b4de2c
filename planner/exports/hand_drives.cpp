#include "planner/exports/hand_drives.h"

#include <algorithm>
#include <map>
#include <utility>

#include "sim/base/index.h"

namespace prehend {
namespace {

// The joint next to the base among those that carry this one.
int first_joint_of(const Robot& hand, int joint) {
  while (hand.joints[index(joint)].parent >= 0) joint = hand.joints[index(joint)].parent;
  return joint;
}

bool moves_as_one(Coupling coupling) {
  return coupling == Coupling::rigid || coupling == Coupling::self_centering;
}

double effort_without(const Robot& hand, int joint, const HandDriveOptions& options) {
  double effort = 0.0;
  for (const Joint& other : hand.joints) {
    if (other.dof == hand.joints[index(joint)].dof) effort = std::max(effort, other.max_effort);
  }
  if (effort > 0.0) return effort;
  return hand.joints[index(joint)].type == JointType::prismatic ? options.force : options.torque;
}

}  // namespace

HandDrives hand_drives(const Robot& hand, const HandDriveOptions& options) {
  std::map<std::pair<int, int>, std::vector<int>> sets;  // by degree of freedom and finger
  for (std::size_t j = 0; j < hand.joints.size(); ++j) {
    const int dof = hand.joints[j].dof;
    const int joint = static_cast<int>(j);
    const bool one = moves_as_one(hand.dofs[index(dof)].coupling);
    sets[{dof, one ? -1 : first_joint_of(hand, joint)}].push_back(joint);
  }
  HandDrives found;
  for (const auto& [key, joints] : sets) {
    const auto stated = [&](int joint) { return hand.joints[index(joint)].max_effort > 0.0; };
    const auto first = std::find_if(joints.begin(), joints.end(), stated);
    const int leader = first == joints.end() ? joints.front() : *first;
    const double speed = hand.dofs[index(key.first)].closing_velocity;
    for (const int joint : joints) {
      const Joint& at = hand.joints[index(joint)];
      if (joint != leader) {
        found.couplings.push_back({joint, leader, at.ratio / hand.joints[index(leader)].ratio});
      }
      if (joint != leader && !stated(joint)) continue;
      const double effort = stated(joint) ? at.max_effort : effort_without(hand, joint, options);
      const double way = speed * at.ratio;
      found.drives.push_back({joint, effort, way > 0.0 ? effort : way < 0.0 ? -effort : 0.0});
    }
  }
  const auto by_joint = [](const auto& a, const auto& b) { return a.joint < b.joint; };
  std::sort(found.drives.begin(), found.drives.end(), by_joint);
  std::sort(found.couplings.begin(), found.couplings.end(), by_joint);
  return found;
}

}  // namespace prehend
