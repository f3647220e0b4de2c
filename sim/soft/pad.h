// A layer of elastic material on a link that gives way where it presses on an object.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim/base/run_context.h"
#include "sim/base/settings.h"
#include "sim/shape/proximity_mesh.h"
#include "sim/soft/hex_mesh.h"
#include "sim/soft/pad_shape.h"

namespace prehend {

struct PadOptions {
  static constexpr AboutSettings kAbout{"PadOptions", "How pads are divided into elements."};
  double spacing = 1e-3;
  int most_nodes = 300;
  int layers = 3;
  double steepest = 1.0;

  friend bool operator==(const PadOptions&, const PadOptions&) = default;
};

template <SettingsOf<PadOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [spacing, most_nodes, layers, steepest] = options;
  visit("spacing", spacing, kLengthAbove0, "m",
        "Between nodes of a pad's surface, unless these are too many.");
  visit("most_nodes", most_nodes, Range{.lower = 4.0, .upper = 5000.0}, "",
        "Of a pad's surface. Memory grows with the square.");
  visit("layers", layers, Range{.lower = 1.0, .upper = 20.0}, "",
        "Of elements over the thickness.");
  visit("steepest", steepest, Range{.upper = 1.2}, "rad",
        "A pad covers what faces outward within this angle.");
}

// A pad, ready to be pressed. Nodes are those of its outer surface, n of them.
struct Pad {
  std::vector<Vector3> nodes_L;    // on the surface of the link [m]
  std::vector<Vector3> normals_L;  // unit, outward
  std::vector<double> areas;       // of the surface that belongs to each [m^2]
  Vector3 outward_L = Vector3::UnitZ();
  double thickness = 0.0;
  // 3n x 3n: displacements of the nodes by forces on them, along the axes of L [m/N].
  Eigen::MatrixXd compliance;
};

// The elements of a pad: a grid over the part of the link's surface that faces outward, the nodes
// of its outer surface first, and below each of them `layers` more along the surface's normal, the
// last of which are bonded to the link.
struct PadMesh {
  HexMesh mesh;
  int surface_nodes = 0;
  std::vector<Vector3> normals_L;  // of the surface nodes
  std::vector<double> areas;       // of the surface that belongs to each of them [m^2]
};
PadMesh pad_mesh(const ProximityMesh& link, const PadShape& shape, const PadOptions& options);

// Throws as make_pad where the pad cannot be made, in a small part of its time.
void check_pad(const ProximityMesh& link, const PadShape& shape, const PadOptions& options);

// Divides the pad and condenses its stiffness onto the outer surface. Throws InputError where
// nothing faces outward, where the link is thinner than the pad, where the surface is so curved
// that elements would be folded, and for a material out of range; Cancelled.
Pad make_pad(const ProximityMesh& link, const PadShape& shape, const PadOptions& options,
             const RunContext& context = {});

}  // namespace prehend
