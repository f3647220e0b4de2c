// Inverse kinematics in closed form for arms built like those of Universal Robots.
#pragma once

#include <string>

#include "sim/robot/six_axes.h"

namespace prehend {

// Six revolute joints: shoulder axes that meet at a right angle, axes 2, 3 and 4 parallel, and 5
// and 6 each meeting the one before it at a right angle, so that the last three do not meet in a
// point. Only the axes count, not how their frames are written: d1 to d6, a2 and a3 are free,
// a1 = a4 = a5 = 0, alpha1, alpha4, alpha5 = +-90 degrees, alpha2 = alpha3 = 0. The frame after the
// last joint may be anywhere. Source: Hawkins, "Analytic inverse kinematics for the Universal
// Robots UR-5/UR-10 arms", 2013.
class UrArm {
 public:
  using Joints = SixJoints;
  // At most one for each combination of shoulder left or right, wrist flipped or not, elbow up or
  // down.
  using Solutions = SixJointSolutions;

  // `chain` must have no defect (below).
  UrArm(const Robot& robot, const Chain& chain);

  // The pose of the frame C, in which poses are given, in the frame P that carries the chain. C is
  // at the origin of the first joint's frame, with its z axis along the first axis.
  const Pose& X_PC() const { return X_PC_; }

  // Joint values within limits that bring the frame after the last joint to `X_CT`. Of angles that
  // are equal up to whole turns the one nearest to `near`. Where the axes of joints 4 and 6 are
  // parallel, the last joint stays as `near` says.
  Solutions solve(const Pose& X_CT, const Joints& near) const;

 private:
  void add_wrists(const Pose& X_C6, double q1, const Joints& near, Solutions& all) const;
  void add_elbows(const Vector3& p_1, double pitch, Joints angles, const Joints& near,
                  Solutions& all) const;

  Pose X_PC_;
  Pose X_T6_;  // where axes 5 and 6 meet, z along the last axis, in the frame after the last joint
  SixAngles angles_;
  double d1_, a2_, a3_, d5_, side_;  // side_: how far axis 5 is from the first axis
  double sign1_, sign4_, sign5_;     // of the angles alpha
};

// Why the closed form does not apply to the chain, as the end of an error message; "" when it does.
std::string ur_arm_defect(const Robot& robot, const Chain& chain);

}  // namespace prehend
