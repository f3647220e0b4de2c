// Where a robot starts whose file does not say it.
#pragma once

#include "sim/robot/platform.h"

namespace prehend {

// Of a platform in which links collide where its joints start: pairs of links that meet in nearly
// all postures, as neighbours do whose geometry overlaps, are exempted; where others meet, the
// joints that carry the hand start in the middle of their limits or, where that is not free either,
// somewhere else that is. Both are noted. Where nothing is free, the start stays as it is. The same
// platform always gets the same start.
void find_free_start(Platform& platform);

}  // namespace prehend
