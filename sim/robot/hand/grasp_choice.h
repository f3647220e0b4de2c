// Which of several ways to oppose and to face a body holds most, found by closing on test bodies.
#pragma once

#include "sim/robot/hand/measure_preshape.h"
#include "sim/robot/hand/test_bodies.h"

namespace prehend {

// How a hand opens and faces what it grasps.
struct GraspChoice {
  Opposition opposition;
  HandAxes axes;
};

// The hand of these axes, as PreshapeMeasure takes it: its closing axis points from the thumb to
// the others.
Hand measured_hand(const Robot& robot, const HandParts& parts, const Opposition& opposition,
                   const HandAxes& axes);

// The opposition and axes of tips that meet (best_opposition, find_hand_axes), or another one
// (good_oppositions, other_approaches) that holds test bodies clearly better. What is stated is
// kept. Fingers that only slide leave no choice.
GraspChoice choose_grasp(const Robot& robot, const HandParts& parts, const ClosingDofs& closing,
                         const Opposition& best, const StatedHand& stated,
                         const SelfCollision& collision);

}  // namespace prehend
