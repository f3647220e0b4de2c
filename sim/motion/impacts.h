// Impacts of bodies that bounce, in no time.
#pragma once

#include "sim/motion/step_options.h"
#include "sim/motion/world.h"

namespace prehend {

// Changes the velocities of bodies that meet within a step of `time` and bounce off each other, by
// Newton's law with Coulomb's friction. Impacts travel: what one sets in motion may meet the next
// body, which bounces in turn, as in Newton's cradle; contacts that nothing closes yet do not take
// part. Contacts with links of robots bounce within the step instead. Returns whether any body was
// hit. Contacts are those of the world's memory.
bool resolve_impacts(World& world, double time, const StepOptions& options);

}  // namespace prehend
