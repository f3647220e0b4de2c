// Epsilon for callers who ask often: in buffers that they keep.
#pragma once

#include "sim/quality/epsilon.h"
#include "sim/quality/expanding_polytope.h"
#include "sim/quality/support.h"

namespace prehend {

// Buffers of epsilon_l1, to allocate less; one for each thread.
struct EpsilonWorkspace {
  ColumnSupport set;
  ExpandingPolytope polytope;
};

// As epsilon_l1 in epsilon.h. Once the buffers have grown it allocates only for wrenches whose size
// has to be scaled, and where rounding stalls the search and the full hull has to help.
EpsilonBracket epsilon_l1(const Eigen::Ref<const Wrenches>& wrenches, const EpsilonOptions& options,
                          EpsilonWorkspace& workspace);

}  // namespace prehend
