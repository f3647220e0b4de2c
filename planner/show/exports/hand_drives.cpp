#include "planner/show/exports/hand_drives.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "sim/base/index.h"

namespace prehend {
namespace {

// Effort of a drive whose effort the robot file does not state.
constexpr double kForce = 20.0;  // of prismatic joints [N]
constexpr double kTorque = 1.0;  // of revolute joints [N m]

// The joint next to the base among those that carry this one.
int first_joint_of(const Robot& hand, int joint) {
  while (hand.joints[index(joint)].parent >= 0) joint = hand.joints[index(joint)].parent;
  return joint;
}

bool moves_as_one(Coupling coupling) {
  return coupling == Coupling::rigid || coupling == Coupling::self_centering;
}

double effort_without(const Robot& hand, int joint) {
  double effort = 0.0;
  for (const Joint& other : hand.joints) {
    if (other.dof == hand.joints[index(joint)].dof) effort = std::max(effort, other.max_effort);
  }
  if (effort > 0.0) return effort;
  return hand.joints[index(joint)].type == JointType::prismatic ? kForce : kTorque;
}

const Clutch* clutch_of(const std::vector<Clutch>& clutches, int joint) {
  const auto found = std::find_if(clutches.begin(), clutches.end(), [&](const Clutch& clutch) {
    return clutch.joints == std::vector<int>{joint};
  });
  return found == clutches.end() ? nullptr : &*found;
}

bool has_clutches(const Robot& hand, int dof, const std::vector<Clutch>& clutches) {
  return hand.dofs[index(dof)].coupling == Coupling::breakaway &&
         std::any_of(clutches.begin(), clutches.end(),
                     [&](const Clutch& clutch) { return clutch.dof == dof; });
}

// The joints of a degree of freedom that breaks away. What its joints bear in all is what its drive
// makes, at the joint that leads the others.
void add_breakaway(const Robot& hand, const std::vector<int>& joints,
                   const std::vector<Clutch>& clutches, HandDrives& found) {
  const int leader = *std::find_if(joints.begin(), joints.end(), [&](int joint) {
    return clutch_of(clutches, joint) == nullptr;
  });
  const Joint& leads = hand.joints[index(leader)];
  double effort = 0.0;
  for (const int joint : joints) {
    const Joint& at = hand.joints[index(joint)];
    effort += std::abs(at.ratio) * at.max_effort;
    if (joint == leader) continue;
    const HandCoupling coupling{joint, leader, at.ratio / leads.ratio};
    if (const Clutch* clutch = clutch_of(clutches, joint)) {
      // What the joint falls behind is its slip or, where the leader goes ahead by that, more.
      const double behind =
          leads.across == joint ? at.ratio * (leads.ratio + at.ratio) / leads.ratio : at.ratio;
      found.clutches.push_back({coupling, clutch->effort / std::abs(behind)});
    } else {
      found.couplings.push_back(coupling);
    }
  }
  const double velocity = hand.dofs[index(leads.dof)].closing_velocity;
  // A drive that passes a joint turns what is behind both, by the sum of their angles.
  const double passed = leads.across < 0 ? 0.0 : hand.joints[index(leads.across)].ratio;
  const double ratio = leads.ratio + passed;
  effort = effort > 0.0 ? effort / std::abs(ratio) : effort_without(hand, leader);
  found.drives.push_back({leader, effort, std::copysign(effort, velocity * ratio)});
  if (leads.across >= 0)
    found.drives.push_back({leads.across, effort, std::copysign(effort, velocity * ratio)});
}

}  // namespace

HandDrives hand_drives(const Robot& hand, const std::vector<Clutch>& clutches) {
  std::map<std::pair<int, int>, std::vector<int>> sets;  // by degree of freedom and finger
  for (std::size_t j = 0; j < hand.joints.size(); ++j) {
    const int dof = hand.joints[j].dof;
    const int joint = static_cast<int>(j);
    const bool one =
        moves_as_one(hand.dofs[index(dof)].coupling) || has_clutches(hand, dof, clutches);
    sets[{dof, one ? -1 : first_joint_of(hand, joint)}].push_back(joint);
  }
  HandDrives found;
  for (const auto& [key, joints] : sets) {
    if (has_clutches(hand, key.first, clutches)) {
      add_breakaway(hand, joints, clutches, found);
      continue;
    }
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
      const double effort = stated(joint) ? at.max_effort : effort_without(hand, joint);
      const double way = speed * at.ratio;
      found.drives.push_back({joint, effort, way > 0.0 ? effort : way < 0.0 ? -effort : 0.0});
    }
  }
  const auto by_joint = [](const auto& a, const auto& b) { return a.joint < b.joint; };
  std::sort(found.drives.begin(), found.drives.end(), by_joint);
  std::sort(found.couplings.begin(), found.couplings.end(), by_joint);
  std::sort(found.clutches.begin(), found.clutches.end(),
            [](const auto& a, const auto& b) { return a.follows.joint < b.follows.joint; });
  return found;
}

}  // namespace prehend
