#include "planner/show/exports/end_effector.h"

#include <set>

#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/scene/scene.h"

namespace prehend {
namespace {

// A frame with that role on the hand's base.
std::optional<HandFrame> frame_of(const Robot& hand, FrameRole role) {
  const RobotFrame* frame = frame_with(hand, role);
  if (frame == nullptr || frame->joint >= 0) return std::nullopt;
  return HandFrame{frame->name, frame->X_AF};
}

// The frame after a joint, called like a link that has it.
std::string link_after(const Robot& robot, int joint) {
  for (const Link& link : robot.links) {
    if (link.joint == joint) return link.name;
  }
  return robot.joints[index(joint)].name;
}

// The frame of the arm that carries the hand: its flange, else that of its last link.
HandFrame frame_of_arm(const Carrier& carrier) {
  const MountedRobot& mounted = carrier.platform.robots[index(carrier.hand)];
  const Robot& arm = carrier.platform.robots[index(mounted.parent)].robot;
  const Chain& chain = arm.chains[index(mounted.chain)];
  const int last = chain.first_joint + chain.joint_count - 1;
  const Pose X_HA = mounted.X_MR.inverse();
  for (const RobotFrame& frame : arm.frames) {
    if (frame.role == FrameRole::flange && frame.joint == last) {
      return {frame.name, X_HA * frame.X_AF};
    }
  }
  return {link_after(arm, last), X_HA};
}

}  // namespace

EndEffector end_effector(const Scene& scene) {
  const Robot& hand = scene.hand;
  // The base link is the first.
  const HandFrame itself{hand.links[0].name, Pose::Identity()};
  EndEffector frames;
  frames.base = frame_of(hand, FrameRole::base).value_or(itself);
  frames.tool = frame_of(hand, FrameRole::tool);
  frames.parent = scene.carrier ? frame_of_arm(*scene.carrier)
                                : frame_of(hand, FrameRole::flange).value_or(frames.base);
  return frames;
}

std::vector<std::string> driver_names(const Robot& platform) {
  std::vector<std::string> names;
  std::vector<std::string> own;
  for (const Joint& joint : platform.joints) {
    names.push_back(driver_name(joint));
    own.push_back(joint.name);
  }
  const std::set<std::string> different(names.begin(), names.end());
  return different.size() == names.size() ? names : own;
}

std::string frames_text(const EndEffector& frames, const HandFrame& reference) {
  std::string text = "Poses are those of the frame " + reference.name + ". In it, in m, x y z and" +
                     " the quaternion x y z w:";
  const auto add = [&](const char* what, const HandFrame& frame) {
    const Pose X = reference.X_HF.inverse() * frame.X_HF;
    const Vector3 p = X.translation();
    const Eigen::Quaterniond q = quaternion_of(X);
    text += formatted("\n  %s %s: %.9g %.9g %.9g, %.9g %.9g %.9g %.9g", what, frame.name.c_str(),
                      p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w());
  };
  add("base of the hand,", frames.base);
  add("carried by", frames.parent);
  if (frames.tool) add("tool centre point,", *frames.tool);
  return text;
}

}  // namespace prehend
