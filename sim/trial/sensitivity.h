// How much the quality of a grasp depends on what is below the accuracy of any robot and any file.
#pragma once

#include "sim/base/run_context.h"
#include "sim/quality/interval.h"

namespace prehend {

struct CompiledScene;
struct Trial;
struct TrialOptions;

// The least and the largest epsilon among the grasp and its neighbours: the hand, with the joints
// as they are, shifted along and turned about each of its axes, both ways, by next to nothing, and
// the contacts found with a threshold a little larger or smaller. Where the interval is wide,
// epsilon rests on a contact whose gap is close to the threshold, or on which corners of a flat
// contact count as equally near: the grasp is on the border between two sets of contacts. `trial`
// must be stable and of `scene`; its epsilon is in the interval. Throws Cancelled.
Interval epsilon_nearby(const CompiledScene& scene, const Trial& trial, const TrialOptions& options,
                        const RunContext& context = {});

}  // namespace prehend
