#include "planner/plan/path/check_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "planner/plan/path/lift_object.h"
#include "planner/plan/path/second_check.h"
#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/base/require_settings.h"
#include "sim/motion/control/cubic_peaks.h"
#include "sim/motion/dynamic_grasp/scene_world.h"
#include "sim/scene/carried_object.h"

namespace prehend {
namespace {

// The planner proves its paths free of collision by bounds on distances and motions
// (motion_check.h). This check samples postures along the cubics between the samples and tests all
// triangles for intersection by another engine, without any such bound. It is not a proof: a
// collision between two postures that are less than PathCheckOptions::step apart can be missed.

// Excess over a limit that is taken for rounding: relative for velocities and accelerations, in rad
// or m for positions.
constexpr double kRounding = 1e-6;

// Joint values at the fraction `part` (0..1) of the time between samples i and i + 1, on the cubic
// Hermite polynomial of their positions and velocities. The four weights are the Hermite basis; the
// tangents are scaled by h because the basis is written for an interval of length 1.
std::vector<double> between(const Trajectory& path, std::size_t i, double part) {
  const double h = path.times[i + 1] - path.times[i];
  const double s = part;
  const double from = (1.0 + 2.0 * s) * (1.0 - s) * (1.0 - s);
  const double to = s * s * (3.0 - 2.0 * s);
  const double leave = s * (1.0 - s) * (1.0 - s) * h;
  const double arrive = s * s * (s - 1.0) * h;
  std::vector<double> joints(path.joints.size());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    joints[j] = from * path.positions[i][j] + to * path.positions[i + 1][j] +
                leave * path.velocities[i][j] + arrive * path.velocities[i + 1][j];
  }
  return joints;
}

// The corners of each link's bounding box, in the link's frame. A link lies in the convex hull of
// its corners, so no point of it moves farther from one pose to another than the farthest corner:
// the difference of two rigid motions is affine, and its norm is largest at a corner of the hull.
// This measures the motion with 8 points instead of all vertices.
std::vector<std::vector<Vector3>> box_corners(const CompiledArm& arm) {
  std::vector<std::vector<Vector3>> corners;
  for (const CompiledLink& link : arm.links) {
    const Bounds box = bounds(link.mesh.mesh());
    std::vector<Vector3> points;
    for (const double x : {box.lower.x(), box.upper.x()}) {
      for (const double y : {box.lower.y(), box.upper.y()}) {
        for (const double z : {box.lower.z(), box.upper.z()}) points.emplace_back(x, y, z);
      }
    }
    corners.push_back(std::move(points));
  }
  return corners;
}

class PathChecker {
 public:
  // `X_LO`: of an arm whose last link L is the object, which the hand holds: its frame in that
  // link's.
  PathChecker(const CompiledScene& scene, const CompiledArm& arm, const std::optional<Pose>& X_LO,
              const SecondCheck* bodies, const Trajectory& path, const PathCheckOptions& options,
              const RunContext& context)
      : arm_(arm),
        carries_(X_LO.has_value()),
        X_LO_(X_LO.value_or(Pose::Identity())),
        bodies_(bodies),
        path_(path),
        options_(options),
        context_(context),
        hand_joints_(scene.scene.hand.joints.size()),
        corners_(box_corners(arm_)) {
    find_pairs(*scene.arm);
  }

  // Looks at the samples `first` to `last`.
  PathCheck run(std::size_t first, std::size_t last) {
    check_limits(first, last);
    if (bodies_ == nullptr) return check_;
    // walk(i) tests the postures after sample i. The one before all of them is tested here.
    arm_link_poses(arm_, path_.positions[first], X_BL_);
    std::erase_if(touching_ = pairs_,
                  [&](const ArmPair& pair) { return !may_part(pair) || !meet(pair); });
    look(path_.positions[first], path_.times[first]);
    for (std::size_t i = first; i < last; ++i) walk(i);
    return check_;
  }

 private:
  // Limits are stated for degrees of freedom, the path has joint values. A joint moves `ratio`
  // times as fast as its degree of freedom, so its rates are divided by the ratio.
  void check_limits(std::size_t first, std::size_t last) {
    const Robot& robot = arm_.robot();
    for (std::size_t i = first; i <= last; ++i) {
      for (std::size_t j = 0; j < robot.joints.size(); ++j) {
        const Joint& joint = robot.joints[j];
        const DegreeOfFreedom& dof = robot.dofs[index(joint.dof)];
        const double value = path_.positions[i][j];
        check_.beyond_limits =
            std::max({check_.beyond_limits, joint.lower - value, value - joint.upper});
        // A scene may narrow the limits of a degree of freedom below those of its joints. Joints of
        // the hand are left out: when a finger is stopped, the joints of one degree of freedom
        // no longer follow from a common value.
        if (!is_in_hand(j)) {
          const double dof_value = (value - joint.offset) / joint.ratio;
          check_.beyond_limits =
              std::max({check_.beyond_limits, dof.lower - dof_value, dof_value - dof.upper});
        }
        if (i > first) check_rates(i, j, dof, std::abs(joint.ratio));
      }
    }
  }

