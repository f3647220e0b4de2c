// A scene simulated in time: what its hand does to its object, moment by moment.
#pragma once

#include <string>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/manipulation/grasp_world.h"
#include "sim/manipulation/recording.h"
#include "sim/manipulation/shake_report.h"
#include "sim/manipulation/test_procedure.h"
#include "sim/motion/dynamic_grasp/object_watch.h"
#include "sim/motion/step_options.h"

namespace prehend {

struct Candidate;
struct CompiledScene;
struct Trial;

struct SimulateOptions {
  double every = 0.01;  // between two recorded frames, at least; > 0 [s]
  std::string test;     // of the protocol, which is carried out after its preparation; empty: first
  StepOptions step;     // step.step is the protocol's
  // The approach of a hand that begins away from its grasp [m/s].
  double approach_speed = 0.1;
};

// Where the robot begins, and how far the hand then approaches.
struct SimulationStart {
  // Without an arm: of the hand. `hand.X_OC` is the object's.
  GraspPosture hand;
  // With an arm: all degrees of freedom of the platform, and its joints (empty: as these say).
  std::vector<double> platform_dofs;
  std::vector<double> platform_joints;
  double approach = 0.0;  // before the protocol begins, straight; 0: not [m]
};

// The platform where the scene starts it. Throws InputError for a scene without an arm: nothing
// says where its hand is.
SimulationStart start_of(const CompiledScene& scene);

// The pre-grasp of a trial whose hand came to close.
SimulationStart start_of(const CompiledScene& scene, const Candidate& candidate,
                         const Trial& trial);

// A phase of a simulation, as times of its frames.
struct SimulatedPhase {
  std::string name;  // name_of()
  double from = 0.0;
  double to = 0.0;  // [s]
};

struct Simulation {
  std::string procedure;
  World start;  // before the first step
  WorldHand hand;
  ObjectEnd end = ObjectEnd::untouched;
  std::vector<ObjectEvent> events;
  std::vector<ShakeTestReport> tests;  // the approach, the preparation and the test, as there are
  std::vector<SimulatedPhase> phases;
  std::vector<WorldFrame> frames;  // at least one
  SimulationEffort effort;
};

// The hand closes for so long (or until all rests), with gravity where the scene has obstacles to
// stand on.
TestProcedure closing_procedure(const CompiledScene& scene, double seconds);

// Carries out the preparation and one test of a protocol on the scene, and records it. The object
// is watched from the beginning. The same input gives the same bytes. Throws InputError for a test
// that the protocol does not have and a world that cannot be stepped (require_world), and
// Cancelled.
Simulation simulate(const CompiledScene& scene, const SimulationStart& start,
                    const TestProcedure& procedure, const SimulateOptions& options = {},
                    const RunContext& context = {});

}  // namespace prehend
