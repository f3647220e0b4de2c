// Which forces and torques a contact patch bears before it slides.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "sim/base/pose.h"

namespace prehend {

// A point of a patch and the normal force that it bears.
struct PressedPoint {
  Vector3 position = Vector3::Zero();  // [m]
  Vector3 normal = Vector3::UnitZ();   // unit, into the object
  double force = 0.0;                  // >= 0 [N]
};

// The resultant of the pressure of a patch, and its limit surface: the forces in the tangent plane
// and torques about the normal, as parts of friction times the normal force, beyond which the whole
// patch slides. With Coulomb friction at every point these are the loads of all rigid motions of
// the patch (Goyal, Ruina and Papadopoulos, "Planar sliding with dry friction", 1991).
struct LimitSurface {
  Vector3 center = Vector3::Zero();  // of pressure [m]
  Vector3 normal = Vector3::UnitZ();
  double load = 0.0;  // resultant of the normal forces along `normal` [N]
  // Largest torque about the normal through the centre, over friction and load [m].
  double torsion = 0.0;
  // Of the ellipsoid with the half-axes 1, 1 and `fitted_torsion` that lies nearest to the surface:
  // the relation of torsion and tangential force that quality measures use.
  double fitted_torsion = 0.0;
  // Farthest that the surface lies from that ellipsoid, as a part of it.
  double error = 0.0;
};

// `points` with a positive force in total. Source of the fit: Howe and Cutkosky, "Practical
// force-motion models for sliding manipulation", 1996.
LimitSurface limit_surface(std::span<const PressedPoint> points);

// A load on the limit surface for a motion of the patch: tangential force over friction and load,
// in the axes any_orthogonal(normal) and normal x that, and torque over friction and load [m].
struct LimitLoad {
  Eigen::Vector2d force = Eigen::Vector2d::Zero();
  double torque = 0.0;
};

// Loads of `count` x `count` motions, all signs of turning and all directions.
std::vector<LimitLoad> limit_loads(std::span<const PressedPoint> points,
                                   const LimitSurface& surface, int count);

}  // namespace prehend
