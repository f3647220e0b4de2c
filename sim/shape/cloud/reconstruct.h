// From depth images to bodies: the plane on which things stand, the things, and what their unseen
// sides may be.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/named_enum.h"
#include "sim/base/run_context.h"
#include "sim/shape/cloud/depth_view.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// How views are turned into bodies. Each step can be switched off.
struct ReconstructOptions {
  double voxel = 0.003;       // edge of the grid [m]
  bool drop_outliers = true;  // readings without others near them
  bool find_plane = true;     // else nothing is taken for a support
  bool use_symmetry = true;   // else unseen sides are taken from the seen widths alone
  double gap = 0.012;         // things that are nearer to each other are one [m]
  int min_readings = 60;      // things that fewer pixels saw are left out
  std::uint64_t seed = 1;
};

// What the unseen side of an object was taken from. Other objects stand on other evidence: those of
// a revolution are nearly certain, those of `none` a guess.
enum class Symmetry {
  none,         // widths of what was seen
  mirror,       // one plane, upright on the support
  two_mirrors,  // two such planes, at right angles
  revolution    // an axis
};

constexpr auto enum_names(Symmetry /*of*/) {
  return std::to_array<std::string_view>({"none", "mirror", "two_mirrors", "revolution"});
}

// The plane on which things stand.
struct SupportPlane {
  Vector3 normal_W = Vector3::UnitZ();  // unit; towards the cameras
  double height = 0.0;                  // z of the world below the things [m]
  double tilt = 0.0;                    // angle between the normal and z of the world [rad]
  std::vector<Vector3> outline_W = {};  // corners of the part that was seen, counter-clockwise
};

// A thing that stands apart from others. Meshes are closed, in frame W, and contain what was seen.
struct SeenObject {
  TriangleMesh mesh;       // the likely shape
  std::vector<char> seen;  // of each triangle of `mesh`: whether a camera saw it; else completed
  TriangleMesh thin;       // the least and the most that the views allow, within reason
  TriangleMesh thick;
  std::size_t readings = 0;  // pixels that saw it
  Symmetry symmetry = Symmetry::none;
};

struct Reconstruction {
  std::optional<SupportPlane> plane = {};
  std::vector<SeenObject> objects = {};  // those with the most readings first
  std::vector<std::string> notes = {};   // what was assumed or left out, for people
};

// The same result on any number of threads. Throws InputError where no object is left (no reading,
// a plane only), Cancelled as all long calls.
Reconstruction reconstruct(const std::vector<DepthView>& views,
                           const ReconstructOptions& options = {}, const RunContext& context = {});

}  // namespace prehend
