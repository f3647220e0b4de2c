// Grasps of an object that was seen in part, tried on the other shapes that it may have.
#pragma once

#include "planner/plan/plan_options.h"
#include "planner/plan/plan_result.h"

namespace prehend {

struct CompiledScene;

// Tries the first options.rank.pool * options.rank.top grasps again, from the same pose, on an
// object with the thin and with the thick shape (Completion), and on the likely one with the hand
// moved by 3 mm, which a seen surface may be wrong, both ways along each axis of the object. Fills
// in ScoredGrasp::shapes. Its certainty is the sum over all these trials and the grasp itself of
// epsilon, of which what exceeds 0.02 counts a fifth: to hold each time is worth more than to hold
// well sometimes. It is up to 30 % less the more of the hand's way, of points of the open hand
// along its approach and of the closed one, lies in unseen space, where something may stand. The
// largest comes first, behind all that touch preferred regions only. A shape that would overlap an
// obstacle is not tried. Does nothing for an object whose surface is known. The same on any number
// of threads. Does not throw Cancelled: where time runs out the status says so, and nothing else
// changes.
void try_shapes(const CompiledScene& scene, const PlanOptions& options, const RunContext& context,
                PlanResult& result);

}  // namespace prehend
