// Buffers of epsilon_l1, to allocate less when it is asked often.
#pragma once

#include "sim/quality/expanding_polytope.h"
#include "sim/quality/support.h"

namespace prehend {

// One for each thread. What is in them is of no meaning between calls.
struct EpsilonWorkspace {
  ColumnSupport set;
  ExpandingPolytope polytope;
};

}  // namespace prehend
