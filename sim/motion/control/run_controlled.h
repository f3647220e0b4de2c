// A world whose robots are driven by controllers, run through time.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/named_enum.h"
#include "sim/base/run_context.h"
#include "sim/motion/control/controller.h"
#include "sim/motion/step_options.h"

namespace prehend {

// A robot of the world and what drives it.
struct ControlledRobot {
  int robot = 0;  // index into World::robots
  Controller controller;
};

// How a run ended.
enum class ControlOutcome {
  finished,      // its time is over
  stopped,       // by its watcher
  not_a_number,  // a controller answered with an effort that is none
  wrong_size,    // a controller answered with another number of efforts than it drives
  blocked,       // a step ended so (StepOutcome)
  not_finite,    // a step ended so
};

// The name in files: the same word as the enumerator.
constexpr auto enum_names(ControlOutcome /*of*/) {
  return std::to_array<std::string_view>(
      {"finished", "stopped", "not_a_number", "wrong_size", "blocked", "not_finite"});
}

struct ControlledRunOptions {
  double seconds = 1.0;  // how long it runs, >= 0
  StepOptions step = {};
  // Asked after each step, with the time since the run began [s]; the run stops where it says so.
  std::function<bool(double time, const World& world)> stops = {};
};

struct ControlledRun {
  ControlOutcome outcome = ControlOutcome::finished;
  double time = 0.0;  // that was run: the world is as it was then [s]
  int steps = 0;
  int not_converged = 0;  // steps that ended so
  // Of a run that a controller ended: what it answered, of which robot and when; else empty.
  std::string why = {};
};

// Asks each controller at the beginning of each step and moves the world on with its efforts, which
// are limited to the largest efforts that the robot's joints state (Joint::max_effort). Robots
// without a controller move as their drives say. A run that does not finish leaves the world in its
// last good state. Throws InputError for a world that cannot be stepped (require_world), a robot
// that is not there, and a negative time; Cancelled; and what a controller throws.
ControlledRun run_controlled(World& world, const std::vector<ControlledRobot>& robots,
                             const ControlledRunOptions& options = {},
                             const RunContext& context = {});

}  // namespace prehend
