// The side from which a grasp explains itself.
#pragma once

#include <vector>

#include "planner/show/grasp_picture.h"
#include "sim/base/run_context.h"

namespace prehend {

struct TellingSideOptions {
  // Of the small pictures in which it is counted what is seen [pixels].
  int width = 160;
  int height = 128;
};

// Where a viewer may stand: unit, from what is looked at to the eye, in the world's frame, around
// the upper half of the sphere. Always the same ones.
std::vector<Vector3> viewing_directions();

// The one of them from which most is seen of the contacts' cones, from their sides: the links that
// touch count alike, however many contacts they have, and the one that is seen least counts twice;
// less of what tells is how much of each link of the hand is seen. The hand, the arm and obstacles
// hide what is behind them, the object dims it. All counts less the more of the hand is behind an
// obstacle; where obstacles hide all, they do not count.
// The first one of equals. Throws Cancelled.
Vector3 telling_side(const CompiledScene& scene, const PosedGrasp& grasp,
                     const TellingSideOptions& options = {}, const RunContext& context = {});

}  // namespace prehend
