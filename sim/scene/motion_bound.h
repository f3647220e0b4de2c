// How far the links of an arm can move when its joints leave a posture.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/robot/robot.h"
#include "sim/scene/ids.h"

namespace prehend {

struct CompiledArm;
struct CompiledLink;

// Bounds of motions about a posture. CompiledLink::reach says how far a point of a link is from an
// axis at most, in any posture. In one posture it is often much closer: of a folded arm the hand
// swings about the first axis on a circle half as wide.
//
// Let the joints leave the posture one after the other, from the tip to the base. The turn of each
// is a rigid motion of all that is behind it. It keeps the distance by which a point has moved so
// far, and adds at most the turn times the point's distance from the axis in the posture.
//
// On a line in joint space the motions of the joints add up as vectors: to first order a point
// moves by the velocity that it has in the posture, and its acceleration is bounded by
// sum_i sum_j |d_i d_j| R_max(i,j), as the second derivative of a point by joints i <= j is
// a_i x (a_j x (p - o_j)); d: turns, a and o: axes, R: distances from them on the way.
class MotionBound {
 public:
  // The arm must live as long.
  explicit MotionBound(const CompiledArm& arm);

  // From now on about this posture, for motions in which each joint of the platform leaves it by at
  // most `turns` [rad or m]; `line`: for the straight line from -turns to +turns. Both must live
  // until the next call.
  enum class Motion { any, line };
  void set(const RobotPoses& poses, const std::vector<double>& turns, Motion motion);

  // By how much the gap of a pair can change [m]: the farthest that a point of each body moves,
  // relative to the joint that carries both, added.
  double farthest(const ArmPair& pair);

 private:
  double branch(const CompiledLink& link, std::size_t shared) const;

  struct Axis {  // in the frame after its joint
    Vector3 direction = Vector3::Zero();
    Vector3 point = Vector3::Zero();
  };

  const CompiledArm& arm_;
  std::vector<Axis> axes_;
  const RobotPoses* poses_ = nullptr;
  const std::vector<double>* turns_ = nullptr;
  Motion motion_ = Motion::any;
  std::vector<double> from_base_;  // of each link against the base; below 0: not computed yet
};

}  // namespace prehend
