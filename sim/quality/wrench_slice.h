// A three-dimensional section of a wrench space: what it looks like with three coordinates fixed.
#pragma once

#include <array>
#include <string_view>

#include <Eigen/Core>

namespace prehend {

struct PointHull;

// Names of the coordinates 0 to 5: the force's x, y, z and the scaled torque's.
inline constexpr std::array<std::string_view, 6> kWrenchCoordinates = {"fx", "fy", "fz",
                                                                       "tx", "ty", "tz"};

struct FixedCoordinates {
  std::array<int, 3> coordinates = {3, 4, 5};  // which, all different: here the torque
  Eigen::Vector3d values = Eigen::Vector3d::Zero();
};

// A convex polyhedron in the three other coordinates, in their order; empty where the section is
// empty or flat.
struct WrenchSlice {
  std::array<int, 3> coordinates = {0, 1, 2};  // of the axes
  Eigen::Matrix3Xd vertices;
  Eigen::Matrix3Xi triangles;  // counter-clockwise from outside
  double volume = 0.0;         // 0 or infinite where no double is as small or large

  bool empty() const { return triangles.cols() == 0; }
};

// The section of a solid hull in six dimensions (wrench_space, then set_hull): its facets cut by
// the fixed coordinates are half-spaces, which are intersected. Source: Miller and Allen 2004,
// "Visualizing the Grasp Wrench Space". Throws InputError for a hull that is not solid
// in six dimensions, coordinates that are not three different ones of the six, or values that are
// not finite.
WrenchSlice wrench_slice(const PointHull& hull, const FixedCoordinates& fixed = {});

// The two sections to look at first.
struct WrenchSections {
  WrenchSlice forces;   // without torque
  WrenchSlice torques;  // without force
};

// Both empty where the hull is not solid. Throws as wrench_slice.
WrenchSections wrench_sections(const PointHull& hull);

}  // namespace prehend
