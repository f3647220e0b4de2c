// A grasp is closed, lifted and shaken as a protocol says, and what became of it is measured.
#pragma once

#include <memory>

#include "sim/base/run_context.h"
#include "sim/manipulation/grasp_world.h"
#include "sim/manipulation/shake_report.h"
#include "sim/manipulation/test_procedure.h"
#include "sim/motion/step_options.h"

namespace prehend {

struct CompiledScene;

// Runs a protocol on a grasp, in steps of the length that the protocol says. The same grasp gives
// the same bytes. Throws InputError for a world that cannot be stepped (require_world), and
// Cancelled.
ShakeReport shake_grasp(const CompiledScene& scene, const std::shared_ptr<const RobotModel>& hand,
                        const GraspPosture& grasp, const TestProcedure& procedure,
                        const StepOptions& options = {}, const RunContext& context = {});

}  // namespace prehend
