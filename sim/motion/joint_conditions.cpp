#include "sim/motion/joint_conditions.h"

#include <algorithm>
#include <cmath>

#include "sim/base/index.h"

namespace prehend {
namespace {

using Eigen::Index;

// A row on velocities from `first` on.
JacobianBlock row_on(int first, const Eigen::RowVectorXd& row) {
  JacobianBlock block{first, Eigen::MatrixX4d::Zero(row.size(), 4)};
  block.transposed.col(0) = row.transpose();
  return block;
}

// A row on a single velocity.
JacobianBlock unit_row(int velocity) { return row_on(velocity, Eigen::RowVectorXd::Ones(1)); }

ContactCondition condition_on(JacobianBlock row) { return {.blocks = {std::move(row)}, .rows = 1}; }

ContactCondition drive_condition(const WorldRobot& robot, const Drive& drive, int first,
                                 double time) {
  ContactCondition condition = condition_on(unit_row(first + drive.dof));
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

Index first_joint(const Clutch& clutch) { return static_cast<Index>(clutch.joints.front()); }

// Whether a gear keeps the joints of a clutch from being pushed back: unless a drive moves them
// against the direction in which it locks.
bool is_locked(const WorldRobot& robot, const Clutch& clutch) {
  if (!(clutch.gear_effort > 0.0)) return false;
  const double ratio = robot.model->robot.joints[index(clutch.joints.front())].ratio;
  return std::none_of(robot.drives.begin(), robot.drives.end(), [&](const Drive& drive) {
    if (drive.dof != clutch.dof) return false;
    double way = drive.target_rate;
    if (!drive.holds_rate && drive.stiffness > 0.0) way = drive.target - robot.x[drive.dof];
    return way * ratio * clutch.locks < 0.0;
  });
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
      const Clutch& clutch = model_.clutches[c];
      const Index slip = model_.dofs() + static_cast<Index>(c);
      if (clutch.stays_behind != 0.0) {
        const double behind = -clutch.stays_behind;
        add_stop(scaled_row(static_cast<int>(slip), behind), behind * robot_.x[slip],
                 robot_.rate[slip]);
      } else {
        add_dry(unit_row(first_ + static_cast<int>(slip)), clutch.effort);
      }
    }
    const Eigen::VectorXd q = joints_of(robot_);
    for (std::size_t c = 0; c < model_.clutches.size(); ++c, ++place_) {
      if (is_locked(robot_, model_.clutches[c])) add_gear(model_.clutches[c], stop_of(c, q), q);
    }
    const Eigen::VectorXd v = model_.joints_of * robot_.rate;
    for (std::size_t j = 0; j < model_.robot.joints.size(); ++j) {
      const Joint& joint = model_.robot.joints[j];
      const auto at = static_cast<Index>(j);
      if (joint.friction.coulomb > 0.0) add_dry(row_of(at, 1.0), joint.friction.coulomb);
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
    return row_on(first_, sign * model_.joints_of.row(joint));
  }

  JacobianBlock scaled_row(int velocity, double sign) const {
    return row_on(first_ + velocity, Eigen::RowVectorXd::Constant(1, sign));
  }

  double stop_of(std::size_t clutch, const Eigen::VectorXd& q) const {
    return robot_.gear_stops.empty() ? q[first_joint(model_.clutches[clutch])]
                                     : robot_.gear_stops[clutch];
  }

  // A spring that only resists being pushed back from where it stands. It acts as it is at the end
  // of the step: impulse = time stiffness (way back - time rate).
  void add_gear(const Clutch& clutch, double stop, const Eigen::VectorXd& q) {
    const Index joint = first_joint(clutch);
    ContactCondition condition = condition_on(row_of(joint, clutch.locks));
    condition.compliance = 1.0 / (time_ * time_ * clutch.gear_stiffness);
    condition.offset[0] = -clutch.locks * (stop - q[joint]) / time_;
    condition.upper = time_ * clutch.gear_effort;
    add(std::move(condition));
  }

  void add(ContactCondition condition) { conditions_.push_back({std::move(condition), place_}); }

  // Keeps a velocity at 0 with up to an effort.
  void add_dry(JacobianBlock row, double effort) {
    ContactCondition condition = condition_on(std::move(row));
    condition.lower = -time_ * effort;
    condition.upper = time_ * effort;
    add(std::move(condition));
  }

  void add_limit(Index joint, double sign, double room, double rate) {
    add_stop(row_of(joint, sign), room, rate);
  }

  // `room`: what is left to the stop. One that is passed, as postures from files may be, is where
  // the joint is.
  void add_stop(JacobianBlock row, double room, double rate) {
    constexpr double kNear = 0.05;  // [rad or m]: steps that speed up do not pass this far
    if (room > kNear + 2.0 * time_ * std::abs(rate)) return;
    ContactCondition condition = condition_on(std::move(row));
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

std::vector<double> gear_stops(const WorldRobot& before, const WorldRobot& after) {
  const std::vector<Clutch>& clutches = before.model->clutches;
  const Eigen::VectorXd q_before = joints_of(before);
  const Eigen::VectorXd q = joints_of(after);
  std::vector<double> stops;
  for (std::size_t c = 0; c < clutches.size(); ++c) {
    const Clutch& clutch = clutches[c];
    const Index joint = first_joint(clutch);
    const double from = before.gear_stops.empty() ? q_before[joint] : before.gear_stops[c];
    const double most =
        is_locked(before, clutch) ? clutch.gear_effort / clutch.gear_stiffness : 0.0;
    const double way_back = std::clamp(clutch.locks * (from - q[joint]), 0.0, most);
    stops.push_back(q[joint] + clutch.locks * way_back);
  }
  return stops;
}

std::size_t joint_places(const WorldRobot& robot) {
  return robot.drives.size() + 2 * robot.model->clutches.size() +
         3 * robot.model->robot.joints.size();
}

}  // namespace prehend
