// Hands with two fingers that one drive slides towards each other, so that they centre what they
// hold.
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
};
FingerPair finger_pair(const Robot& hand, int dof);

// Unit, in the hand's base frame: the direction in which the first finger slides when its joint
// value grows. It depends on the joints where the fingers stand on a part of the hand that moves.
Vector3 opening_axis(const Robot& hand, const FingerPair& fingers,
                     const std::vector<double>& joints);

// The drive makes both joints equal, but close_hand has stopped each finger where it touched. So
// for each self-centering degree of freedom with a joint stopped by contact, the hand moves
// sideways by half the difference of the two joints (which is the same as the object moving the
// other way): the fingers stay where they touch, and both joints get their mean. Changes `X_OH` and
// `closed`. Returns whether the hand moved.
bool center_hand(const CompiledScene& scene, Pose& X_OH, ClosedHand& closed);

}  // namespace prehend
