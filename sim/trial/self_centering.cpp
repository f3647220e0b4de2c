#include "sim/trial/self_centering.h"

#include "sim/base/index.h"

// A self-centering drive has one degree of freedom for two fingers, whose joint values are equal in
// every posture that the drive allows. close_hand stops each finger where it touches, which leaves
// them unequal. The two are made equal here: the fingers stay where they touch the object, and the
// palm moves along the opening axis until both joints have their mean value.
namespace prehend {

FingerPair finger_pair(const Robot& hand, int dof) {
  const auto next = [&](std::size_t j) {
    while (hand.joints[j].dof != dof) ++j;
    return j;
  };
  const std::size_t first = next(0);
  return {dof, static_cast<int>(first), static_cast<int>(next(first + 1))};
}

Vector3 opening_axis(const Robot& hand, const FingerPair& fingers,
                     const std::vector<double>& joints) {
  const Joint& finger = hand.joints[index(fingers.first)];
  const Vector3 axis = finger.X_PJ.linear() * finger.axis;
  // The axis is fixed in the frame of the link that carries the finger; for a finger on the palm
  // that is the base.
  if (finger.parent < 0) return axis;
  return joint_pose(hand, finger.parent, joints).linear() * axis;
}

bool center_hand(const CompiledScene& scene, Pose& X_OH, ClosedHand& closed) {
  const Robot& hand = scene.scene.hand;
  bool moved = false;
  for (std::size_t d = 0; d < hand.dofs.size(); ++d) {
    if (hand.dofs[d].coupling != Coupling::self_centering) continue;
    const FingerPair fingers = finger_pair(hand, static_cast<int>(d));
    const std::size_t a = index(fingers.first);
    const std::size_t b = index(fingers.second);
    if (!closed.stopped_by_contact[a] && !closed.stopped_by_contact[b]) continue;
    const double mean = 0.5 * (closed.joints[a] + closed.joints[b]);
    // Both fingers stay where they are in the object's frame: the hand moves along the axis by what
    // finger a's joint loses. Finger b slides the opposite way, so its joint gains as much.
    const Vector3 shift = (closed.joints[a] - mean) * opening_axis(hand, fingers, closed.joints);
    if (shift.isZero(0.0)) continue;
    X_OH = X_OH * translation(shift);
    closed.joints[a] = closed.joints[b] = mean;
    closed.dofs[d] = (mean - hand.joints[a].offset) / hand.joints[a].ratio;
    moved = true;
  }
  return moved;
}

}  // namespace prehend
