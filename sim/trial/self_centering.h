// Hands whose two fingers share one drive and slide toward each other.
#pragma once

#include <vector>

#include "sim/scene/compiled_scene.h"
#include "sim/trial/close_hand.h"

namespace prehend {

// The two joints of a self-centering degree of freedom.
struct FingerPair {
  int dof = 0;
  int first = 0;
  int second = 0;
  Vector3 opening_H =
      Vector3::UnitX();  // unit: the first finger moves this way for a growing value
};
FingerPair finger_pair(const Robot& hand, int dof);

// For each self-centering degree of freedom of which a joint was stopped by contact: the hand
// moves sideways by half the difference of the two joints (or, as well, the object by as much the
// other way), the fingers stay where they touch, and both joints get their mean. `X_OH` and
// `closed` are changed. Returns whether the hand moved.
bool center_hand(const CompiledScene& scene, Pose& X_OH, ClosedHand& closed);

}  // namespace prehend
