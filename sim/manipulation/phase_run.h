// The phases of a protocol, carried out on a world.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/manipulation/move_hand.h"
#include "sim/manipulation/shake_report.h"
#include "sim/manipulation/test_procedure.h"
#include "sim/motion/dynamic_grasp/closing.h"
#include "sim/motion/dynamic_grasp/resting.h"
#include "sim/motion/dynamic_grasp/scene_world.h"
#include "sim/motion/step_options.h"

namespace prehend {

struct CompiledScene;

// What phases need to know besides the world.
struct PhaseSetting {
  const CompiledScene& scene;
  const TestProcedure& procedure;
  WorldHand hand;
  Pose X_WO = Pose::Identity();  // of the object and of the hand's base in the grasp, for axes that
  Pose X_WH = Pose::Identity();  // are given in them
  std::vector<double> open;      // degrees of freedom of the hand where it is open
  ClosingStrategy strategy = {};
  // Called after each step, with the time since the first phase began; may be empty.
  std::function<void(double time, const World& world)> watcher = {};
};

// Degrees of freedom of the hand in the preshape with which it is widest; `otherwise` where it has
// none.
std::vector<double> widest_posture(const Hand& hand, const std::vector<double>& otherwise);

// Runs phases, one after the other, on a world of its own.
class PhaseRun {
 public:
  // `setting` must outlive the run. `effort` is added to.
  PhaseRun(World world, const PhaseSetting& setting, const StepOptions& options,
           const RunContext& context, SimulationEffort& effort);

  // Until the first phase that fails.
  ShakeTestReport run(const std::string& name, const std::vector<ProcedurePhase>& phases);

  World& world() { return world_; }

 private:
  WorldRobot& robot();
  WorldBody& object();
  void begin(const ProcedurePhase& phase);
  void close_hand();
  void run_phase(const ProcedurePhase& phase);
  bool move_hand(const ProcedurePhase& phase, double time, double step);
  double advance(double step);
  void measure(double time);
  void note_slip();
  bool fails_on_the_way(const PhaseLimits& limits);
  void end(const ProcedurePhase& phase);

  World world_;
  const PhaseSetting& setting_;
  StepOptions options_;
  const RunContext& context_;
  SimulationEffort& effort_;
  HandMover mover_;
  Closing closing_;
  ShakeTestReport report_;
  double time_ = 0.0;  // since the test began
  double height_ = 0.0;
  Vector3 axis_W_ = Vector3::UnitZ();
  Vector3 pull_W_ = Vector3::Zero();  // the phase's, at its largest [m/s^2]
  Pose X_WH_start_ = Pose::Identity();
  Pose X_HO_start_ = Pose::Identity();
  Vector3 center_start_ = Vector3::Zero();
};

}  // namespace prehend
