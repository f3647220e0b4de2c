#include "planner/plan/path/check_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "planner/plan/path/lift_object.h"
#include "planner/plan/path/path_collisions.h"
#include "planner/plan/path/second_check.h"
#include "sim/base/index.h"
#include "sim/base/require_settings.h"
#include "sim/motion/control/cubic_peaks.h"
#include "sim/motion/dynamic_grasp/scene_world.h"
#include "sim/scene/carried_object.h"

namespace prehend {
namespace {

// Excess over a limit that is taken for rounding: relative for velocities and accelerations, in rad
// or m for positions.
constexpr double kRounding = 1e-6;

// Looks at the limits of joints along the samples of a path.
class LimitCheck {
 public:
  LimitCheck(const CompiledScene& scene, const Trajectory& path)
      : arm_(*scene.arm), path_(path), hand_joints_(scene.scene.hand.joints.size()) {}

  // Along the samples `first` to `last`: fills in `velocity`, `acceleration` and `beyond_limits`.
  //
  // Limits are stated for degrees of freedom, the path has joint values. A joint moves `ratio`
  // times as fast as its degree of freedom, so its rates are divided by the ratio.
  PathCheck run(std::size_t first, std::size_t last) {
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
    return check_;
  }

 private:
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

  const CompiledArm& arm_;
  const Trajectory& path_;
  const std::size_t hand_joints_;
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

// Adds the collisions of a part of the path.
void add(const PathCheck& part, PathCheck& check) {
  check.postures += part.postures;
  if (check.collisions == 0) check.first_collision = part.first_collision;
  check.collisions += part.collisions;
}

}  // namespace

bool PathCheck::ok() const {
  return collisions == 0 && velocity <= 1.0 + kRounding && acceleration <= 1.0 + kRounding &&
         beyond_limits <= kRounding;
}

PathCheck check_path(const CompiledScene& scene, const Trajectory& path,
                     const PathCheckOptions& options, const RunContext& context) {
  return check_path(scene, SecondCheck(*scene.arm), path, 0, options, context);
}

PathCheck check_path(const CompiledScene& scene, const SecondCheck& bodies, const Trajectory& path,
                     std::size_t first, const PathCheckOptions& options,
                     const RunContext& context) {
  require_settings(options);
  const std::size_t last = path.times.size() - 1;
  PathCheck check = LimitCheck(scene, path).run(first, last);
  if (!options.collisions) return check;
  const CompiledArm& arm = *scene.arm;
  const auto lift = std::find_if(path.segments.begin(), path.segments.end(),
                                 [](const auto& segment) { return segment.name == kLift; });
  const std::size_t held = lift == path.segments.end() ? last : index(lift->first);
  if (first < held || held == last) {
    add(PathCollisions(arm, arm, std::nullopt, bodies, path, options, context).run(first, held),
        check);
  }
  if (held == last) return check;
  const Pose X_OH = hand_pose(arm, path.positions[held]);
  const CompiledArm carrying = arm_with_object(scene, X_OH);
  const Pose X_LO = arm.hand_part().X_JR * X_OH.inverse();
  add(PathCollisions(arm, carrying, X_LO, bodies, path, options, context)
          .run(std::max(first, held), last),
      check);
  return check;
}

}  // namespace prehend
