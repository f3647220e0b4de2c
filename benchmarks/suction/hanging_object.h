// An object that hangs on suction cups.
#pragma once

#include <vector>

#include "sim/base/pose.h"
#include "sim/robot/inertial.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend::bench {

// A cup that seals, relaxed, in the object's frame.
struct HangingCup {
  Vector3 center_O = Vector3::Zero();  // of the lip [m]
  Vector3 axis_O = Vector3::UnitZ();   // unit, out of the cup towards the object
  double radius = 0.0;                 // of the lip [m]
  double travel = 0.0;                 // of a point of the lip, either way [m]
  double stiffness = 0.0;              // of the whole lip along the axis [N/m]
  double friction = 0.0;
  double pull = 0.0;  // force of the vacuum [N]
};

struct HangingObject {
  Inertial inertial;                 // frame O
  std::vector<TriangleMesh> pieces;  // convex, frame O
  std::vector<HangingCup> cups;
  Vector3 down_O = -Vector3::UnitZ();  // unit, where gravity pulls at the start
};

}  // namespace prehend::bench
