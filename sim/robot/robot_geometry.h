// The parts of a robot file that place and shape solids: units, poses, geometry.
#pragma once

#include <map>
#include <string>

#include "sim/geometry/triangle_mesh.h"
#include "sim/json/json_field.h"

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

// A list of steps, each {"translate": [x, y, z]} or {"rotate_x" | "rotate_y" | "rotate_z": angle},
// multiplied left to right.
Pose read_pose(const JsonField& steps, const FileUnits& units);

// Named geometries of a file, to be used by several links.
using NamedGeometry = std::map<std::string, TriangleMesh>;

// A name in `named`, or a list of shapes and mesh files. Never empty.
TriangleMesh read_geometry(const JsonField& field, const FileUnits& units,
                           const NamedGeometry& named);

}  // namespace prehend
