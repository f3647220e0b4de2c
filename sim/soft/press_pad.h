// A pad pressed on an object.
#pragma once

#include <vector>

#include "sim/shape/proximity_mesh.h"
#include "sim/soft/limit_surface.h"
#include "sim/soft/pad.h"
#include "sim/soft/press.h"

namespace prehend {

// Beyond this part of its thickness a pad is not pressed: strains are then so large that linear
// elasticity says little of them.
inline constexpr double kLargestStrain = 0.3;

// Where a pad bears on the object, in the object's frame O.
struct PadPatch {
  std::vector<int> nodes;            // of the pad, those with a force, ascending
  std::vector<PressedPoint> points;  // of each: on the object's surface
  double approach = 0.0;             // from where the pad first touches [m]
  double load = 0.0;  // along the direction of pressing; less than asked for where the
                      // largest strain is reached [N]
};

// Buffers of press_pad, to allocate less; one for each thread.
struct PadWorkspace {
  std::vector<int> near;             // nodes of the pad that may touch
  std::vector<PressedPoint> facing;  // where each would meet the object
  PressProblem problem;
};

// The rigid base of the pad moves along the unit vector `direction_O` until it bears `load` > 0
// [N]. Each node meets the object's exact surface where it goes straight on; the surface is plane
// there, as far as the pad gives way, and without friction while the pad is pressed. Parts of the
// object so steep that they would be met at less than 6 degrees are left out. `X_OL` is the pose of
// the pad's link; their surfaces do not intersect. `patch` is replaced: without points where
// nothing is met.
void press_pad(const ProximityMesh& object, const Pad& pad, const Pose& X_OL,
               const Vector3& direction_O, double load, PadWorkspace& workspace, PadPatch& patch);

// The forces and torques about `center_O` with which the patch answers to small motions of the link
// from where it is, while everything sticks: 6 x 6, for [translation; rotation] along the axes of O
// [N/m, N, N m]. Symmetric.
Eigen::Matrix<double, 6, 6> patch_stiffness(const Pad& pad, const Pose& X_OL, const PadPatch& patch,
                                            const Vector3& center_O);

}  // namespace prehend
