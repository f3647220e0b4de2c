// The surface of an object from a mesh file: in which unit it is read, and what is repaired.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/shape/files/mesh_file.h"

namespace prehend {

// The unit of the coordinates of a file that nobody states, from the longest side of the bounds of
// its object in these units. In metres unless that is implausible for a thing that a hand holds,
// longer than 1.5 m. Then of mm, cm and in, in this order, the first in which the object is 30 to
// 500 mm long, else the first in which it is 10 mm to 1 m: in up to 3, cm from 3 to 30, mm from 30
// to 1000. "m" where none is.
// CAD programs write mm: what they wrote, as all STL files, is in mm from 1.5 to 1000.
std::string likely_unit(double longest_side, bool of_cad = false);

// How an object's file is read.
struct ObjectMeshSource {
  std::string unit;            // as of metres_per_unit; empty: likely_unit, of glTF, COLLADA m
  bool repair = true;          // repair_mesh; else the surface is only turned outward
  bool part_surfaces = false;  // whether those of ObjectMesh::parts are wanted
  bool colors = false;         // whether ObjectMesh::colors are wanted
};

// A surface that faces outward, and what was assumed and repaired.
struct ObjectMesh {
  TriangleMesh mesh;                    // frame O [m]
  std::string unit;                     // in which the file was read
  std::vector<std::string> notes = {};  // for people, one line each
  std::vector<MeshPart> parts = {};     // that the file names
  ColoredMesh colors = {};              // of the file
};

// Throws InputError as load_mesh (mesh_file.h).
ObjectMesh load_object_mesh(const std::filesystem::path& file, const ObjectMeshSource& source);

}  // namespace prehend
