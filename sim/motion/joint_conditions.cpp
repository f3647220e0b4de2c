#include "sim/motion/joint_conditions.h"

#include <algorithm>
#include <cmath>

#include "sim/base/index.h"

namespace prehend {
namespace {

using Eigen::Index;

// A row on a single velocity.
JacobianBlock unit_row(int velocity) { return {velocity, Eigen::MatrixXd::Ones(1, 1)}; }

ContactCondition drive_condition(const WorldRobot& robot, const Drive& drive, int first,
                                 double time) {
  ContactCondition condition{.blocks = {unit_row(first + drive.dof)}};
  condition.lower = -time * drive.max_effort;
  condition.upper = time * drive.max_effort;
  if (drive.holds_rate) {
    condition.offset[0] = -drive.target_rate;
    return condition;
  }
  // impulse = time (stiffness (target - value - time rate) + damping (target_rate - rate)), that
  // is, -(rate + offset) / compliance.
  const double per_rate = time * (time * drive.stiffness + drive.damping);
  const double push = time * (drive.stiffness * (drive.target - robot.x[drive.dof]) +
                              drive.damping * drive.target_rate);
  condition.compliance = 1.0 / per_rate;
  condition.offset[0] = -push / per_rate;
  return condition;
}

class JointConditions {
 public:
  JointConditions(const WorldRobot& robot, int first, double time)
      : robot_(robot), model_(*robot.model), first_(first), time_(time) {}

  std::vector<JointCondition> all() {
    for (const Drive& drive : robot_.drives) {
      const bool acts = drive.holds_rate || drive.stiffness > 0.0 || drive.damping > 0.0;
      if (acts) add(drive_condition(robot_, drive, first_, time_));
      ++place_;
    }
    for (std::size_t c = 0; c < model_.clutches.size(); ++c, ++place_) {
      const int slip = static_cast<int>(model_.dofs()) + static_cast<int>(c);
      add_dry({unit_row(first_ + slip)}, model_.clutches[c].effort);
    }
    for (const Clutch& clutch : model_.clutches) {
      if (clutch.locks != 0.0 && !opens(clutch)) {
        add({.blocks = {row_of(clutch.joints.front(), clutch.locks)}});
      }
      ++place_;
    }
    const Eigen::VectorXd q = joints_of(robot_);
    const Eigen::VectorXd v = model_.joints_of * robot_.rate;
    for (std::size_t j = 0; j < model_.robot.joints.size(); ++j) {
      const Joint& joint = model_.robot.joints[j];
      const auto at = static_cast<Index>(j);
      if (joint.friction.coulomb > 0.0) add_dry({row_of(at, 1.0)}, joint.friction.coulomb);
      ++place_;
      add_limit(at, 1.0, q[at] - joint.lower, v[at]);
      ++place_;
      add_limit(at, -1.0, joint.upper - q[at], v[at]);
      ++place_;
    }
    return std::move(conditions_);
  }

 private:
  JacobianBlock row_of(Index joint, double sign) const {
    return {first_, sign * model_.joints_of.row(joint)};
  }

  // Whether a drive moves the joints of a clutch against the direction in which it locks.
  bool opens(const Clutch& clutch) const {
    const double ratio = model_.robot.joints[index(clutch.joints.front())].ratio;
    return std::any_of(robot_.drives.begin(), robot_.drives.end(), [&](const Drive& drive) {
      if (drive.dof != clutch.dof) return false;
      double way = drive.target_rate;
      if (!drive.holds_rate && drive.stiffness > 0.0) way = drive.target - robot_.x[drive.dof];
      return way * ratio * clutch.locks < 0.0;
    });
  }

  void add(ContactCondition condition) { conditions_.push_back({std::move(condition), place_}); }

  // Keeps a velocity at 0 with up to an effort.
  void add_dry(std::vector<JacobianBlock> blocks, double effort) {
    ContactCondition condition{.blocks = std::move(blocks)};
    condition.lower = -time_ * effort;
    condition.upper = time_ * effort;
    add(std::move(condition));
  }

  // `room`: what is left to the limit. One that is passed, as postures from files may be, is a stop
  // where the joint is.
  void add_limit(Index joint, double sign, double room, double rate) {
    constexpr double kNear = 0.05;  // [rad or m]: steps that speed up do not pass this far
    if (room > kNear + 2.0 * time_ * std::abs(rate)) return;
    ContactCondition condition{.blocks = {row_of(joint, sign)}};
    condition.offset[0] = std::max(room, 0.0) / time_;
    add(std::move(condition));
  }

  const WorldRobot& robot_;
  const RobotModel& model_;
  int first_;
  double time_;
  std::size_t place_ = 0;
  std::vector<JointCondition> conditions_;
};

}  // namespace

std::vector<JointCondition> joint_conditions(const WorldRobot& robot, int first, double time) {
  return JointConditions(robot, first, time).all();
}

std::size_t joint_places(const WorldRobot& robot) {
  return robot.drives.size() + 2 * robot.model->clutches.size() +
         3 * robot.model->robot.joints.size();
}

}  // namespace prehend
