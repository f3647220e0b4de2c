#include "sim/robot/robot.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/base/index.h"

namespace prehend {
namespace {

// Rz(theta) Tz(d) Tx(a) Rx(alpha), multiplied out.
Pose denavit_hartenberg(double theta, double d, double a, double alpha) {
  const double ct = std::cos(theta);
  const double st = std::sin(theta);
  const double ca = std::cos(alpha);
  const double sa = std::sin(alpha);
  Matrix3 rotation;
  rotation << ct, -st * ca, st * sa,  //
      st, ct * ca, -ct * sa,          //
      0.0, sa, ca;
  return pose_from(rotation, Vector3(a * ct, a * st, d));
}

Pose across(const Joint& joint, double value) {
  const bool revolute = joint.type == JointType::revolute;
  return denavit_hartenberg(joint.theta + (revolute ? value : 0.0),
                            joint.d + (revolute ? 0.0 : value), joint.a, joint.alpha);
}

}  // namespace

std::vector<double> joint_values(const Robot& robot, const std::vector<double>& dofs) {
  assert(dofs.size() == robot.dofs.size());
  std::vector<double> values;
  values.reserve(robot.joints.size());
  for (const Joint& joint : robot.joints) {
    values.push_back(joint.ratio * dofs[static_cast<std::size_t>(joint.dof)] + joint.offset);
  }
  return values;
}

void link_poses(const Robot& robot, const std::vector<double>& joints, std::vector<Pose>& X_BL) {
  std::vector<Pose> X_BJ;
  joint_poses(robot, joints, X_BJ);
  X_BL.resize(robot.links.size());
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    const int joint = robot.links[l].joint;
    X_BL[l] = joint < 0 ? Pose::Identity() : X_BJ[index(joint)];
  }
}

std::vector<int> joints_to(const Robot& robot, int joint) {
  std::vector<int> path;
  for (int j = joint; j >= 0; j = robot.joints[index(j)].parent) path.push_back(j);
  std::reverse(path.begin(), path.end());
  return path;
}

void joint_poses(const Robot& robot, const std::vector<double>& joints, std::vector<Pose>& X_BJ) {
  assert(joints.size() == robot.joints.size());
  X_BJ.resize(robot.joints.size());
  for (const Chain& chain : robot.chains) {
    Pose X = chain.parent < 0 ? chain.X_PC : X_BJ[index(chain.parent)] * chain.X_PC;
    for (int j = chain.first_joint; j < chain.first_joint + chain.joint_count; ++j) {
      X = X * across(robot.joints[index(j)], joints[index(j)]);
      X_BJ[index(j)] = X;
    }
  }
}

}  // namespace prehend
