#include "sim/robot/joint_course.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/base/index.h"

namespace prehend {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

bool drives_on(Coupling coupling) {
  return coupling == Coupling::rigid || coupling == Coupling::by_finger;
}

}  // namespace

std::vector<int> first_joints_of_fingers(const Robot& robot) {
  std::vector<int> first(robot.joints.size());
  for (std::size_t j = 0; j < first.size(); ++j) {
    first[j] = static_cast<int>(j);
    int before = robot.joints[j].parent;
    while (before >= 0 && robot.joints[index(before)].dof != robot.joints[j].dof) {
      before = robot.joints[index(before)].parent;
    }
    if (before >= 0) first[j] = first[index(before)];
  }
  for (std::size_t j = 0; j < first.size(); ++j) {
    if (robot.joints[j].across < 0) continue;
    const auto [low, high] = std::minmax({first[j], first[index(robot.joints[j].across)]});
    std::replace(first.begin(), first.end(), high, low);
  }
  return first;
}

bool gives_way(const Robot& robot, int joint) {
  if (!drives_on(robot.dofs[index(robot.joints[index(joint)].dof)].coupling)) return false;
  return std::any_of(robot.joints.begin(), robot.joints.end(),
                     [&](const Joint& other) { return other.across == joint; });
}

void JointCourse::start(const Robot& robot, const std::vector<double>& dofs,
                        const std::vector<DofCourse>& closing, const std::vector<double>& joints) {
  robot_ = &robot;
  if (joints.empty()) {
    joint_values(robot, dofs, start_);
  } else {
    start_ = joints;
  }
  first_.assign(robot.joints.size(), 0.0);
  second_.assign(robot.joints.size(), 0.0);
  turn_.assign(robot.joints.size(), kNever);
  until_.assign(robot.joints.size(), 0.0);
  by_contact_.assign(robot.joints.size(), false);
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Joint& joint = robot.joints[j];
    const DofCourse& course = closing[index(joint.dof)];
    if (course.velocity == 0.0) continue;
    first_[j] = joint.ratio * course.velocity;
    second_[j] = first_[j];
    if (joint.across >= 0 && drives_on(robot.dofs[index(joint.dof)].coupling)) {
      second_[j] += joint.ahead * robot.joints[index(joint.across)].ratio * course.velocity;
    }
    until_[j] = std::max(0.0, (course.end - dofs[index(joint.dof)]) / course.velocity);
  }
}

double JointCourse::value(int joint, double t) const {
  const std::size_t j = index(joint);
  const double time = std::min(t, until_[j]);
  if (time <= turn_[j]) return start_[j] + first_[j] * time;
  return start_[j] + first_[j] * turn_[j] + second_[j] * (time - turn_[j]);
}

double JointCourse::speed(int joint, double t) const {
  const std::size_t j = index(joint);
  if (t >= until_[j]) return 0.0;
  const double second = std::abs(second_[j]);
  return t >= turn_[j] ? second : std::max(std::abs(first_[j]), second);
}

double JointCourse::velocity(int joint, double t) const {
  const std::size_t j = index(joint);
  if (t >= until_[j]) return 0.0;
  return t >= turn_[j] ? second_[j] : first_[j];
}

bool JointCourse::may_turn(int joint, double t) const {
  const std::size_t j = index(joint);
  return first_[j] != second_[j] && t < std::min(turn_[j], until_[j]);
}

double JointCourse::end() const {
  return until_.empty() ? 0.0 : *std::max_element(until_.begin(), until_.end());
}

void JointCourse::stop(int joint, double t) {
  if (!moves(joint, t)) return;
  const double unused = until_[index(joint)] - t;
  until_[index(joint)] = t;
  by_contact_[index(joint)] = true;
  const int dof = robot_->joints[index(joint)].dof;
  if (robot_->dofs[index(dof)].coupling != Coupling::self_centering) return;
  // Centring (center_hand) sets both joints to their mean. So the other finger may pass its limit
  // by what this one leaves unused, and the mean is still inside the limits.
  for (std::size_t other = 0; other < until_.size(); ++other) {
    if (robot_->joints[other].dof == dof && !by_contact_[other]) until_[other] += unused;
  }
}

std::vector<int> JointCourse::fellows(int joint) const {
  const int dof = robot_->joints[index(joint)].dof;
  const Coupling coupling = robot_->dofs[index(dof)].coupling;
  if (!drives_on(coupling)) return {};
  std::vector<int> first;
  if (coupling == Coupling::by_finger) first = first_joints_of_fingers(*robot_);
  std::vector<int> fellows;
  for (std::size_t j = 0; j < until_.size(); ++j) {
    if (robot_->joints[j].dof != dof) continue;
    if (first.empty() || first[j] == first[index(joint)]) fellows.push_back(static_cast<int>(j));
  }
  return fellows;
}

double JointCourse::limit_time(int joint, double t) const {
  const Joint& of = robot_->joints[index(joint)];
  const double v = second_[index(joint)];
  if (v == 0.0) return kNever;
  return t + std::max(0.0, ((v > 0.0 ? of.upper : of.lower) - value(joint, t)) / v);
}

// The drive goes on until one of the joints that turned is at its limit.
void JointCourse::turn_across(int joint, double t) {
  double last = kNever;
  for (std::size_t j = 0; j < until_.size(); ++j) {
    if (robot_->joints[j].across != joint || t >= until_[j]) continue;
    last = std::min(last, limit_time(static_cast<int>(j), t));
    turn_[j] = t;
  }
  for (const int other : fellows(joint))
    until_[index(other)] = std::min(until_[index(other)], last);
}

void JointCourse::stop_before(const std::vector<int>& joints, double t) {
  if (joints.empty()) return;
  const int last = joints.back();
  if (moves(last, t) && gives_way(*robot_, last)) {
    for (const int joint : joints) stop(joint, t);
    turn_across(last, t);
    return;
  }
  for (const int joint : joints) {
    if (!moves(joint, t)) continue;
    stop(joint, t);
    for (const int other : fellows(joint)) stop(other, t);
  }
}

}  // namespace prehend
