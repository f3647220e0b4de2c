// Which solids of a world may meet within a step, and where they are in contact.
#pragma once

#include "sim/motion/solids.h"
#include "sim/motion/step_options.h"

namespace prehend {

// The longest step in which nothing can come from beyond the range of contacts to penetration.
// Brings the memory of the world up to its present poses: afterwards it holds the pairs that are
// near each other, with their contacts. `speeds`: of the world after a first try of the step, where
// that showed that it will be faster than it is; null: none. `time`: the step that is wanted.
double find_near(const Solids& solids, const Solids* speeds, const World& world, double time,
                 const StepOptions& options, ContactMemory& memory);

// Whether a pair beyond contact could have met on the way: it came closer by more than was known
// to be free.
bool may_have_met(const Solids& after, const ContactMemory& memory);

// The most by which the gap of a pair may have changed since it was last looked at [m].
double moved_since(const PairMemory& pair, const Solids& solids);

}  // namespace prehend
