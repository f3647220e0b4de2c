// The parts of a robot file that place and shape solids: units, poses, geometry.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "sim/base/json/json_field.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Factors from the units of a file to SI.
struct FileUnits {
  double length = 1.0;            // m
  double angle = 1.0;             // rad
  double angular_velocity = 1.0;  // rad/s
  double mass = 1.0;              // kg
};

// `root` is the robot; its field "units" may be missing: metres, radians, radians a second,
// kilograms.
FileUnits read_units(const JsonField& root);

// A list of steps, each {"translate": [x, y, z]}, {"rotate_x" | "rotate_y" | "rotate_z": angle} or
// {"rotation": three rows of three numbers}, multiplied left to right.
Pose read_pose(const JsonField& steps, const FileUnits& units);

// How many triangles a file may still make of shapes: one sphere of some fifty bytes can become
// 20,000, so that a small file could fill the memory. Both throw InputError for the field where
// more than 50,000 are spent.
class ShapeBudget {
 public:
  // On a shape that the field describes. The 12 of a box are free: they take little more memory
  // than the text that asks for it.
  void spend_on_shape(const JsonField& field, std::size_t triangles);
  // On shapes that the field takes from elsewhere by their name.
  void spend(const JsonField& field, std::size_t triangles);
  // Triangles of all shapes that were described, the free ones too.
  std::size_t made() const { return made_; }

 private:
  std::size_t spent_ = 0;
  std::size_t made_ = 0;
};

// A geometry to be used by several links, and what each use of it spends of the budget.
struct Geometry {
  TriangleMesh mesh;
  std::size_t of_shapes = 0;
};
using NamedGeometry = std::map<std::string, Geometry>;

// A name in `named`, or a list of shapes and mesh files. Never empty. The budget is that of the
// whole file; triangles that a file lists itself, and those of mesh files, cost nothing.
TriangleMesh read_geometry(const JsonField& field, const FileUnits& units,
                           const NamedGeometry& named, ShapeBudget& budget);

}  // namespace prehend
