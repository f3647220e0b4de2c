// Inverse kinematics in closed form for arms with an elbow and a spherical wrist.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "sim/robot/robot.h"

namespace prehend {

// Six revolute joints: shoulder axes that meet at a right angle (a1 = 0, alpha1 = +-90 degrees), a
// parallel elbow axis (alpha2 = 0), and three wrist axes that meet at a point (a4 = a5 = a6 = 0,
// d5 = 0, alpha3 = +-90, alpha4 = -alpha5 = +-90, alpha6 = 0). d1, d2, d3, d4, d6, a2, a3 are free.
// Source: Paul 1981, section 3.7 (Puma 560); Siciliano et al. 2009, section 2.12.
class SphericalWrist {
 public:
  using Joints = std::array<double, 6>;

  // At most one solution for each of: arm left or right, elbow up or down, wrist flipped or not.
  struct Solutions {
    std::array<Joints, 8> joints;
    int count = 0;
  };

  // `chain` must have no defect (below).
  SphericalWrist(const Robot& robot, const Chain& chain);

  // Joint values within limits that bring the frame after the last joint to `X_CT`, the pose in the
  // chain's first frame. Of angles that are equal up to whole turns the one nearest to `near`.
  // Where the wrist is straight, its first joint stays as `near` says.
  Solutions solve(const Pose& X_CT, const Joints& near) const;

 private:
  void add_wrists(const Matrix3& R_3T, const Joints& arm, const Joints& near, Solutions& all) const;
  void add_if_inside(Joints angles, const Joints& near, Solutions& all) const;

  Joints theta_;  // of the Denavit-Hartenberg parameters
  Joints lower_, upper_;
  double d1_, a2_, side_, d6_;  // side_: how far the wrist is from the shoulder's plane
  double forearm_, fold_;  // length from the elbow to the wrist, and its angle at joint value 0
  double shoulder_sign_, elbow_sign_, wrist_sign_;  // of alpha 1, 3, 4
};

// Why the closed form does not fit the chain, "" when it does.
std::string spherical_wrist_defect(const Robot& robot, const Chain& chain);

}  // namespace prehend
