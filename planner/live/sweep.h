// Motions that end where two bodies would touch, of whatever moves.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

#include "sim/base/named_enum.h"
#include "sim/base/run_context.h"
#include "sim/scene/collision_body.h"
#include "sim/trial/trial_options.h"

namespace prehend {

// Why a motion ended.
enum class MotionEnd {
  arrived,              // nothing touches on the way
  touched,              // two bodies are so near that they count as touching
  starts_in_collision,  // bodies overlap where it starts: nothing was moved
};

// "arrived", "touched", "starts_in_collision": as in messages.
constexpr auto enum_names(MotionEnd /*of*/) {
  return std::to_array<std::string_view>({"arrived", "touched", "starts_in_collision"});
}

// Two bodies that may meet on the way, which is counted in shares of it, 0 .. 1. In a step of the
// share by s, each point of `b` moves relative to `a` by s * slide_A, what a turn about an axis
// adds that stands still in a's frame, and what joints add.
struct SweptPair {
  const CollisionBody* a = nullptr;
  const CollisionBody* b = nullptr;
  Vector3 slide_A = Vector3::Zero();  // of all the way, frame of a [m]
  // Along the axis, frame of a: the angle of all the way times the largest distance of a point of b
  // from the origin about which it turns [m].
  Vector3 turn_A = Vector3::Zero();
  double rest = 0.0;  // bound of what joints add on all the way, >= 0 [m]

  double speed() const { return slide_A.norm() + turn_A.norm() + rest; }
};

// The pose of the pair's b in the frame of its a at a share of the way.
using PoseOnTheWay = std::function<Pose(std::size_t pair, double share)>;

struct SweepEnd {
  MotionEnd end = MotionEnd::arrived;
  double share = 1.0;    // of the way that was gone
  std::size_t pair = 0;  // which touches or overlaps; nothing where it arrived
};

// Moves until the bodies of a pair come within contact_gap (at most 10 % more); they never
// penetrate, because no step is longer than what proven bounds of the gaps allow (conservative
// advancement, as approach.h does for straight motions). Bodies that are as near at the start may
// come closer, to half of their gap but not below a micrometre: what touches can move away and
// along. Bodies that slide along each other are kept apart by planes between their convex parts, of
// which only what moves towards the plane counts. Throws Cancelled.
SweepEnd sweep(const std::vector<SweptPair>& pairs, const PoseOnTheWay& pose,
               const TrialOptions& options, const RunContext& context = {});

// How a frame gets from one pose to another: its origin along a straight line, while it turns
// evenly about one axis through it.
struct StraightMotion {
  StraightMotion(const Pose& X_AB_from, const Pose& X_AB_to);

  Pose at(double share) const;

  Pose from;
  Pose to;
  Vector3 slide = Vector3::Zero();  // of the origin, frame A [m]
  Eigen::AngleAxisd turn;           // about the axis in B
};

}  // namespace prehend
