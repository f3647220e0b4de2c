// Changes of a scene, as a person makes them one by one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planner/live/open_folders.h"
#include "sim/scene/scene.h"
#include "sim/shape/files/mesh_file.h"

namespace prehend {

// Where the surface of a new body comes from. Exactly one of scene, generate, mesh and mesh_text is
// stated.
struct SurfaceOrder {
  std::string scene = {};      // a scene of the library: its object
  std::string generate = {};   // a name of generate_object
  int triangles = 5000;        // of generate
  std::string mesh = {};       // a mesh file in an open folder
  std::string mesh_text = {};  // the content of a mesh file
  std::string format = {};     // of mesh_text: obj, stl, ply, off, dae, iv or wrl
  // Of mesh and mesh_text: m, cm, mm or in. Empty: of an object the likely one (likely_unit).
  std::string unit = {};
};

// A body without a name: its surface, outward and repaired, and what the scene file will say of it.
struct BodySurface {
  TriangleMesh mesh;
  ShapeSource source;
  std::string name;                  // a name to call it by, where nobody gives one
  std::vector<MeshPart> parts = {};  // that its file names
};

// Throws InputError that names the field of the order.
BodySurface surface_of(const SurfaceOrder& order, const OpenFolders& folders);

// A scene of the hand alone. Throws InputError for a hand that is not found.
Scene scene_of_hand(const std::string& hand);

// A library scene by name, or a scene, world or mesh file in an open folder. Throws InputError.
Scene open_scene(const std::string& name_or_file, const OpenFolders& folders);
// The text of a scene file. Relative names in it stand for files of the working folder, which has
// to be open. Throws InputError.
Scene scene_of_text(const std::string& text, const OpenFolders& folders);

// What is stated of an object besides its surface; what is not stays as it is (of a new object:
// plastic, kDefaultObjectMass, at the origin).
struct BodyOrder {
  std::string name = {};
  std::optional<Material> material = {};
  std::optional<double> mass = {};  // kg, > 0; the density is then uniform
  std::optional<Pose> X_WB = {};
};

// Replaces the object, and forgets the primitives of the earlier one.
void set_object(Scene& scene, BodySurface surface, const BodyOrder& order);
// Throws InputError without an object.
void change_object(Scene& scene, const BodyOrder& order);
// Throws InputError without an object.
void remove_object(Scene& scene);

// Throws InputError for a name that another obstacle has.
void add_obstacle(Scene& scene, BodySurface surface, const BodyOrder& order);
// `order.name` is the new name. Throws InputError of the field "name" for a name that no obstacle
// has, and for a new one that another has.
void change_obstacle(Scene& scene, const std::string& name, const BodyOrder& order);
void remove_obstacle(Scene& scene, const std::string& name);

// Static friction of the object with a material, or where none is named with all
// (object_friction.h). Throws as checked_friction, and InputError without an object.
void change_friction(Scene& scene, std::optional<Material> material, double friction);

// The hand flies free from then on.
void choose_hand(Scene& scene, const std::string& hand);

}  // namespace prehend
