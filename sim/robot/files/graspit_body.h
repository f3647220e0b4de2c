// Body files of GraspIt!: links, mounts, objects and obstacles.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/material.h"
#include "sim/robot/inertial.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

class XmlFile;  // sim/base/xml/xml_file.h

// A rigid body as its file describes it, in SI units.
struct GraspitBody {
  std::string name;   // of the file, without its extension
  TriangleMesh mesh;  // [m], facing outward where it is closed
  Material material = Material::wood;
  double mass = 0.0;                           // kg, 0: not said
  std::optional<Vector3> center_of_mass = {};  // m
  // About the centre of mass, by unit of mass [m^2]; empty: not said, or no body has it.
  std::optional<Matrix3> unit_inertia = {};
  // The mesh file and its unit (m, cm, mm, in), for scene files that name it. Empty where the body
  // is not exactly what is in that file.
  std::filesystem::path mesh_file = {};
  std::string unit = {};
  std::vector<std::string> notes = {};  // as in Robot
};

// The body in a file with the root element <root>: <material>, <mass> [g], <cog> [mm],
// <inertia_matrix> (nine numbers [mm^2]), <geometryFile> beside it, <geometryScaling>,
// <geometryOffset> [mm]. Materials that prehend lacks are replaced by the nearest, other elements
// are left out, both with a note. A matrix that is not symmetric is made so. Throws InputError with
// file and line for what is broken or missing.
GraspitBody load_graspit_body(const std::filesystem::path& file);
// As load_graspit_body, of a file that was parsed already.
GraspitBody read_graspit_body(const XmlFile& file);

// Mass, centre of mass and inertia: what the file says, the rest from the mesh at even density.
// Mass 0 where the file says none, or the mesh is flat and the file does not say enough.
Inertial inertial_of(const GraspitBody& body);

}  // namespace prehend
