// Where a surface bounds something thin, found by rays through it: places on the edges of walls,
// and places on the middle of bars.
#pragma once

#include <vector>

#include "primitives/surface_sample.h"
#include "sim/base/run_context.h"
#include "sim/shape/proximity.h"

namespace prehend {

// What counts as thin. Lengths are in metres.
struct ThinLimits {
  double wall = 0.0;         // thickest wall
  double bar = 0.0;          // thickest bar
  double reach = 0.0;        // an edge is looked for so far from a point of the wall
  double free_ahead = 0.0;   // the way to an edge is free for at least this length
  double free_beside = 0.0;  // and so is the room on both sides of the wall
  double around = 0.0;       // rays end after this length
};

// A place on a thin part, in the frame of the mesh.
struct ThinSpot {
  Vector3 p = Vector3::Zero();       // on the edge of a wall, or in the middle of a bar
  Vector3 into = Vector3::Zero();    // unit: from the edge into the wall; along the bar, either way
  Vector3 across = Vector3::Zero();  // unit: normal of the wall, either way; zero for a bar
  double width = 0.0;                // thickness of the wall, largest size of the bar across [m]
  double depth = 0.0;                // how far the wall goes on behind its edge, at most `around`
};

struct ThinSpots {
  std::vector<ThinSpot> walls;
  std::vector<ThinSpot> bars;
};

// From each of these points of the mesh a ray goes inward: where it leaves at a surface that faces
// the other way, the length inside is the thickness there (Shapira, Shamir and Cohen-Or 2008,
// "Consistent mesh partitioning and skeletonisation using the shape diameter function", with a
// single ray). Rays from its middle, parallel to the surface, tell what else is thin there and
// where it ends. Points are visited in parallel, the spots are in their order. A mesh without an
// inside, such as a single sheet, has none. Throws Cancelled.
ThinSpots find_thin_spots(const ProximityMesh& mesh, const std::vector<SurfacePoint>& points,
                          const ThinLimits& limits, const RunContext& context);

}  // namespace prehend
