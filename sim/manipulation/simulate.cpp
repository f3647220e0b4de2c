#include "sim/manipulation/simulate.h"

#include <algorithm>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/joined.h"
#include "sim/manipulation/phase_run.h"
#include "sim/motion/require_world.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/reach/reach.h"
#include "sim/trial/approach_line.h"
#include "sim/trial/candidate.h"
#include "sim/trial/trial.h"

namespace prehend {
namespace {

GraspWorld world_of(const CompiledScene& scene, const SimulationStart& start,
                    const TestProcedure& procedure) {
  if (start.platform_dofs.empty()) {
    return make_grasp_world(scene, hand_model(scene), start.hand, procedure);
  }
  GraspWorld made{make_scene_world(scene, procedure.on_support), {}};
  const std::shared_ptr<const RobotModel> platform = platform_model(scene);
  follow_test_procedure(scene, *platform, procedure, made.world);
  made.hand = add_platform(made.world, scene, platform, start.platform_dofs, start.platform_joints);
  WorldRobot& robot = made.world.robots[index(made.hand.robot)];
  const std::vector<Drive> arm = arm_drives(robot, made.hand);
  robot.drives.insert(robot.drives.begin(), arm.begin(), arm.end());
  return made;
}

const ProcedureTest& test_of(const TestProcedure& procedure, const std::string& name) {
  if (name.empty()) return procedure.tests.front();
  const auto found = std::find_if(procedure.tests.begin(), procedure.tests.end(),
                                  [&](const ProcedureTest& test) { return test.name == name; });
  if (found != procedure.tests.end()) return *found;
  const std::string known = joined(procedure.tests, ", ", &ProcedureTest::name);
  throw InputError({.field = "test",
                    .problem = "no such test in protocol " + procedure.name + " (" + known + ")",
                    .value = name});
}

std::vector<ProcedurePhase> approach_phases(double distance, double speed) {
  if (!(distance > 0.0)) return {};
  // From rest to rest the largest speed is 15/8 of the mean.
  constexpr double kPeak = 1.875;
  return {
      {.kind = PhaseKind::approach, .duration = kPeak * distance / speed, .distance = distance}};
}

class SimulationRun {
 public:
  SimulationRun(const CompiledScene& scene, const TestProcedure& procedure,
                const SimulateOptions& options, GraspWorld made, const ClosingStrategy& strategy,
                const RunContext& context)
      : options_(options),
        context_(context),
        recorder_(options.every),
        watch_(made.world, made.hand),
        world_(made.world),
        setting_{.scene = scene,
                 .procedure = procedure,
                 .hand = made.hand,
                 .X_WO = world_.bodies[index(kObjectBody)].motion.X_WB,
                 .X_WH = hand_pose(world_, made.hand),
                 .open = widest_posture(*scene.scene.hand.hand, hand_dofs(world_, made.hand)),
                 .strategy = strategy} {
    setting_.watcher = [this](double time, const World& world) {
      watch_.look(world, before_ + time);
      recorder_.look(world, before_ + time);
    };
    simulation_.procedure = procedure.name;
    simulation_.hand = made.hand;
    simulation_.start = std::move(made.world);
    recorder_.keep(world_, 0.0);
  }

  // False where a phase failed: what follows makes no sense then.
  bool run(const std::string& name, const std::vector<ProcedurePhase>& phases) {
    if (phases.empty()) return true;
    PhaseRun run(std::move(world_), setting_, options_.step, context_, simulation_.effort);
    ShakeTestReport report = run.run(name, phases);
    for (const PhaseReport& phase : report.phases) {
      simulation_.phases.push_back(
          {std::string(name_of(phase.kind)), before_, before_ + phase.seconds});
      before_ += phase.seconds;
    }
    world_ = std::move(run.world());
    recorder_.keep(world_, before_);
    simulation_.tests.push_back(std::move(report));
    return simulation_.tests.back().outcome == ShakeOutcome::survived;
  }

  Simulation result() {
    simulation_.end = watch_.end();
    simulation_.events = watch_.events();
    simulation_.frames = recorder_.frames();
    return std::move(simulation_);
  }

 private:
  const SimulateOptions& options_;
  const RunContext& context_;
  Recorder recorder_;
  ObjectWatch watch_;
  World world_;
  PhaseSetting setting_;
  double before_ = 0.0;  // time of all phases of earlier runs [s]
  Simulation simulation_;
};

}  // namespace

SimulationStart start_of(const CompiledScene& scene) {
  if (!scene.arm) {
    throw InputError({scene.scene.name, "robot",
                      "is needed: without an arm nothing says where the hand begins; give a file "
                      "of grasps instead"});
  }
  SimulationStart start;
  start.platform_dofs = scene.arm->start;
  return start;
}

SimulationStart start_of(const CompiledScene& scene, const Candidate& candidate,
                         const Trial& trial) {
  const HandLine line = approach_line(scene, candidate, trial);
  SimulationStart start;
  start.approach = trial.travel;
  start.hand = {line.X_OH_from, candidate.dofs, line.hand_joints};
  if (candidate.preshape) {
    start.hand.dofs = scene.scene.hand.hand->preshapes[index(*candidate.preshape)].dofs;
  }
  start.hand.strategy = strategy_of(scene.scene.hand, candidate);
  if (!scene.arm || trial.arm_line.empty()) return start;
  start.platform_dofs = trial.arm_line.front();
  std::copy(start.hand.dofs.begin(), start.hand.dofs.end(),
            start.platform_dofs.begin() + scene.arm->hand_part().first_dof);
  start.platform_joints = arm_joints(*scene.arm, start.platform_dofs, line.hand_joints);
  return start;
}

TestProcedure closing_procedure(const CompiledScene& scene, double seconds) {
  TestProcedure procedure{.name = "close", .source = "the hand closes"};
  procedure.on_support = scene.has_obstacles();
  if (procedure.on_support) procedure.gravity = {0.0, 0.0, -9.81};
  procedure.tests = {{"close", {{.kind = PhaseKind::close, .duration = seconds}}}};
  return procedure;
}

Simulation simulate(const CompiledScene& scene, const SimulationStart& start,
                    const TestProcedure& procedure, const SimulateOptions& options,
                    const RunContext& context) {
  const ProcedureTest& test = test_of(procedure, options.test);
  GraspWorld made = world_of(scene, start, procedure);
  StepOptions step = options.step;
  step.step = procedure.step;
  require_world(made.world, step);
  SimulationRun run(scene, procedure, options, std::move(made), start.hand.strategy, context);
  if (run.run("approach", approach_phases(start.approach, options.approach_speed)) &&
      run.run("prepare", procedure.prepare)) {
    run.run(test.name, test.phases);
  }
  return run.result();
}

}  // namespace prehend
