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
#include "sim/base/settings.h"
#include "sim/shape/cloud/depth_view.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

struct ReconstructOptions {
  static constexpr AboutSettings kAbout{"ReconstructOptions",
                                        "How views of depth cameras are turned into bodies. Each "
                                        "step can be switched off."};
  double voxel = 0.003;
  bool drop_outliers = true;
  bool find_plane = true;
  bool use_symmetry = true;
  double gap = 0.012;
  int min_readings = 60;
  std::uint64_t seed = 1;
};

template <SettingsOf<ReconstructOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [voxel, drop_outliers, find_plane, use_symmetry, gap, min_readings, seed] = options;
  constexpr Range kEdge{.lower = 5e-4, .upper = 0.05};
  visit("voxel", voxel, kEdge, "m", "Edge of the grid.");
  visit({"drop_outliers", "outliers"}, drop_outliers,
        "Whether readings without others near them are left out.");
  visit({"find_plane", "plane"}, find_plane,
        "Whether the plane on which things stand is found; else nothing is taken for a support.");
  visit({"use_symmetry", "symmetry"}, use_symmetry,
        "Whether unseen sides are completed by symmetry; else from the seen widths alone.");
  visit("gap", gap, kLengthAbove0, "m", "Things that are nearer to each other are one.");
  visit("min_readings", min_readings, kCountAbove0, "",
        "Things that fewer pixels saw are left out.");
  visit.unlisted("seed", seed, kAtLeast0, "", "Of what is tried at random.");
}

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
// a plane only) and for settings out of range, Cancelled as all long calls.
Reconstruction reconstruct(const std::vector<DepthView>& views,
                           const ReconstructOptions& options = {}, const RunContext& context = {});

}  // namespace prehend
