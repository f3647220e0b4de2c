// Grasps by their contacts alone.
#pragma once

#include <vector>

#include "sim/quality/contact.h"

namespace prehend::bench {

// `count` random grasps of so many contacts on a unit sphere that hold, always the same ones.
std::vector<std::vector<Contact>> holding_grasps(int contacts, int count);

}  // namespace prehend::bench
