#include "planner/plan/path/blend_transfer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "planner/plan/path/motion_lines.h"
#include "sim/base/index.h"
#include "sim/motion/control/joint_curve.h"
#include "sim/scene/compiled_arm.h"
#include "sim/scene/reach/motion_check.h"

namespace prehend {
namespace {

// A blend that is blocked is halved as often as this; then the motion stops at the corner.
constexpr int kHalvings = 6;
// A blend that is blocked when it is timed is halved down to this.
constexpr double kLeastBlend = 0.01;
// Rounds of timing and proving, in each of which the corners that are blocked get smaller blends.
constexpr int kRounds = 12;
// Straight pieces that a blend is looked at as, before the timed motion is proven free. Only for
// finding out which blend is worth timing.
constexpr int kPieces = 16;
// Short paths lead close around obstacles, and a blend inside of the corner would touch them. So
// corners are also tried farther out, by these multiples of what the blend cuts off: with 1 the
// curve passes about where the corner was.
constexpr std::array<double, 4> kOutward = {0.0, 1.0, 2.0, 4.0};

// A corner of the path that is timed: where it is, and how far it is rounded off.
struct Corner {
  std::vector<double> joints;
  double blend = 0.0;
};

class TransferBlender {
 public:
  TransferBlender(const CompiledArm& arm, JointPath waypoints, const JointLimits& limits,
                  const TransferOptions& options, const RunContext& context)
      : arm_(arm),
        waypoints_(std::move(waypoints)),
        limits_(limits),
        options_(options),
        context_(context),
        pairs_(arm.arm_pairs) {
    pairs_.insert(pairs_.end(), arm.hand_pairs.begin(), arm.hand_pairs.end());
  }

  TimedPath run(const TimePathOptions& timing) {
    for (const std::vector<double>& q : waypoints_) corners_.push_back({q});
    for (std::size_t i = 1; i + 1 < corners_.size(); ++i) round_off(i);
    for (int round = 0; round < kRounds; ++round) {
      const bool stops = std::all_of(corners_.begin(), corners_.end(),
                                     [](const Corner& c) { return c.blend == 0.0; });
      if (stops) break;
      TimedPath path = timed(timing);
      if (!shrink_blocked(path)) return path;
    }
    return time_path(waypoints_, PathKind::corners, limits_, timing);
  }

 private:
  // Finds the largest blend of corner i that is allowed and seems free.
  void round_off(std::size_t i) {
    const std::vector<double>& from = corners_[i - 1].joints;
    const std::vector<double>& to = waypoints_[i + 1];
    if (waypoints_[i] == from || waypoints_[i] == to) return;
    // The distance of the curve from its corner grows in proportion to the blend.
    const double most = deviation({from, waypoints_[i], to});
    double blend = most > options_.corner_deviation ? options_.corner_deviation / most : 1.0;
    for (int halving = 0; halving < kHalvings && blend > 0.0; ++halving) {
      for (const double outward : kOutward) {
        const JointPath corner = {from, moved_out(from, i, to, blend, outward), to};
        if (corner[1].empty() || !seems_free(corner, blend)) continue;
        corners_[i] = {corner[1], blend};
        return;
      }
      blend *= 0.5;
    }
  }

  // Corner i, farther out by a multiple of what the blend cuts off; empty outside of limits.
  std::vector<double> moved_out(const std::vector<double>& from, std::size_t i,
                                const std::vector<double>& to, double blend, double outward) const {
    std::vector<double> joints = waypoints_[i];
    if (outward == 0.0) return joints;
    const std::vector<double> cut = pieces({from, joints, to}, blend)[kPieces / 2];
    const Robot& robot = arm_.robot();
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const double way = outward * (joints[j] - cut[j]);
      if (way == 0.0) continue;
      joints[j] += way;
      const Joint& joint = robot.joints[j];
      const DegreeOfFreedom& dof = robot.dofs[index(joint.dof)];
      const double value = (joints[j] - joint.offset) / joint.ratio;
      if (value < dof.lower || value > dof.upper) return {};
      if (joints[j] < joint.lower || joints[j] > joint.upper) return {};
    }
    return joints;
  }

  // Whether both lines of the corner and its blend are free, as straight pieces.
  bool seems_free(const JointPath& corner, double blend) const {
    JointPath path = pieces(corner, blend);
    path.insert(path.begin(), corner.front());
    path.push_back(corner.back());
    return !first_blocked(arm_, pairs_, path, options_.motion, context_);
  }

  // Points of the blend of the corner.
  JointPath pieces(const JointPath& corner, double blend) const {
    const JointCurve curve = blended_curve(corner, {blend}, limits_);
    // The shorter line may be all blend; the corner's knot is the one where half of the length that
    // is blended lies on either side.
    const std::vector<double>& knots = curve.curve.knots();
    const double line = limits_length(corner[0], corner[1]);
    const double half = 0.5 * blend * std::min(line, limits_length(corner[1], corner[2]));
    JointPath path;
    for (int k = 0; k <= kPieces; ++k) {
      const double s = line - half + 2.0 * half * k / kPieces;
      path.push_back(at(curve, std::clamp(s, knots.front(), knots.back())));
    }
    return path;
  }

