// A grasp that forms in time: the object stands on its support with its weight and friction, the
// hand closes with its efforts, and pushes, turns, holds or loses it.
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/motion/dynamic_grasp/dynamic_grasp_options.h"
#include "sim/motion/dynamic_grasp/object_watch.h"
#include "sim/motion/step_outcome.h"
#include "sim/robot/robot.h"

namespace prehend {

struct CompiledScene;

// Where the hand is when it begins to close.
struct DynamicGraspStart {
  Pose X_WH = Pose::Identity();
  std::vector<double> dofs;    // of the hand [rad or m]
  std::vector<double> joints;  // empty: as the degrees of freedom say
  ClosingStrategy strategy = {};
  // Of the object's centre (CompiledScene::wrench_frame) while the hand closes [m]: farther away it
  // counts as pushed away, and the simulation ends.
  double farthest = std::numeric_limits<double>::infinity();
};

// How the grasp has formed.
struct DynamicGrasp {
  ObjectEnd end = ObjectEnd::untouched;
  std::vector<ObjectEvent> events;
  // When the hand had closed, before it rose.
  Pose X_WO = Pose::Identity();  // of the object
  Pose X_WH = Pose::Identity();  // of the hand's base
  std::vector<double> dofs;      // of the hand [rad or m]
  std::vector<double> joints;    // of the hand [rad or m]
  double seconds = 0.0;          // that were simulated
  int steps = 0;
  StepOutcome last = StepOutcome::moved;  // blocked or not_finite: the simulation ended early
};

// Closes the hand (a hand_model of the scene) on the object: waits until that rests, closes until
// everything rests, and rises. The base stands still while the hand closes: what carries it is
// stiff. Where solids overlap at the start nothing moves, and `last` is `blocked`. The same start
// gives the same bytes. Throws InputError for an object without a mass, and Cancelled.
DynamicGrasp form_dynamic_grasp(const CompiledScene& scene,
                                const std::shared_ptr<const RobotModel>& hand,
                                const DynamicGraspStart& start, const DynamicGraspOptions& options,
                                const RunContext& context = {});

}  // namespace prehend
