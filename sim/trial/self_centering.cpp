#include "sim/trial/self_centering.h"

namespace prehend {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

std::vector<int> joints_of(const Robot& hand, int dof) {
  std::vector<int> joints;
  for (std::size_t j = 0; j < hand.joints.size(); ++j) {
    if (hand.joints[j].dof == dof) joints.push_back(static_cast<int>(j));
  }
  return joints;
}

// Direction in which the joint's finger moves for a growing value, in the hand's frame.
Vector3 slide_axis(const Robot& hand, int joint) {
  return hand.chains[index(hand.joints[index(joint)].chain)].X_BC.linear() * Vector3::UnitZ();
}

}  // namespace

bool center_hand(const CompiledScene& scene, Pose& X_OH, ClosedHand& closed) {
  const Robot& hand = scene.scene.hand;
  bool moved = false;
  for (std::size_t d = 0; d < hand.dofs.size(); ++d) {
    if (hand.dofs[d].coupling != Coupling::self_centering) continue;
    const std::vector<int> pair = joints_of(hand, static_cast<int>(d));
    const std::size_t a = index(pair[0]);
    const std::size_t b = index(pair[1]);
    if (!closed.stopped_by_contact[a] && !closed.stopped_by_contact[b]) continue;
    const double mean = 0.5 * (closed.joints[a] + closed.joints[b]);
    // Finger a stays put: what its joint gives up, the hand takes on.
    const Vector3 shift = (closed.joints[a] - mean) * slide_axis(hand, pair[0]);
    if (shift.isZero(0.0)) continue;
    X_OH = X_OH * translation(shift);
    closed.joints[a] = closed.joints[b] = mean;
    closed.dofs[d] = (mean - hand.joints[a].offset) / hand.joints[a].ratio;
    moved = true;
  }
  return moved;
}

}  // namespace prehend
