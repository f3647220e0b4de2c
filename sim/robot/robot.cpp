#include "sim/robot/robot.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "sim/base/index.h"

namespace prehend {
namespace {

// The motion of a joint whose value, with its zero, is `amount`.
Pose motion(const Joint& joint, double amount) {
  if (joint.type == JointType::prismatic) return translation(amount * joint.axis);
  // About z the entries are plain sines and cosines. The general formula would round them again,
  // and products of Denavit-Hartenberg joints would lose their closed form.
  if (joint.axis != Vector3::UnitZ()) return Pose(Eigen::AngleAxisd(amount, joint.axis));
  const double c = std::cos(amount);
  const double s = std::sin(amount);
  Matrix3 rotation;
  rotation << c, -s, 0.0,  //
      s, c, 0.0,           //
      0.0, 0.0, 1.0;
  return pose_from(rotation, Vector3::Zero());
}

}  // namespace

bool within_limits(const DegreeOfFreedom& dof, double value) {
  constexpr double kRounding = 1e-9;  // rad or m
  return value >= dof.lower - kRounding && value <= dof.upper + kRounding;
}

bool slides(const Robot& robot, std::size_t dof) {
  return std::any_of(robot.joints.begin(), robot.joints.end(), [&](const Joint& joint) {
    return index(joint.dof) == dof && joint.type == JointType::prismatic;
  });
}

const std::string& driver_name(const Joint& joint) {
  return joint.driver_name.empty() ? joint.name : joint.driver_name;
}

const std::string& driver_name(const Link& link) {
  return link.driver_name.empty() ? link.name : link.driver_name;
}

const RobotFrame* frame_with(const Robot& robot, FrameRole role) {
  for (const RobotFrame& frame : robot.frames) {
    if (frame.role == role) return &frame;
  }
  return nullptr;
}

std::vector<double> initial_dofs(const Robot& robot) {
  std::vector<double> values;
  for (const DegreeOfFreedom& dof : robot.dofs) values.push_back(dof.initial);
  return values;
}

std::vector<double> joint_values(const Robot& robot, const std::vector<double>& dofs) {
  std::vector<double> values;
  joint_values(robot, dofs, values);
  return values;
}

void joint_values(const Robot& robot, const std::vector<double>& dofs,
                  std::vector<double>& values) {
  assert(dofs.size() == robot.dofs.size());
  values.resize(robot.joints.size());
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Joint& joint = robot.joints[j];
    values[j] = joint.ratio * dofs[static_cast<std::size_t>(joint.dof)] + joint.offset;
  }
}

void link_poses(const Robot& robot, const std::vector<double>& joints, std::vector<Pose>& X_BL) {
  RobotPoses poses;
  poses.X_BL.swap(X_BL);  // its memory
  robot_poses(robot, joints, poses);
  X_BL.swap(poses.X_BL);
}

void robot_poses(const Robot& robot, const std::vector<double>& joints, RobotPoses& poses) {
  joint_poses(robot, joints, poses.X_BJ);
  poses.X_BL.resize(robot.links.size());
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    const int joint = robot.links[l].joint;
    poses.X_BL[l] = joint < 0 ? Pose::Identity() : poses.X_BJ[index(joint)];
  }
}

std::vector<int> joints_to(const Robot& robot, int joint) {
  std::vector<int> path;
  for (int j = joint; j >= 0; j = robot.joints[index(j)].parent) path.push_back(j);
  std::reverse(path.begin(), path.end());
  return path;
}

Pose own_frame(const Robot& robot, std::size_t link) {
  const Link& its = robot.links[link];
  for (const RobotFrame& frame : robot.frames) {
    if (link > 0 && frame.name == its.name && frame.joint == its.joint) return frame.X_AF;
  }
  return Pose::Identity();
}

Pose across(const Joint& joint, double value) {
  return motion(joint, value + joint.zero) * joint.X_JA;
}

void joint_poses(const Robot& robot, const std::vector<double>& joints, std::vector<Pose>& X_BJ) {
  assert(joints.size() == robot.joints.size());
  X_BJ.resize(robot.joints.size());
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Joint& joint = robot.joints[j];
    assert(joint.parent < static_cast<int>(j));
    const Pose X_BF = joint.parent < 0 ? joint.X_PJ : X_BJ[index(joint.parent)] * joint.X_PJ;
    X_BJ[j] = X_BF * across(joint, joints[j]);
  }
}

Pose link_pose(const Robot& robot, const std::vector<int>& chain,
               const std::vector<double>& joints) {
  Pose X_BL = Pose::Identity();
  for (const int j : chain) {
    const Joint& joint = robot.joints[index(j)];
    X_BL = X_BL * joint.X_PJ * across(joint, joints[index(j)]);
  }
  return X_BL;
}

Pose joint_pose(const Robot& robot, int joint, const std::vector<double>& joints) {
  const Joint& last = robot.joints[index(joint)];
  const Pose X_BF =
      last.parent < 0 ? last.X_PJ : joint_pose(robot, last.parent, joints) * last.X_PJ;
  return X_BF * across(last, joints[index(joint)]);
}

}  // namespace prehend
