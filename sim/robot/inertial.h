// Mass, centre of mass and inertia of a rigid piece.
#pragma once

#include <string>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Mass properties of a rigid body, in the frame of its link.
struct Inertial {
  double mass = 0.0;                         // kg
  Vector3 center_of_mass = Vector3::Zero();  // m
  Matrix3 inertia = Matrix3::Zero();         // about the centre of mass [kg m^2]
};

// Of the solid that the mesh bounds (geometry/mass_properties.h), of even density [kg/m^3]. A flat
// mesh has mass 0. Throws InputError for a mesh without a triangle of positive area.
Inertial inertial_of_density(const TriangleMesh& mesh, double density);

// The same with the mass given [kg]; a flat mesh has it spread over its triangles.
Inertial inertial_of_mass(const TriangleMesh& mesh, double mass);

// `inertial`, given in frame B, in frame A.
Inertial transformed(const Inertial& inertial, const Pose& X_AB);

// Why no body has this inertia: "" when its moments along all axes are positive or 0, and none is
// larger than the sum of the other two (in every frame, so the principal moments decide).
std::string inertia_defect(const Matrix3& inertia);

}  // namespace prehend