  // Velocity and acceleration of a joint on the cubic that ends at sample i.
  void check_rates(std::size_t i, std::size_t j, const DegreeOfFreedom& dof, double ratio) {
    const double before = path_.positions[i - 1][j];
    const double here = path_.positions[i][j];
    const double seconds = path_.times[i] - path_.times[i - 1];
    CubicPeaks peaks =
        cubic_peaks(here - before, path_.velocities[i - 1][j], path_.velocities[i][j], seconds);
    // Positions are rounded. Over a short time that makes an acceleration of its own.
    const double rounding =
        std::numeric_limits<double>::epsilon() * (std::abs(before) + std::abs(here)) / seconds;
    peaks.velocity -= 2.0 * rounding;
    peaks.acceleration -= 6.0 * rounding / seconds;
    // Joints at rest are skipped: their limits may be missing (0), which would give 0 / 0.
    if (peaks.velocity > 0.0) {
      check_.velocity = std::max(check_.velocity, peaks.velocity / ratio / dof.max_velocity);
    }
    if (peaks.acceleration > 0.0) {
      check_.acceleration =
          std::max(check_.acceleration, peaks.acceleration / ratio / dof.max_acceleration);
    }
  }

  bool is_in_hand(std::size_t joint) const {
    const auto first = index(arm_.hand_part().first_joint);
    return joint >= first && joint < first + hand_joints_;
  }

  // Tests the postures after sample i up to and including sample i + 1. The number of steps is
  // doubled until the longest of them is short enough: how far a link moves in a step is known only
  // once its poses are computed. 4096 steps (8 m between samples at the default step) is a guard
  // against paths whose samples are absurdly far apart.
  void walk(std::size_t i) {
    int steps = 1;
    while (steps < 4096 && longest_step(i, steps) > options_.step) steps *= 2;
    for (int k = 1; k <= steps; ++k) {
      const double part = static_cast<double>(k) / steps;
      look(between(path_, i, part), path_.times[i] + part * (path_.times[i + 1] - path_.times[i]));
    }
  }

  // The farthest that any corner of any link moves [m] in one of `steps` equal steps of time.
  double longest_step(std::size_t i, int steps) {
    double longest = 0.0;
    std::vector<Pose> before;
    std::vector<Pose> after;
    arm_link_poses(arm_, between(path_, i, 0.0), before);
    for (int k = 1; k <= steps; ++k) {
      context_.cancellation.check();
      arm_link_poses(arm_, between(path_, i, static_cast<double>(k) / steps), after);
      for (std::size_t l = 0; l < corners_.size(); ++l) {
        for (const Vector3& p : corners_[l]) {
          longest = std::max(longest, (after[l] * p - before[l] * p).norm());
        }
      }
      before.swap(after);
    }
    return longest;
  }

  // Tests one posture and records the result; the description is kept of the first collision only.
  void look(const std::vector<double>& joints, double time) {
    context_.cancellation.check();
    ++check_.postures;
    arm_link_poses(arm_, joints, X_BL_);
    const std::string met = what_meets();
    if (met.empty()) return;
    if (++check_.collisions > 1) return;
    check_.first_collision = met + formatted(" at %.3f s", time);
  }

  // Whether the bodies may touch where the path begins, until they part: a held object lies on
  // something, and the fingers of a closed hand touch each other.
  bool may_part(const ArmPair& pair) const {
    const LinkId* other = std::get_if<LinkId>(&pair.other);
    return carries_ ||
           (other != nullptr && arm_.is_hand_link(pair.link) && arm_.is_hand_link(*other));
  }

  // All pairs of the scene's arm `arm`, and with the object in the hand those of the object.
  void find_pairs(const CompiledArm& arm) {
    for (const LinkPair& pair : collision_pairs(arm.links, arm.robot())) {
      pairs_.push_back({.link = pair.a, .other = pair.b});
    }
    for (std::size_t l = 0; l < arm_.links.size(); ++l) {
      for (std::size_t b = carries_ ? 1 : 0; b < arm_.bodies.size(); ++b) {
        // Neither moves; the start was checked when the scene was compiled.
        if (arm_.links[l].joints.empty() && b > 0) continue;
        pairs_.push_back({.link = link_id(l), .other = BodyId::at(b)});
      }
      if (!carries_ || arm_.is_hand_link(link_id(l))) continue;
      if (arm_.robot().links[l].joint == arm_.hand_part().joint) continue;
      pairs_.push_back({.link = carried_object(arm_), .other = link_id(l)});
    }
  }

