#include "planner/plan/together/shared_paths.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "planner/plan/path/blend_transfer.h"
#include "planner/plan/together/posed_links.h"
#include "sim/base/index.h"
#include "sim/scene/carried_object.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/reach/motion_check.h"

namespace prehend {
namespace {

// Bodies of the two robots are at least this far apart where one begins to move [m].
constexpr double kApartAtStart = 1e-3;

// The path of one arm with the other standing still; none where that is in its way at the start.
std::optional<Trajectory> reach_among(const SharedHold& hold, const std::vector<PosedLink>& other,
                                      const std::string& robot, GraspPathOptions options,
                                      const RunContext& context) {
  if (!are_apart(links_at_start(hold.scene), other, kApartAtStart)) return std::nullopt;
  Scene scene = hold.scene.scene;
  add_obstacles(other, robot, scene);
  options.lift.height = 0.0;
  const CompiledScene among = compile(std::move(scene), context);
  auto path = plan_grasp_path(among, hold.grasp.candidate, hold.grasp.trial, options, context);
  if (!path) return std::nullopt;
  return std::move(path->motion);
}

// The values of the degrees of freedom that move the hand's base, of joints where they stand.
DofValues dofs_of(const CompiledArm& arm, const std::vector<double>& joints) {
  DofValues dofs = arm.start;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = arm.robot().joints[j];
    if (std::find(arm.dofs.begin(), arm.dofs.end(), joint.dof) == arm.dofs.end()) continue;
    dofs[index(joint.dof)] = (joints[j] - joint.offset) / joint.ratio;
  }
  return dofs;
}

Trajectory part_of(const TimedPath& path, std::size_t first,
                   const std::vector<std::string>& joints) {
  Trajectory part;
  part.joints = joints;
  part.times = path.times;
  const auto begin = static_cast<std::ptrdiff_t>(first);
  const auto end = begin + std::ssize(joints);
  for (const std::vector<double>& row : path.positions) {
    part.positions.emplace_back(row.begin() + begin, row.begin() + end);
  }
  for (const std::vector<double>& row : path.velocities) {
    part.velocities.emplace_back(row.begin() + begin, row.begin() + end);
  }
  part.segments = {{kLift, 0, static_cast<int>(path.times.size()) - 1}};
  return part;
}

// How far any point of the links moves from one sample to the next, at most [m].
double motion_between(const CompiledArm& arm, const std::vector<double>& from,
                      const std::vector<double>& to) {
  // The cubics between samples stray from lines by microradians.
  constexpr double kStray = 1e-5;
  double most = 0.0;
  for (const CompiledLink& link : arm.links) {
    double sum = 0.0;
    for (std::size_t k = 0; k < link.joints.size(); ++k) {
      const std::size_t j = index(link.joints[k]);
      sum += link.reach[k] * (std::abs(to[j] - from[j]) + kStray);
    }
    most = std::max(most, sum);
  }
  return most;
}

// Whether the links of the two stay apart while both follow their parts of the same motion.
bool stay_apart(const std::array<SharedHold, 2>& holds, const std::array<Trajectory, 2>& lift) {
  for (std::size_t k = 0; k + 1 < lift[0].times.size(); ++k) {
    double motion = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
      motion += motion_between(*holds[i].scene.arm, lift[i].positions[k], lift[i].positions[k + 1]);
    }
    if (!are_apart(links_at(holds[0].scene, lift[0].positions[k]),
                   links_at(holds[1].scene, lift[1].positions[k]), motion)) {
      return false;
    }
  }
  return true;
}

class SharedLiftPlanner {
 public:
  SharedLiftPlanner(const std::array<SharedHold, 2>& holds, const GraspPathOptions& options,
                    const RunContext& context)
      : holds_(holds), options_(options), context_(context) {}

  // From the postures (all joints) in which the hands have closed.
  std::optional<std::array<Trajectory, 2>> plan(const std::array<std::vector<double>, 2>& joints) {
    std::vector<CompiledArm> arms;
    JointPath both;
    JointLimits limits;
    for (std::size_t i = 0; i < 2; ++i) {
      const CompiledArm& own = *holds_[i].scene.arm;
      arms.push_back(arm_with_object(holds_[i].scene, holds_[i].grasp.trial.X_OH));
      const Trial& trial = holds_[i].grasp.trial;
      const std::vector<DofValues> rise =
          lift_postures({holds_[i].scene, trial, dofs_of(own, joints[i])}, arms.back(),
                        options_.lift.height, options_.reach, context_);
      // The hands rise along equal lines, in equally many steps.
      if (rise.empty() || (i > 0 && rise.size() != both.size())) return std::nullopt;
      both.resize(rise.size());
      for (std::size_t k = 0; k < rise.size(); ++k) {
        const std::vector<double> posture = arm_joints(own, rise[k], trial.joints);
        both[k].insert(both[k].end(), posture.begin(), posture.end());
      }
      const JointLimits of = joint_limits(own.robot());
      limits.velocity.insert(limits.velocity.end(), of.velocity.begin(), of.velocity.end());
      limits.acceleration.insert(limits.acceleration.end(), of.acceleration.begin(),
                                 of.acceleration.end());
    }
    const TimedPath timed = time_path(both, PathKind::smooth, limits, options_.timing);
    std::array<Trajectory, 2> lift;
    std::size_t first = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      lift[i] = part_of(timed, first, joint_names(holds_[i].scene.arm->robot()));
      first += lift[i].joints.size();
      const TimedPath own{lift[i].times, lift[i].positions, lift[i].velocities};
      if (lift_blocked(arms[i], own, options_.transfer.motion, context_)) return std::nullopt;
    }
    if (!stay_apart(holds_, lift)) return std::nullopt;
    return lift;
  }

 private:
  static std::vector<std::string> joint_names(const Robot& robot) {
    std::vector<std::string> names;
    for (const Joint& joint : robot.joints) names.push_back(joint.name);
    return names;
  }

  const std::array<SharedHold, 2>& holds_;
  const GraspPathOptions& options_;
  const RunContext& context_;
};

}  // namespace

std::optional<SharedPaths> plan_shared_paths(const std::array<SharedHold, 2>& holds,
                                             const GraspPathOptions& options,
                                             const RunContext& context) {
  const std::array<std::string, 2> names = {holds[0].scene.arm->robot().name,
                                            holds[1].scene.arm->robot().name};
  SharedPaths paths;
  auto first =
      reach_among(holds[0], links_at_start(holds[1].scene), "second " + names[1], options, context);
  if (!first) return std::nullopt;
  const std::vector<PosedLink> holding = links_at(holds[0].scene, first->positions.back());
  auto second = reach_among(holds[1], holding, "first " + names[0], options, context);
  if (!second) return std::nullopt;
  auto lift = SharedLiftPlanner(holds, options, context)
                  .plan({first->positions.back(), second->positions.back()});
  if (!lift) return std::nullopt;
  paths.reach = {std::move(*first), std::move(*second)};
  paths.lift = std::move(*lift);
  return paths;
}

}  // namespace prehend
