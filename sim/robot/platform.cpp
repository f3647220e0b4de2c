#include "sim/robot/platform.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/robot/sound_robot.h"

namespace prehend {
namespace {

// Appends the joints, degrees of freedom, links and chains of one robot to those of the whole, with
// indices shifted accordingly. What stood on the robot's base is attached to the joint that carries
// it, moved by the pose of that base.
void append(const MountedRobot& mounted, const PlatformPart& part, Robot& whole) {
  const Robot& robot = mounted.robot;
  const auto named = [&](const std::string& name) { return mounted.name + "/" + name; };
  const int first_chain = static_cast<int>(whole.chains.size());
  const auto carried = [&](int joint) { return joint < 0 ? part.joint : part.first_joint + joint; };
  for (Chain chain : robot.chains) {
    chain.name = named(chain.name);
    chain.first_joint += part.first_joint;
    whole.chains.push_back(std::move(chain));
  }
  for (Joint joint : robot.joints) {
    joint.driver_name = driver_name(joint);
    joint.name = named(joint.name);
    if (joint.parent < 0) joint.X_PJ = part.X_JR * joint.X_PJ;
    joint.parent = carried(joint.parent);
    if (joint.across >= 0) joint.across = carried(joint.across);
    joint.dof += part.first_dof;
    joint.chain += first_chain;
    whole.joints.push_back(std::move(joint));
  }
  for (DegreeOfFreedom dof : robot.dofs) {
    dof.name = named(dof.name);
    whole.dofs.push_back(std::move(dof));
  }
  for (Link link : robot.links) {
    link.name = named(link.name);
    if (link.joint < 0) {
      link.mesh = transformed(link.mesh, part.X_JR);
      link.inertial = transformed(link.inertial, part.X_JR);
    }
    link.joint = carried(link.joint);
    whole.links.push_back(std::move(link));
  }
  for (RobotFrame frame : robot.frames) {
    frame.name = named(frame.name);
    if (frame.joint < 0) frame.X_AF = part.X_JR * frame.X_AF;
    frame.joint = carried(frame.joint);
    whole.frames.push_back(std::move(frame));
  }
  for (const auto& [a, b] : robot.exempt_pairs) {
    whole.exempt_pairs.emplace_back(part.first_link + a, part.first_link + b);
  }
  whole.notes.insert(whole.notes.end(), robot.notes.begin(), robot.notes.end());
}

// The pairs of links that the platform itself exempts.
void append_exempt_pairs(const Platform& platform, Robot& whole) {
  if (platform.exempt_pairs.empty()) return;
  std::map<std::string, int> link_of;
  for (std::size_t l = 0; l < whole.links.size(); ++l) {
    link_of.emplace(whole.links[l].name, static_cast<int>(l));
  }
  for (const auto& [first, second] : platform.exempt_pairs) {
    const auto a = link_of.find(first);
    const auto b = link_of.find(second);
    if (a == link_of.end() || b == link_of.end() || a == b) continue;
    whole.exempt_pairs.emplace_back(std::min(a->second, b->second), std::max(a->second, b->second));
  }
}

}  // namespace

AssembledPlatform assemble(const Platform& platform) {
  AssembledPlatform assembled;
  Robot& whole = assembled.robot;
  whole.name = platform.name;
  for (const MountedRobot& mounted : platform.robots) {
    require_sound(mounted.robot);
    PlatformPart part;
    part.X_JR = mounted.X_MR;
    if (mounted.parent >= 0) {
      const Chain& chain =
          platform.robots[index(mounted.parent)].robot.chains[index(mounted.chain)];
      part.joint = assembled.parts[index(mounted.parent)].first_joint + chain.first_joint +
                   chain.joint_count - 1;
    }
    if (mounted.mount) {
      Link mount = *mounted.mount;
      mount.name = mounted.name + "/" + mount.name;
      mount.joint = part.joint;
      whole.links.push_back(std::move(mount));
    }
    part.first_joint = static_cast<int>(whole.joints.size());
    part.first_dof = static_cast<int>(whole.dofs.size());
    part.first_link = static_cast<int>(whole.links.size());
    append(mounted, part, whole);
    assembled.parts.push_back(part);
  }
  append_exempt_pairs(platform, whole);
  return assembled;
}

std::vector<double> initial_dofs(const Platform& platform) {
  std::vector<double> values;
  for (const MountedRobot& mounted : platform.robots) {
    for (const double value : initial_dofs(mounted.robot)) values.push_back(value);
  }
  return values;
}

int hand_of(const Platform& platform) {
  int hand = -1;
  for (std::size_t r = 0; r < platform.robots.size(); ++r) {
    if (!platform.robots[r].robot.hand) continue;
    if (hand >= 0) throw InputError({platform.name, "robots", "has more than one hand"});
    hand = static_cast<int>(r);
  }
  if (hand < 0) throw InputError({platform.name, "robots", "none is a hand"});
  return hand;
}

}  // namespace prehend
