#include "sim/robot/robot.h"

#include <cassert>
#include <cmath>

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

// Calls visit(joint index, pose of the frame after it), chain by chain, base to tip.
template <typename Visit>
void for_each_joint_frame(const Robot& robot, const std::vector<double>& joints, Visit visit) {
  assert(joints.size() == robot.joints.size());
  for (const Chain& chain : robot.chains) {
    Pose X_BJ = chain.X_BC;
    for (int j = chain.first_joint; j < chain.first_joint + chain.joint_count; ++j) {
      const auto index = static_cast<std::size_t>(j);
      X_BJ = X_BJ * across(robot.joints[index], joints[index]);
      visit(j, X_BJ);
    }
  }
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
  X_BL.assign(robot.links.size(), Pose::Identity());
  // Robots have few links, so asking each of them beats storing a second index.
  for_each_joint_frame(robot, joints, [&](int j, const Pose& X_BJ) {
    for (std::size_t l = 0; l < robot.links.size(); ++l) {
      if (robot.links[l].joint == j) X_BL[l] = X_BJ;
    }
  });
}

void joint_poses(const Robot& robot, const std::vector<double>& joints, std::vector<Pose>& X_BJ) {
  X_BJ.resize(robot.joints.size());
  for_each_joint_frame(robot, joints,
                       [&](int j, const Pose& X) { X_BJ[static_cast<std::size_t>(j)] = X; });
}

}  // namespace prehend
