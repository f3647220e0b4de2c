// A scene: the object to grasp, the hand, what carries it, obstacles, and friction.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sim/robot/platform.h"
#include "sim/scene/friction_table.h"
#include "sim/scene/surface_material.h"
#include "sim/scene/surface_region.h"
#include "sim/shape/mass_parts.h"
#include "sim/shape/mass_properties.h"
#include "sim/shape/primitive.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

class UnseenSpace;  // sim/shape/cloud/unseen_space.h

// A surface from a mesh file.
struct MeshFileSource {
  std::string path;    // absolute
  std::string unit;    // m, cm, mm or in
  bool repair = true;  // of an object: as load_object_mesh does it
};

// A surface from generate_object.
struct GeneratedSource {
  std::string name;
  int triangles = 0;
};

// A surface made of shapes listed in the scene file. The list is kept as its JSON text, because
// only the writer of scene files needs it again.
struct WrittenShapesSource {
  std::string geometry;  // the list in the field "geometry"
};

// A surface that depth cameras saw, with what was completed of it.
struct ViewsSource {
  std::string path;  // absolute
  std::string unit;  // of a cloud that is given by itself: m, cm, mm or in
};

// Where a body's surface comes from, so that a scene file can name the source instead of listing
// the triangles. std::monostate: the mesh was made by a program and its triangles are written, as
// those of views are, whose bodies have no names of their own.
using ShapeSource =
    std::variant<std::monostate, MeshFileSource, GeneratedSource, WrittenShapesSource, ViewsSource>;

// An obstacle: a body that does not move.
struct StaticBody {
  std::string name;
  TriangleMesh mesh;  // body frame
  Pose X_WB = Pose::Identity();
  Material material = Material::wood;
  ShapeSource source = {};
  double restitution = 0.0;  // 0 to 1: of the velocity of an impact; of a pair, the larger counts
  std::vector<MaterialRegion> surfaces = {};  // of another material, body frame; the last counts
  double apart = 0.0;  // how far the hand keeps from it [m]; 0: fingers that close may end at it
};

// How the mass of an object is spread.
enum class MassBasis {
  uniform,    // taken as uniform: nothing is known but the shape
  center,     // the centre of mass is stated
  parts,      // parts of it have densities or masses of their own
  materials,  // its file names what its pieces are made of (named_mass.h)
};

// Of an object that depth cameras saw (sim/shape/cloud): what of its surface is a guess.
struct Completion {
  std::vector<char> seen;  // of each triangle of the mesh: whether a camera saw it; else completed
  // The least and the most that it may be, closed, frame O; empty where nothing is known of that.
  TriangleMesh thin = {};
  TriangleMesh thick = {};
  // Around the object where it was seen, frame W; null where nothing is known of that.
  std::shared_ptr<const UnseenSpace> unseen = {};
};

// The body to grasp. Mass, centre of mass and inertia belong together: state_center_of_mass and
// state_mass (object_mass.h) change them.
struct GraspableBody {
  std::string name;
  TriangleMesh mesh;  // frame O
  Pose X_WO = Pose::Identity();
  Material material = Material::plastic;
  double mass = 0.0;                         // kg
  Vector3 center_of_mass = Vector3::Zero();  // frame O
  Matrix3 inertia = Matrix3::Zero();         // about the centre of mass, axes of O [kg m^2]
  MassSource mass_source = MassSource::signed_volume;
  MassBasis mass_basis = MassBasis::uniform;
  std::optional<StatedMass> stated_mass = {};  // of parts and materials
  ShapeSource source = {};
  double restitution = 0.0;  // as of a StaticBody
  std::optional<Completion> completion = {};
  std::vector<MaterialRegion> surfaces = {};  // as of a StaticBody
};

// Parts of a link of the hand that are not of the link's material, its frame; none is a part of a
// mesh file.
struct LinkSurfaces {
  std::string link;
  std::vector<MaterialRegion> surfaces;
};

// The platform that carries the hand to the object: an arm, perhaps on a mobile base.
struct Carrier {
  Platform platform;   // limits as the scene narrows them
  std::string source;  // a name of the library, or an absolute path
  int hand = 0;        // index of the robot that is the hand; Scene::hand is a copy of it
  Pose X_WB = Pose::Identity();
  std::vector<double> start;  // of each degree of freedom of the assembled platform [rad or m]
};

// What to grasp, with what, and among what.
struct Scene {
  std::string name;
  GraspableBody object;
  Robot hand;
  std::string hand_source;  // a name of the library, or an absolute path; empty: the carrier's own
  std::optional<Carrier> carrier;  // without one the hand flies free
  std::vector<StaticBody> obstacles;
  FrictionTable friction;  // static
  KineticFriction kinetic_friction = {};
  CompliantDepths compliant_depths;
  FrictionDeviations friction_deviations = {};
  std::vector<LinkSurfaces> link_surfaces = {};  // of the hand
  std::vector<Primitive> primitives;  // of the object, frame O; empty: found from the mesh
  // Of the object: a grasp that touches the one is none, one that touches only the other comes
  // first.
  std::vector<SurfaceRegion> keep_out = {};
  std::vector<SurfaceRegion> preferred = {};
  std::vector<SurfaceRegion> porous =
      {};  // through which air leaks: suction cups do not seal there
  // What was assumed about the scene and its object, left out or repaired, for people: one line
  // each. Those of robots are with them.
  std::vector<std::string> notes = {};
};

// The mass of an object whose scene states none [kg]: that of a household object.
inline constexpr double kDefaultObjectMass = 0.3;

// Clears what is said of the surface of the object, which is to be another one: primitives,
// regions, materials of parts and what was seen of it.
void forget_surface(Scene& scene);

// Of an object from a mesh file that is not as large as things that hands hold (10 mm to 1 m), the
// unit in which it would be: " (100 mm if its unit were m)". Empty for others, and where no unit
// helps.
std::string unit_hint(const GraspableBody& object);

// A body at the identity with the mesh's centre of mass and inertia at `mass` kg (> 0).
GraspableBody make_graspable(std::string name, TriangleMesh mesh, Material material,
                             double mass = kDefaultObjectMass);

}  // namespace prehend