  // Length of a line as JointCurve measures it.
  double limits_length(const std::vector<double>& from, const std::vector<double>& to) const {
    double length = 0.0;
    for (std::size_t j = 0; j < from.size(); ++j) {
      if (from[j] != to[j]) length = std::hypot(length, (to[j] - from[j]) / limits_.velocity[j]);
    }
    return length;
  }

  static std::vector<double> at(const JointCurve& curve, double s) {
    const std::vector<double> offset = curve.curve.at(s).q;
    std::vector<double> joints = curve.start;
    for (std::size_t m = 0; m < offset.size(); ++m) joints[curve.moving[m]] += offset[m];
    return joints;
  }

  // At least as far as any point of the robot is from where it is at the corner, when the largest
  // blend passes it [m].
  double deviation(const JointPath& corner) const {
    const JointPath path = pieces(corner, 1.0);
    double farthest = 0.0;
    for (const CompiledLink& link : arm_.links) {
      double moved = 0.0;
      for (std::size_t k = 0; k < link.joints.size(); ++k) {
        const std::size_t j = index(link.joints[k]);
        moved += link.reach[k] * std::abs(path[kPieces / 2][j] - corner[1][j]);
      }
      farthest = std::max(farthest, moved);
    }
    return farthest;
  }

  TimedPath timed(const TimePathOptions& timing) const {
    JointPath waypoints;
    std::vector<double> blends;
    for (const Corner& corner : corners_) {
      waypoints.push_back(corner.joints);
      blends.push_back(corner.blend);
    }
    blends.erase(blends.begin());
    blends.pop_back();
    return time_blended(waypoints, blends, limits_, timing);
  }

  // Proves the motion around each corner free; where that fails, the corner gets half the blend, or
  // none. Whether there was one.
  bool shrink_blocked(const TimedPath& path) {
    bool blocked = false;
    std::size_t first = 0;
    for (std::size_t i = 1; i + 1 < corners_.size(); ++i) {
      // The motion is divided at the middles of lines, which blends leave alone.
      const bool is_last = i + 2 == corners_.size();
      const std::size_t last = is_last ? path.positions.size() - 1 : nearest(path, first, i);
      if (!is_free(path, first, last)) {
        blocked = true;
        Corner& corner = corners_[i];
        corner.blend = corner.blend > kLeastBlend ? 0.5 * corner.blend : 0.0;
        if (corner.blend == 0.0) corner.joints = waypoints_[i];
      }
      first = last;
    }
    return blocked;
  }

  // The sample, from `first` on, that is nearest to the middle of the line behind corner i.
  std::size_t nearest(const TimedPath& path, std::size_t first, std::size_t i) const {
    std::vector<double> middle = corners_[i].joints;
    for (std::size_t j = 0; j < middle.size(); ++j) {
      middle[j] += 0.5 * (corners_[i + 1].joints[j] - middle[j]);
    }
    std::size_t best = first;
    double least = limits_length(path.positions[first], middle);
    for (std::size_t k = first + 1; k < path.positions.size(); ++k) {
      const double length = limits_length(path.positions[k], middle);
      if (length < least) {
        least = length;
        best = k;
      }
    }
    return best;
  }

  // Proves the motion from sample `first` to sample `last`, between the samples too.
  bool is_free(const TimedPath& path, std::size_t first, std::size_t last) const {
    const MotionLines motion = motion_lines(path, first, last);
    return !first_blocked(arm_, pairs_, motion.lines, motion.sway, options_.motion, context_);
  }

  const CompiledArm& arm_;
  const JointPath waypoints_;
  const JointLimits& limits_;
  const TransferOptions& options_;
  const RunContext& context_;
  std::vector<ArmPair> pairs_;
  std::vector<Corner> corners_;  // the waypoints, moved out and with their blends
};

}  // namespace

JointLimits joint_limits(const Robot& robot) {
  JointLimits limits;
  for (const Joint& joint : robot.joints) {
    const DegreeOfFreedom& dof = robot.dofs[index(joint.dof)];
    limits.velocity.push_back(std::abs(joint.ratio) * dof.max_velocity);
    limits.acceleration.push_back(std::abs(joint.ratio) * dof.max_acceleration);
  }
  return limits;
}

TimedPath blend_transfer(const CompiledArm& arm, const std::vector<DofValues>& waypoints,
                         const std::vector<double>& hand_joints, const JointLimits& limits,
                         const TransferOptions& options, const TimePathOptions& timing,
                         const RunContext& context) {
  JointPath path;
  for (const DofValues& dofs : waypoints) path.push_back(arm_joints(arm, dofs, hand_joints));
  return TransferBlender(arm, std::move(path), limits, options, context).run(timing);
}

}  // namespace prehend
