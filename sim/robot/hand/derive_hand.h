// What planning needs of a hand (Hand, closing velocities), derived from its joints and its shape
// where it is not stated (docs/reference/derived-hands.md).
#pragma once

#include <optional>

#include "sim/robot/robot.h"

namespace prehend {

// What is stated of a hand; the rest is derived.
struct StatedHand {
  std::optional<Vector3> approach;  // as in Hand
  std::optional<Vector3> closing;
  std::optional<Vector3> origin;
};

// The robot with a hand: with closing velocities where it states none, with pairs of links exempt
// that collide in every posture, and with approach, closing axis, grasp origin and preshapes. A
// note says each. All preshapes are free of self-collision. The same robot gives the same hand; a
// robot that was turned or moved as a whole gives the hand turned and moved with it.
// Throws InputError "ROBOT: hand: ..." that says why nothing of it could grasp.
Robot with_derived_hand(Robot robot, const StatedHand& stated = {});

// The robot as it is where it states a hand with preshapes, else with_derived_hand; what it states
// of the hand stays.
Robot with_hand(Robot robot);

}  // namespace prehend
