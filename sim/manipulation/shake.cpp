#include "sim/manipulation/shake.h"

#include "sim/manipulation/phase_run.h"
#include "sim/motion/require_world.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {

ShakeReport shake_grasp(const CompiledScene& scene, const std::shared_ptr<const RobotModel>& hand,
                        const GraspPosture& grasp, const TestProcedure& procedure,
                        const StepOptions& options, const RunContext& context) {
  ShakeReport report;
  report.procedure = procedure.name;
  GraspWorld start = make_grasp_world(scene, hand, grasp, procedure);
  World& world = start.world;
  StepOptions step = options;
  step.step = procedure.step;
  require_world(world, step);
  const Pose& X_WO = world.bodies[static_cast<std::size_t>(kObjectBody)].motion.X_WB;
  const PhaseSetting setting{.scene = scene,
                             .procedure = procedure,
                             .hand = start.hand,
                             .X_WO = X_WO,
                             .X_WH = hand_pose(world, start.hand),
                             .open = widest_posture(*scene.scene.hand.hand, grasp.dofs),
                             .strategy = grasp.strategy};
  if (!procedure.prepare.empty()) {
    PhaseRun prepare(std::move(world), setting, options, context, report.effort);
    report.tests.push_back(prepare.run("prepare", procedure.prepare));
    world = std::move(prepare.world());
  }
  for (const ProcedureTest& test : procedure.tests) {
    PhaseRun run(world, setting, options, context, report.effort);
    report.tests.push_back(run.run(test.name, test.phases));
  }
  return report;
}

}  // namespace prehend
