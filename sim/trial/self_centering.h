// Hands with two opposed sliding fingers on one drive (parallel jaw grippers), which centre the
// object between them.
#pragma once

#include <vector>

#include "sim/scene/compiled_scene.h"
#include "sim/trial/close_hand.h"

namespace prehend {

// The two joints of a self-centering degree of freedom, as indices into Robot::dofs and
// Robot::joints.
struct FingerPair {
  int dof = 0;
  int first = 0;
  int second = 0;
};

// The fingers of `dof`, which must be self-centering and drive two joints.
FingerPair finger_pair(const Robot& hand, int dof);

// The direction in which the first finger slides when its joint value grows: unit, in the hand's
// base frame. It depends on `joints` where the fingers stand on a link that itself moves.
Vector3 opening_axis(const Robot& hand, const FingerPair& fingers,
                     const std::vector<double>& joints);

// Moves the hand so that both joints of each self-centering drive are equal, as the drive forces
// them to be. close_hand stops each finger where it touches, which leaves their joints unequal.
// Where contact stopped one of them, the hand moves sideways by half the difference of the two
// joints (relative to the object, which may be what moves in reality); the fingers stay where they
// touch, and both joints get their mean. Changes `X_OH` and `closed`. Returns whether the hand
// moved.
bool center_hand(const CompiledScene& scene, Pose& X_OH, ClosedHand& closed);

}  // namespace prehend
