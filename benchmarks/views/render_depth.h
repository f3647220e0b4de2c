// Depth images of things on a table, as a structured-light camera would take them.
#pragma once

#include <vector>

#include "sim/base/random.h"
#include "sim/shape/cloud/depth_view.h"
#include "sim/shape/proximity.h"

namespace prehend::bench {

// A thing of the scene, with its tree built.
struct ShownThing {
  const ProximityMesh* mesh;
  Pose X_WO = Pose::Identity();
};

struct CameraNoise {
  bool noisy = true;       // else depths are exact
  double factor = 1.0;     // of the deviation
  double quantum = 0.001;  // depths are multiples of it [m]
};

// What the camera sees of the things and of a square table at z = 0, `half_table` [m] to each side
// of the origin (0: there is none). Deviation of depths: 1.2 mm + 1.9 mm/m^2 (z - 0.4 m)^2 (Nguyen,
// Izadi and Lovell 2012); no reading at surfaces steeper than 80 degrees against the ray; at edges
// depths are taken from a pixel beside, as the matching of patterns blurs them.
DepthView render_depth(const DepthCamera& camera, const std::vector<ShownThing>& things,
                       double half_table, const CameraNoise& noise, Random& random);

}  // namespace prehend::bench
