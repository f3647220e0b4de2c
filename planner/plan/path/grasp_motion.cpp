#include "planner/plan/path/grasp_motion.h"

#include <algorithm>
#include <utility>

#include "planner/plan/path/closing_path.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/reach/reach.h"
#include "sim/trial/approach_line.h"
#include "sim/trial/candidate.h"
#include "sim/trial/trial.h"

namespace prehend {
namespace {

// Of the hand on the way to the object, where no path says how fast [m/s].
constexpr double kApproachSpeed = 0.1;

// Arm and hand with the platform's joints at `arm_joints`. The hand's base is found by forward
// kinematics: frame of the joint that carries the hand, then the fixed pose from there to the hand.
MotionFrame frame_of(const CompiledScene& scene, double time, std::vector<double> arm_joints) {
  const CompiledArm& arm = *scene.arm;
  const PlatformPart& part = arm.hand_part();
  std::vector<Pose> X_BJ;
  joint_poses(arm.robot(), arm_joints, X_BJ);
  const Pose X_BJh = part.joint < 0 ? Pose::Identity() : X_BJ[static_cast<std::size_t>(part.joint)];
  MotionFrame frame{time, arm.X_BO.inverse() * X_BJh * part.X_JR, {}, std::move(arm_joints)};
  const auto first = frame.arm_joints.begin() + part.first_joint;
  frame.joints.assign(first, first + static_cast<std::ptrdiff_t>(scene.scene.hand.joints.size()));
  return frame;
}

// The samples of a planned path, one frame each. Segments keep their indices.
GraspMotion motion_along(const CompiledScene& scene, const Trajectory& path) {
  GraspMotion motion;
  for (std::size_t i = 0; i < path.times.size(); ++i) {
    motion.frames.push_back(frame_of(scene, path.times[i], path.positions[i]));
  }
  motion.segments = path.segments;
  const std::size_t grasp = motion.grasp();
  const Pose X_HC = motion.frames[grasp].X_OH.inverse();
  for (std::size_t i = grasp + 1; i < motion.frames.size(); ++i) {
    motion.frames[i].X_OC = motion.frames[i].X_OH * X_HC;
  }
  return motion;
}

}  // namespace

std::size_t GraspMotion::grasp() const {
  for (const TrajectorySegment& segment : segments) {
    if (segment.name == "close") return static_cast<std::size_t>(segment.last);
  }
  return frames.size() - 1;
}

// Without a path there are two segments. Approach: with an arm one frame for each posture of
// trial.arm_line, which follows the hand's line in steps of equal length, so that equal times
// between them are a constant speed; without an arm its start only, since the hand's motion to the
// grasp is linear and frames are interpolated. Close: the stops of closing_path. The frame in which
// the approach ends is the first of the closing, so the approach adds all postures but its last.
GraspMotion grasp_motion(const CompiledScene& scene, const Candidate& candidate, const Trial& trial,
                         const Trajectory* path) {
  if (path != nullptr && scene.arm) return motion_along(scene, *path);
  const HandLine line = approach_line(scene, candidate, trial);
  const std::vector<DofValues> no_arm;
  const std::vector<DofValues>& arm_line = scene.arm ? trial.arm_line : no_arm;
  GraspMotion motion;
  const auto add = [&](double time, const Pose& X_OH, const std::vector<double>& joints,
                       const DofValues* dofs) {
    motion.frames.push_back(dofs != nullptr
                                ? frame_of(scene, time, arm_joints(*scene.arm, *dofs, joints))
                                : MotionFrame{time, X_OH, joints});
  };
  // A single posture does not say how the arm came to it, so there is no approach to show.
  const double seconds = arm_line.size() == 1 ? 0.0 : trial.travel / kApproachSpeed;
  const std::size_t postures = arm_line.empty() ? 2 : arm_line.size();
  if (seconds > 0.0) {
    for (std::size_t i = 0; i + 1 < postures; ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(postures - 1);
      // Without postures of an arm there is only i = 0, the pre-grasp. With them the pose of the
      // hand follows from forward kinematics, and X_OH_from is not used.
      add(part * seconds, line.X_OH_from, line.hand_joints,
          arm_line.empty() ? nullptr : &arm_line[i]);
    }
  }
  const int closes = static_cast<int>(motion.frames.size());
  const DofValues* held = arm_line.empty() ? nullptr : &arm_line.back();
  // An object that gave way moves while the hand closes; between its two poses, evenly.
  const Eigen::Quaterniond turned(trial.X_OC.value_or(Pose::Identity()).linear());
  const ClosingPath closing = closing_path(scene.scene.hand, line.hand_joints, trial.joints);
  for (std::size_t i = 0; i < closing.times.size(); ++i) {
    add(seconds + closing.times[i], line.X_OH_to, closing.postures[i], held);
    if (!trial.X_OC) continue;
    const double part = closing.times.back() > 0.0 ? closing.times[i] / closing.times.back() : 1.0;
    motion.frames.back().X_OC =
        pose_from(Eigen::Quaterniond::Identity().slerp(part, turned).toRotationMatrix(),
                  part * trial.X_OC->translation());
  }
  motion.is_simulated = trial.X_OC.has_value();
  motion.segments = {{"approach", 0, closes},
                     {"close", closes, static_cast<int>(motion.frames.size()) - 1}};
  return motion;
}

// Every step-th frame of each segment, counted from its first. The last index of a segment is
// clamped, so that its end is always kept and the next segment starts at the same frame.
GraspMotion thinned(const GraspMotion& motion, int most) {
  const auto count = static_cast<int>(motion.frames.size());
  const int step = std::max(1, (count + most - 1) / most);
  GraspMotion few;
  few.is_simulated = motion.is_simulated;
  for (const TrajectorySegment& segment : motion.segments) {
    if (few.frames.empty())
      few.frames.push_back(motion.frames[static_cast<std::size_t>(segment.first)]);
    const int first = static_cast<int>(few.frames.size()) - 1;
    for (int i = segment.first + step; i < segment.last + step && segment.last > segment.first;
         i += step) {
      few.frames.push_back(motion.frames[static_cast<std::size_t>(std::min(i, segment.last))]);
    }
    few.segments.push_back({segment.name, first, static_cast<int>(few.frames.size()) - 1});
  }
  return few;
}

}  // namespace prehend
