// Hands with one finger that closes onto a part which does not move.
#pragma once

#include <optional>
#include <vector>

#include "sim/robot/robot.h"

namespace prehend {

// What such a hand keeps from an object that it slides along to its fixed jaw [m]. Without room,
// proofs that it meets nothing on the way would be of tiny steps.
inline constexpr double kSlidingRoom = 2e-3;

// The direction, orthogonal to the unit vector `approach`, in which the only finger of a hand
// pushes what is before it as it closes, at these joint values [rad or m]; base frame, unit.
// `closing`: the velocity of each degree of freedom as the hand closes [rad/s or m/s]. Nothing for
// hands with several fingers, or without a link that stands still.
std::optional<Vector3> pushing_direction(const Robot& hand, const std::vector<double>& joints,
                                         const std::vector<double>& closing,
                                         const Vector3& approach);

// The same of a hand that states how it closes and approaches, at its initial posture.
std::optional<Vector3> pushing_direction(const Robot& hand);

}  // namespace prehend
