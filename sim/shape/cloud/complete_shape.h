// The body of a thing: what was seen of it, and what its unseen sides may be.
#pragma once

#include "sim/base/run_context.h"
#include "sim/shape/cloud/find_symmetry.h"
#include "sim/shape/cloud/surface_net.h"

namespace prehend {

struct CompletionOptions {
  double voxel = 0.003;    // [m]
  bool on_support = true;  // the body ends at z = 0, and goes down to it below what was seen
  // How much is assumed behind a surface whose back nothing tells of: less for the least body that
  // is plausible, more for the largest.
  double depth_factor = 1.0;
};

// Signed distances from the body, near its surface, in frame P.
//
// Each view, and each image of it under the symmetry, allows the body to be where it did not see
// through; the body is what all allow. Where several see the same surface, their distances are
// averaged (Curless and Levoy 1996). Of what no view says anything, that is taken which is below a
// seen surface, on a support, or behind one by about as much as it is wide there. Parts that the
// symmetry does not take in are as they were seen, and so thick.
DistanceGrid complete_shape(const std::vector<ObjectView>& views,
                            const std::vector<SeenPoint>& points, const FoundSymmetry& symmetry,
                            const SymmetryOptions& judged, const CompletionOptions& options,
                            const RunContext& context);

}  // namespace prehend
