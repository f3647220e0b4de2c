#include "sim/robot/one_finger.h"

#include <algorithm>

#include "sim/base/index.h"

namespace prehend {
namespace {

constexpr int kNone = -1;

// The joint nearest to the base that closes, among this one and those before it; kNone: none does.
int root_of(const Robot& hand, const std::vector<double>& closing, int joint) {
  int root = kNone;
  for (int j = joint; j >= 0; j = hand.joints[index(j)].parent) {
    if (closing[index(hand.joints[index(j)].dof)] != 0.0) root = j;
  }
  return root;
}

// The joint at which the only finger begins; kNone where there is none, or more than one.
int only_root(const Robot& hand, const std::vector<double>& closing) {
  int only = kNone;
  for (int j = 0; j < static_cast<int>(hand.joints.size()); ++j) {
    const int root = root_of(hand, closing, j);
    if (root == kNone || root == only) continue;
    if (only != kNone) return kNone;
    only = root;
  }
  return only;
}

}  // namespace

std::optional<Vector3> pushing_direction(const Robot& hand, const std::vector<double>& joints,
                                         const std::vector<double>& closing,
                                         const Vector3& approach) {
  const int root = only_root(hand, closing);
  const auto is_of_finger = [&](const Link& link) {
    return root_of(hand, closing, link.joint) == root;
  };
  if (root == kNone || std::all_of(hand.links.begin(), hand.links.end(), is_of_finger)) return {};
  std::vector<Pose> X_BJ;
  joint_poses(hand, joints, X_BJ);
  // The last link of the finger, whose motion all of its joints add to.
  const auto last = std::find_if(hand.links.rbegin(), hand.links.rend(), is_of_finger);
  if (last == hand.links.rend()) return {};
  const Vector3 p_B = X_BJ[index(last->joint)] * bounds(last->mesh).center();
  Vector3 velocity = Vector3::Zero();
  for (int j = last->joint; j >= 0; j = hand.joints[index(j)].parent) {
    const Joint& joint = hand.joints[index(j)];
    const Pose X_BP = joint.parent < 0 ? Pose::Identity() : X_BJ[index(joint.parent)];
    const Pose X_BJoint = X_BP * joint.X_PJ;
    const Vector3 turn = joint.ratio * closing[index(joint.dof)] * (X_BJoint.linear() * joint.axis);
    const bool is_sliding = joint.type == JointType::prismatic;
    velocity += is_sliding ? turn : Vector3(turn.cross(p_B - X_BJoint.translation()));
  }
  velocity -= velocity.dot(approach) * approach;
  const double speed = velocity.norm();
  return speed > 0.0 ? std::optional<Vector3>(velocity / speed) : std::nullopt;
}

std::optional<Vector3> pushing_direction(const Robot& hand) {
  if (!hand.hand) return {};
  std::vector<double> closing;
  for (const DegreeOfFreedom& dof : hand.dofs) closing.push_back(dof.closing_velocity);
  return pushing_direction(hand, joint_values(hand, initial_dofs(hand)), closing,
                           hand.hand->approach);
}

}  // namespace prehend
