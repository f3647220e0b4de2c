// Whether a world can be stepped.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "sim/motion/step_options.h"

namespace prehend {

struct World;

// The names of two solids that overlap where they are, if any do.
std::optional<std::pair<std::string, std::string>> overlap_in(const World& world,
                                                              const StepOptions& options = {});

// Throws InputError for a world that cannot be stepped: a body that moves without a positive mass
// or with an inertia that no body has, a drive with negative gains or effort, numbers that are not
// finite, options out of range.
void require_quantities(const World& world, const StepOptions& options = {});

// The same, and for solids that overlap.
void require_world(const World& world, const StepOptions& options = {});

}  // namespace prehend
