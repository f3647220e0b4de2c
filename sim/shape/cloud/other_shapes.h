// Other shapes that a thing may have, beside the likely one.
#pragma once

#include "sim/base/run_context.h"
#include "sim/shape/cloud/find_symmetry.h"
#include "sim/shape/cloud/surface_net.h"

namespace prehend {

struct OtherShapes {
  DistanceGrid thin;
  DistanceGrid thick;
};

// The likely shape with its unseen surface moved in, and out as far as the views allow: the farther
// from what was seen, the more, up to what the symmetry leaves uncertain.
OtherShapes other_shapes(const DistanceGrid& likely, const std::vector<ObjectView>& views,
                         const std::vector<SeenPoint>& points, const FoundSymmetry& symmetry,
                         bool on_support, const RunContext& context);

}  // namespace prehend
