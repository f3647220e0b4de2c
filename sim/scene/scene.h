// What a question is about: an object to grasp, a hand, the things around them, friction.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/geometry/mass_properties.h"
#include "sim/geometry/primitive.h"
#include "sim/geometry/triangle_mesh.h"
#include "sim/robot/platform.h"
#include "sim/scene/material.h"

namespace prehend {

// What a file says of a body's surface, so that it can be said again: an object with "mesh" (an
// absolute path) and "unit", or "generate" and "triangles", or "geometry"; as JSON. Empty: made by
// a program, or from a file whose path is not UTF-8, which JSON cannot name.
using ShapeSource = std::string;

// A body that does not move: it can be touched and stands in the way.
struct StaticBody {
  std::string name;
  TriangleMesh mesh;  // body frame
  Pose X_WB = Pose::Identity();
  Material material = Material::wood;
  ShapeSource source = {};
};

// The body to grasp.
struct GraspableBody {
  std::string name;
  TriangleMesh mesh;  // frame O
  Pose X_WO = Pose::Identity();
  Material material = Material::plastic;
  double mass = 0.0;                         // kg
  Vector3 center_of_mass = Vector3::Zero();  // frame O
  Matrix3 inertia = Matrix3::Zero();         // about the centre of mass, axes of O [kg m^2]
  MassSource mass_source = MassSource::signed_volume;
  ShapeSource source = {};
};

// What carries the hand to the object.
struct Carrier {
  Platform platform;   // limits as the scene narrows them
  std::string source;  // a name of the library, or an absolute path
  int hand = 0;        // which of its robots grasps; the scene's hand is a copy of that one
  Pose X_WB = Pose::Identity();
  std::vector<double> start;  // of each degree of freedom of the assembled platform [rad or m]
};

struct Scene {
  std::string name;
  GraspableBody object;
  Robot hand;
  std::string hand_source;  // a name of the library, or an absolute path; empty: the carrier's own
  std::optional<Carrier> carrier;  // without one the hand flies free
  std::vector<StaticBody> obstacles;
  FrictionTable friction;
  CompliantDepths compliant_depths;
  std::vector<Primitive> primitives;  // of the object, frame O; empty: found from the mesh
};

// The mass of an object whose scene does not say: a household object, not a block of solid matter.
inline constexpr double kDefaultObjectMass = 0.3;

// A body at the identity with the mesh's centre of mass and inertia at `mass` kg (> 0).
GraspableBody make_graspable(std::string name, TriangleMesh mesh, Material material,
                             double mass = kDefaultObjectMass);

}  // namespace prehend
