// Arms of six revolute joints as their axes, for inverse kinematics in closed form.
#pragma once

#include <array>
#include <string>

#include "sim/robot/denavit_hartenberg.h"

namespace prehend {

// A value for each of six joints [rad].
using SixJoints = std::array<double, 6>;

// The first `count` of `joints` [rad].
struct SixJointSolutions {
  std::array<SixJoints, 8> joints;
  int count = 0;
};

// The axes of an arm, whatever frames its joints are written in: Denavit-Hartenberg parameters
// between neighbouring axes. An axis is that of the joint or its opposite, chosen such that axes
// that are parallel to the one before them point the same way (alpha = 0, not pi).
struct SixAxes {
  std::array<Vector3, 6> axis;    // in the joint frame
  SixJoints sense;                // 1, or -1 where the opposite of the joint's axis was taken
  std::array<AxisStep, 5> steps;  // from each axis to the next

  // The link offset d at axis k [m]: the distance along the axis between the feet of its common
  // normals with the axes before and after it.
  double offset_at(std::size_t k) const {
    return steps[k].dh.d + (k > 0 ? steps[k - 1].beyond : 0.0);
  }
};

// `chain` must have six revolute joints. Axes 3 to `last_parallel` (from 1) are made to point the
// same way as the axis before them.
SixAxes six_axes(const Robot& robot, const Chain& chain, int last_parallel);

// "" where the chain has six revolute joints, else what is missing, as the end of an error message.
std::string six_revolute_defect(const Robot& robot, const Chain& chain);

// How values of joints and angles of the formulas belong together:
// angle = sense * value + theta.
struct SixAngles {
  SixAngles() = default;
  SixAngles(const Robot& robot, const Chain& chain, const SixAxes& axes);

  double angle(std::size_t k, double value) const { return sense[k] * value + theta[k]; }

  // Adds the joint values of these angles to `all` where they are inside the limits. Of angles that
  // are equal up to whole turns the one nearest to `near` is taken, and if that is outside the
  // limits, the nearest one inside.
  void add_if_inside(SixJoints angles, const SixJoints& near, SixJointSolutions& all) const;

  SixJoints sense, theta, lower, upper;  // limits: of the values
};

// X_PC: the pose of the frame C at the origin of the first joint's frame, with its z axis along the
// first axis, in the frame P that carries the chain.
Pose first_axis_pose(const Robot& robot, const Chain& chain, const SixAxes& axes);

// X_T6: the pose of the frame 6, with its z axis along the last axis and its origin at the foot of
// the common normal with the axis before it, in the frame after the last joint.
Pose last_axis_pose(const Robot& robot, const Chain& chain, const SixAxes& axes);

// Rz(theta) Rx(sign * 90 degrees) or, for sign 0, Rz(theta).
Matrix3 axis_turn(double theta, double sign);

// Angles and lengths this close to a right angle or to 0 count as exact [rad or m].
bool is_exactly_zero(double value);
bool is_right_angle(double angle);

}  // namespace prehend
