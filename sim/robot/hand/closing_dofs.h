// Which degrees of freedom close a hand, in which direction, and from where.
#pragma once

#include <vector>

#include "sim/robot/hand/fingers.h"

namespace prehend {

// One entry per degree of freedom of the robot.
struct ClosingDofs {
  // Signed, 0: it does not move when the hand closes [rad/s or m/s].
  std::vector<double> velocity;
  // The value of the open hand; the initial one of what does not close [rad or m].
  std::vector<double> open;
  bool stated = false;  // the velocities are the robot's own

  bool closes(std::size_t dof) const { return velocity[dof] != 0.0; }
};

// Those that the robot states where it has any that closes, else inferred (closing_signs.h).
// Inferred joints turn at 1 rad/s or slide at 0.05 m/s.
ClosingDofs find_closing_dofs(const Robot& robot, const HandParts& parts);

// What closes towards these limits: 1, -1 or 0 (does not close) per degree of freedom.
//
// A degree of freedom is open at the limit opposite to closing. Where a finger has several joints
// that bend it, or one that turns without end, the limit counts only up to 0.35 rad beyond the
// initial value, of all its joints together: fingers do not grasp from bent backwards.
ClosingDofs closing_towards(const Robot& robot, const HandParts& parts,
                            const std::vector<int>& signs);

// The joints that bend or slide a finger shut, tip last: those whose axes are within 45 degrees of
// that of its last one. What turns it sideways or about its length does not close it. `X_BJ` as
// from joint_poses.
std::vector<int> closing_joints(const Robot& robot, const Finger& finger,
                                const std::vector<Pose>& X_BJ);

// Values of the degrees of freedom `time` seconds [s] after the open hand began to close; what does
// not close is as in `from`.
std::vector<double> closed_for(const Robot& robot, const ClosingDofs& closing, double time,
                               const std::vector<double>& from);

// The direction of a joint's axis in the base frame; `X_BJ` as from joint_poses.
Vector3 axis_in_base(const Robot& robot, int joint, const std::vector<Pose>& X_BJ);

// Where a degree of freedom that closes ends: at its limit, or where a finger is bent shut that
// turns without end [rad or m].
double closed_value(const Robot& robot, const ClosingDofs& closing, std::size_t dof);

// When the last degree of freedom arrives at its limit [s].
double closing_time(const Robot& robot, const ClosingDofs& closing);

}  // namespace prehend