  // "LINK meets BODY" for the first collision in the current posture, empty if there is none.
  std::string what_meets() {
    for (const ArmPair& pair : pairs_) {
      const bool touches = meet(pair);
      const auto touching =
          std::find_if(touching_.begin(), touching_.end(), [&](const ArmPair& other) {
            return other.link == pair.link && other.other == pair.other;
          });
      if (touching != touching_.end()) {
        if (!touches) touching_.erase(touching);
      } else if (touches) {
        return first_name(arm_, pair) + " meets " + second_name(arm_, pair);
      }
    }
    return "";
  }

  // Whether the surfaces intersect.
  bool meet(const ArmPair& pair) const {
    const Pose& X_BL = X_BL_[index(pair.link)];
    const LinkId* link = std::get_if<LinkId>(&pair.other);
    const BodyId* body = std::get_if<BodyId>(&pair.other);
    if (carries_ && pair.link == carried_object(arm_)) {
      const Pose X_BO = X_BL * X_LO_;
      return link != nullptr ? bodies_->object_crosses(X_BO, *link, X_BL_[index(*link)])
                             : bodies_->object_crosses(X_BO, *body, arm_.body(*body).X_RB);
    }
    return link != nullptr ? bodies_->links_cross(pair.link, X_BL, *link, X_BL_[index(*link)])
                           : bodies_->body_crosses(*body, arm_.body(*body).X_RB, pair.link, X_BL);
  }

  const CompiledArm& arm_;
  const bool carries_;
  const Pose X_LO_;
  const SecondCheck* bodies_;  // null: collisions are not looked for
  const Trajectory& path_;
  const PathCheckOptions& options_;
  const RunContext& context_;
  const std::size_t hand_joints_;
  const std::vector<std::vector<Vector3>> corners_;
  std::vector<ArmPair> pairs_;
  std::vector<ArmPair> touching_;  // since the first sample
  std::vector<Pose> X_BL_;
  PathCheck check_;
};

// The hand's base in the object's frame, in a posture in which the object is still in its place.
Pose hand_pose(const CompiledArm& arm, const std::vector<double>& joints) {
  std::vector<Pose> X_BJ;
  joint_poses(arm.robot(), joints, X_BJ);
  const PlatformPart& hand = arm.hand_part();
  const Pose X_BJh = hand.joint < 0 ? Pose::Identity() : X_BJ[index(hand.joint)];
  return arm.X_BO.inverse() * X_BJh * hand.X_JR;
}

}  // namespace

bool PathCheck::ok() const {
  return collisions == 0 && velocity <= 1.0 + kRounding && acceleration <= 1.0 + kRounding &&
         beyond_limits <= kRounding;
}

namespace {

PathCheck checked(const CompiledScene& scene, const SecondCheck* bodies, const Trajectory& path,
                  const PathCheckOptions& options, const RunContext& context) {
  require_settings(options);
  const CompiledArm& arm = *scene.arm;
  const std::size_t last = path.times.size() - 1;
  const auto lift = std::find_if(path.segments.begin(), path.segments.end(),
                                 [](const auto& segment) { return segment.name == kLift; });
  const std::size_t held = lift == path.segments.end() ? last : index(lift->first);
  PathCheck check =
      PathChecker(scene, arm, std::nullopt, bodies, path, options, context).run(0, held);
  if (held == last) return check;
  const Pose X_OH = hand_pose(arm, path.positions[held]);
  const CompiledArm carrying = arm_with_object(scene, X_OH);
  const Pose X_LO = arm.hand_part().X_JR * X_OH.inverse();
  const PathCheck then =
      PathChecker(scene, carrying, X_LO, bodies, path, options, context).run(held, last);
  check.postures += then.postures;
  if (check.collisions == 0) check.first_collision = then.first_collision;
  check.collisions += then.collisions;
  check.velocity = std::max(check.velocity, then.velocity);
  check.acceleration = std::max(check.acceleration, then.acceleration);
  check.beyond_limits = std::max(check.beyond_limits, then.beyond_limits);
  return check;
}

}  // namespace

PathCheck check_path(const CompiledScene& scene, const Trajectory& path,
                     const PathCheckOptions& options, const RunContext& context) {
  if (!options.collisions) return checked(scene, nullptr, path, options, context);
  return check_path(scene, SecondCheck(*scene.arm), path, options, context);
}

PathCheck check_path(const CompiledScene& scene, const SecondCheck& bodies, const Trajectory& path,
                     const PathCheckOptions& options, const RunContext& context) {
  return checked(scene, options.collisions ? &bodies : nullptr, path, options, context);
}

}  // namespace prehend
