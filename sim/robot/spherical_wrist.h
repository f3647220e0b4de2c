// Inverse kinematics in closed form for arms with an elbow and a spherical wrist.
#pragma once

#include <string>

#include "sim/robot/six_axes.h"

namespace prehend {

// Six revolute joints: shoulder axes that meet at a right angle, an elbow axis parallel to the
// second, and three wrist axes that meet at a point, each at a right angle to the one before it.
// Only the axes count, not how their frames are written: the class finds the Denavit-Hartenberg
// parameters, of which d1, d2, d3, d4, a2, a3 are free, a1 = a4 = a5 = 0, d5 = 0, alpha1, alpha3 =
// +-90 degrees, alpha2 = 0, alpha4 = -alpha5 = +-90 degrees. The frame after the last joint may be
// anywhere. Source: Paul 1981, section 3.7 (Puma 560); Siciliano et al. 2009, section 2.12.
class SphericalWrist {
 public:
  using Joints = SixJoints;
  // At most one for each combination of arm left or right, elbow up or down, wrist flipped or not.
  using Solutions = SixJointSolutions;

  // `chain` must have no defect (below).
  SphericalWrist(const Robot& robot, const Chain& chain);

  // The pose of the frame C, in which poses are given, in the frame P that carries the chain. C is
  // at the origin of the first joint's frame, with its z axis along the first axis.
  const Pose& X_PC() const { return X_PC_; }

  // Joint values within limits that bring the frame after the last joint to `X_CT`. Of angles that
  // are equal up to whole turns the one nearest to `near`. Where the wrist is straight, its first
  // joint stays as `near` says.
  Solutions solve(const Pose& X_CT, const Joints& near) const;

 private:
  void add_wrists(const Matrix3& R_3T, const Joints& arm, const Joints& near, Solutions& all) const;

  Pose X_PC_;
  Pose X_T6_;  // the wrist's centre, z along the last axis, in the frame after the last joint
  SixAngles angles_;
  double d1_, a2_, side_;  // side_: how far the wrist is from the shoulder's plane
  double forearm_, fold_;  // length from the elbow to the wrist, and its angle at joint value 0
  double shoulder_sign_, elbow_sign_, wrist_sign_;  // of alpha 1, 3, 4
};

// Why the closed form does not apply to the chain, as the end of an error message; "" when it does.
std::string spherical_wrist_defect(const Robot& robot, const Chain& chain);

}  // namespace prehend
