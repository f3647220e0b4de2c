// The mass of an object whose parts have densities or masses of their own: a hammer's head, the
// motor and the battery of a drill.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sim/shape/mass_properties.h"
#include "sim/shape/primitive.h"

namespace prehend {

// A separate piece of the mesh, with the cavities in it: 0 is the one with the largest volume.
struct MeshComponent {
  int index = 0;
};

// What of the solid is in a box, a cylinder (as a prism of 32 sides with the same volume) or a
// sphere (as a polyhedron of 80 faces with the same volume), object's frame.
struct InsideShape {
  Primitive shape;
};

// What of the solid is beyond a plane, on the side to which the normal points.
struct BeyondPlane {
  Vector3 point_O = Vector3::Zero();    // m, on the plane
  Vector3 normal_O = Vector3::UnitZ();  // unit
};

// A mass in one point, in addition to what the solid weighs there. It is at most the diagonal of
// the mesh's bounds away from their middle.
struct AtPoint {
  Vector3 p_O = Vector3::Zero();  // m
};

// A part of the object. Exactly one of `density` and `mass` is stated; `mass` of an AtPoint.
struct MassPart {
  std::string name = {};  // for people; may be empty
  std::variant<MeshComponent, InsideShape, BeyondPlane, AtPoint> where = {};
  std::optional<double> density = {};  // >= 0; 0 is a void [kg/m^3]
  std::optional<double> mass = {};     // > 0 [kg]
};

// What is known of an object's mass.
struct StatedMass {
  // Of the whole [kg]. Without `density` what no part covers weighs what the parts leave of it;
  // with `density`, or where the parts cover everything, the masses of all are scaled to it.
  std::optional<double> mass = {};
  std::optional<double> density = {};  // of what no part covers, >= 0 [kg/m^3]
  std::vector<MassPart> parts = {};    // at most kMostMassParts
};

inline constexpr int kMostMassParts = 32;

// A part of the mass.
struct MassShare {
  std::string name;
  double volume = 0.0;  // 0 of a point [m^3]
  double mass = 0.0;    // kg
  Vector3 center_O = Vector3::Zero();
};

// The mass that follows.
struct MassOfParts {
  MassSource source = MassSource::signed_volume;  // of the solid that the parts are parts of
  double mass = 0.0;                              // kg
  Vector3 center_of_mass = Vector3::Zero();       // m, mesh frame
  Matrix3 inertia = Matrix3::Zero();              // about the centre of mass [kg m^2]
  std::vector<MassShare> parts;                   // as stated, in their order
  std::optional<MassShare> rest;                  // what no part covers; none: they cover all
  // What the masses of all parts and of the rest were multiplied with to come to the stated mass.
  double scale = 1.0;
};

// The integrals are exact over the solid that mass_properties finds in the mesh: it is cut by the
// planes of the regions. Of a mesh that is only taken by its convex hull, regions cut the hull.
//
// Throws InputError that names the field: for a value out of its range; a component that does not
// exist, or of a mesh that is taken by its hull; a region that meets nothing of the solid; parts of
// a mesh that encloses nothing; parts that overlap by more than 1e-6 of the solid; parts that weigh
// more than the whole; where the mass of the whole does not follow; and for mass in one point or
// along one line, which no body has.
MassOfParts mass_of_parts(const TriangleMesh& mesh, const StatedMass& stated);

// Volume and centre of each component, in their order: MeshComponent::index counts them. Empty for
// a mesh without any (MassSource convex_hull and surface). Throws InputError as mass_properties.
struct ComponentVolume {
  double volume = 0.0;  // m^3
  Vector3 center_O = Vector3::Zero();
};
std::vector<ComponentVolume> component_volumes(const TriangleMesh& mesh);

}  // namespace prehend
