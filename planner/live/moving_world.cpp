#include "planner/live/moving_world.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Eigenvalues>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/motion/dynamic_grasp/hand_drives.h"
#include "sim/motion/require_world.h"

namespace prehend {
namespace {

// How many steps one that should be enough may become where bodies meet.
constexpr int kMostShortened = 20;
// Speed of degrees of freedom that say none [rad/s or m/s].
constexpr double kPlainSpeed = 1.0;
constexpr double kPlainSlideSpeed = 0.1;
// Before a target, so that it is not overshot [s].
constexpr double kSlowing = 0.02;

double speed_of(const Robot& robot, std::size_t dof) {
  const DegreeOfFreedom& of = robot.dofs[dof];
  if (of.closing_velocity != 0.0) return std::abs(of.closing_velocity);
  if (of.max_velocity > 0.0) return of.max_velocity;
  return slides(robot, dof) ? kPlainSlideSpeed : kPlainSpeed;
}

// The mass that a force at a point of the body has to move, in the direction that gives way most.
double moved_mass(const WorldBody& body, const Vector3& p_B) {
  const Vector3 r = p_B - body.inertial.center_of_mass;
  Matrix3 across;
  across << 0.0, -r.z(), r.y(), r.z(), 0.0, -r.x(), -r.y(), r.x(), 0.0;
  const Matrix3 mobility = Matrix3::Identity() / body.inertial.mass +
                           across.transpose() * body.inertial.inertia.ldlt().solve(across);
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(mobility, Eigen::EigenvaluesOnly);
  return 1.0 / solver.eigenvalues().maxCoeff();
}

}  // namespace

MovingWorld::MovingWorld(const CompiledScene& scene, const Pose& X_WH, const HandPosture& posture,
                         const TimeOptions& options)
    : options_(options), world_(make_scene_world(scene, true)), drives_(posture.dofs.size()) {
  require_in(kLiveStep, options.step, "step");
  if (!options.gravity) world_.gravity.setZero();
  hand_ = add_hand(world_, scene, hand_model(scene), X_WH, posture.dofs, posture.joints);
  StepOptions step;
  step.step = options.step;
  require_world(world_, step);
}

StepOutcome MovingWorld::step(double longest, double& taken) {
  set_drives(longest);
  set_pull();
  StepOptions options;
  options.step = longest;
  const StepResult result = step_world(world_, options);
  taken = result.time;
  time_ += result.time;
  last_ = result.outcome;
  return result.outcome;
}

StepOutcome MovingWorld::advance(double seconds) {
  require_in(kLiveAdvance, seconds, "seconds");
  const double begin = time_;
  // Rounding must not make one step more, nor leave one of next to no time at the end.
  const double count = std::max(std::ceil(seconds / options_.step - 1e-6), 1.0);
  const double longest = seconds / count;
  int left = kMostShortened * static_cast<int>(count);
  StepOutcome worst = StepOutcome::moved;
  for (double done = 0.0; done < seconds * (1.0 - 1e-9);) {
    if (left-- == 0) return worst;
    double taken = 0.0;
    const StepOutcome outcome = step(std::min(longest, seconds - done), taken);
    worst = std::max(worst, outcome);
    if (outcome == StepOutcome::blocked || outcome == StepOutcome::not_finite) return worst;
    done += taken;
  }
  time_ = begin + seconds;
  return worst;
}

void MovingWorld::set_drives(double step) {
  WorldRobot& robot = world_.robots[index(hand_.robot)];
  std::vector<Drive> drives = holding_drives(*robot.model, hand_);
  robot.effort = Eigen::VectorXd::Zero(robot.model->dofs());
  for (Drive& drive : drives) {
    const std::size_t d = index(drive.dof);
    if (drives_[d].target) {
      const double speed = speed_of(robot.model->robot, d);
      const double way = *drives_[d].target - robot.x[drive.dof];
      drive.target_rate = std::clamp(way / std::max(kSlowing, step), -speed, speed);
    }
    if (drives_[d].effort) robot.effort[drive.dof] = *drives_[d].effort;
  }
  std::erase_if(drives,
                [&](const Drive& drive) { return drives_[index(drive.dof)].effort.has_value(); });
  set_hand_drives(drives, hand_, robot);
}

void MovingWorld::set_pull() {
  WorldBody& object = world_.bodies[index(kObjectBody)];
  object.force_W.setZero();
  object.torque_W.setZero();
  if (!pull_) return;
  const RigidMotion& motion = object.motion;
  const Vector3 point_W = motion.X_WB * pull_->point_O;
  const Vector3 arm_W = point_W - center_in_world(object.inertial, motion.X_WB);
  const Vector3 velocity_W = motion.linear + motion.angular.cross(arm_W);
  const double damping = 2.0 * std::sqrt(pull_->stiffness * moved_mass(object, pull_->point_O));
  object.force_W = pull_->stiffness * (pull_->to_W - point_W) - damping * velocity_W;
  object.torque_W = arm_W.cross(object.force_W);
}

void MovingWorld::wake() {
  for (WorldBody& body : world_.bodies) {
    body.asleep = false;
    body.rest_time = 0.0;
  }
}

void MovingWorld::drive(std::size_t dof, const DofDrive& drive) {
  const RobotModel& model = *world_.robots[index(hand_.robot)].model;
  const DegreeOfFreedom& of = model.robot.dofs[dof];
  DofDrive& own = drives_[dof];
  own = drive;
  if (own.target) own.target = std::clamp(*own.target, of.lower, of.upper);
  const double most = model.effort[static_cast<Eigen::Index>(dof)];
  if (own.effort) own.effort = std::clamp(*own.effort, -most, most);
  wake();
}

void MovingWorld::pull(const std::optional<ObjectPull>& pull) {
  if (pull) {
    // Forces act as they are at the beginning of a step. Up to here a step stays far from where
    // that would be unstable.
    constexpr double kStiffest = 1.0 / 16.0;
    const double most = kStiffest * moved_mass(world_.bodies[index(kObjectBody)], pull->point_O) /
                        (options_.step * options_.step);
    require_in({.upper = most}, pull->stiffness, "stiffness");
  }
  pull_ = pull;
  wake();
}

HandPosture MovingWorld::posture() const {
  return {object().X_WB.inverse() * hand_pose(world_, hand_), hand_dofs(world_, hand_),
          hand_joints(world_, hand_)};
}

}  // namespace prehend
