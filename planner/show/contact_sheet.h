// One picture of several grasps side by side.
#pragma once

#include <vector>

#include "planner/show/grasp_picture.h"
#include "sim/base/run_context.h"

namespace prehend {

// Layout of the sheet.
struct ContactSheetOptions {
  int columns = 5;
  // Of the picture of one grasp; its title stands under it [pixels].
  int width = 480;
  int height = 400;
};

// Each grasp as seen from best_viewpoint(), in reading order, in cells of one size. Throws
// Cancelled.
Image contact_sheet(const CompiledScene& scene, const std::vector<PosedGrasp>& grasps,
                    const ContactSheetOptions& options = {}, const RunContext& context = {});

}  // namespace prehend
