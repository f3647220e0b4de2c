// One picture of several grasps side by side.
#pragma once

#include <vector>

#include "planner/show/picture/image.h"
#include "sim/base/run_context.h"

namespace prehend {

struct CompiledScene;
struct PosedGrasp;

// Each grasp as seen from best_viewpoint(), in reading order, `columns` to a row, in pictures of
// one size with their titles under them. Throws Cancelled.
Image contact_sheet(const CompiledScene& scene, const std::vector<PosedGrasp>& grasps,
                    int columns = 5, const PictureSize& size = {480, 400},
                    const RunContext& context = {});

}  // namespace prehend
