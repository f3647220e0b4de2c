// Joints written with the four parameters of Denavit and Hartenberg, and those parameters for any
// two axes that follow each other.
#pragma once

#include "sim/robot/robot.h"

namespace prehend {

// Standard (distal) convention: the frame after a joint in the frame before it is
// Rz(theta) Tz(d) Tx(a) Rx(alpha). A revolute joint's value is added to theta, a prismatic one's to
// d. Source: Denavit and Hartenberg 1955; Paul 1981, section 2.8.
struct DhParameters {
  double theta = 0.0;  // rad
  double d = 0.0;      // m
  double a = 0.0;      // m
  double alpha = 0.0;  // rad
};

// `joint` with the axis z, its zero and the frame after it set so that it moves as the parameters
// say; its type must be set. across() then gives the closed form of the product bit for bit (up to
// the sign of zeros).
Joint denavit_hartenberg(Joint joint, const DhParameters& parameters);

// A pose taken apart into Rz(theta) Tz(d) Tx(a) Rx(alpha) Tz(beyond) Rz(twist): from the z axis of
// one frame along the common normal to the z axis of another, and along that to the other frame.
struct AxisStep {
  DhParameters dh;
  double beyond = 0.0;  // m
  double twist = 0.0;   // rad
};

// Of the two ways to point the common normal the one with cos(theta) >= 0 is taken. Parallel axes
// have many common normals: the one through the second frame's origin is taken (beyond = 0), and
// for axes that coincide the x axis (theta = 0).
AxisStep step_between_axes(const Pose& X);

}  // namespace prehend
