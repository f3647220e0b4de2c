// Parts of one thing that hide the places where they are joined.
#pragma once

#include "sim/shape/cloud/prepare_views.h"

namespace prehend {

// A cluster that ends above the support, though nothing stands before it, rests on something that
// it hides: the cluster that it is in front of and above, if there is one. The two are made one.
// Needs a support.
void join_floating_clusters(PreparedViews& prepared);

}  // namespace prehend
