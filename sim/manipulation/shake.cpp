#include "sim/manipulation/shake.h"

#include "sim/manipulation/phase_run.h"

namespace prehend {

ShakeReport shake_grasp(const CompiledScene& scene, const std::shared_ptr<const RobotModel>& hand,
                        const GraspPosture& grasp, const Protocol& protocol,
                        const ShakeOptions& options, const RunContext& context) {
  ShakeReport report;
  report.protocol = protocol.name;
  GraspWorld start = make_grasp_world(scene, hand, grasp, protocol);
  World& world = start.world;
  StepOptions step = options.step;
  step.step = protocol.step;
  require_world(world, step);
  const Pose& X_WO = world.bodies[static_cast<std::size_t>(kObjectBody)].motion.X_WB;
  const PhaseSetting setting{.scene = scene,
                             .protocol = protocol,
                             .hand = start.hand,
                             .X_WO = X_WO,
                             .X_WH = hand_pose(world, start.hand),
                             .open = widest_posture(*scene.scene.hand.hand, grasp.dofs)};
  if (!protocol.prepare.empty()) {
    PhaseRun prepare(std::move(world), setting, options.step, context, report.effort);
    report.tests.push_back(prepare.run("prepare", protocol.prepare));
    world = std::move(prepare.world());
  }
  for (const ProtocolTest& test : protocol.tests) {
    PhaseRun run(world, setting, options.step, context, report.effort);
    report.tests.push_back(run.run(test.name, test.phases));
  }
  return report;
}

}  // namespace prehend
