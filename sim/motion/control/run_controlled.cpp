#include "sim/motion/control/run_controlled.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/motion/clutches.h"
#include "sim/motion/require_world.h"
#include "sim/motion/step_world.h"

namespace prehend {
namespace {

void require_run(const World& world, const std::vector<ControlledRobot>& robots,
                 const ControlledRunOptions& options) {
  if (!(options.seconds >= 0.0) || !std::isfinite(options.seconds)) {
    throw InputError({.field = "seconds",
                      .problem = "must not be negative",
                      .value = std::to_string(options.seconds)});
  }
  for (const ControlledRobot& controlled : robots) {
    if (controlled.robot >= 0 && index(controlled.robot) < world.robots.size()) continue;
    throw InputError({.field = "robot",
                      .problem = "the world has no such robot",
                      .value = std::to_string(controlled.robot)});
  }
  require_world(world, options.step);
}

// The efforts that degrees of freedom may have: any where none is stated.
Eigen::VectorXd most_of(const Robot& robot) {
  const Eigen::VectorXd stated = stated_efforts(robot);
  const double any = std::numeric_limits<double>::infinity();
  return (stated.array() > 0.0).select(stated, Eigen::VectorXd::Constant(stated.size(), any));
}

class Run {
 public:
  Run(World& world, const std::vector<ControlledRobot>& robots, const ControlledRunOptions& options)
      : world_(world), robots_(robots), options_(options) {
    for (const ControlledRobot& controlled : robots) {
      most_.push_back(most_of(world.robots[index(controlled.robot)].model->robot));
    }
  }

  ControlledRun run(const RunContext& context) {
    // What is shorter than this remains of sums of steps.
    constexpr double kRest = 1e-9;
    StepOptions step = options_.step;
    while (result_.time < options_.seconds - kRest) {
      context.cancellation.check();
      step.step = std::min(options_.step.step, options_.seconds - result_.time);
      if (!ask_all(step.step)) return result_;
      const StepResult done = step_world(world_, step);
      if (done.outcome == StepOutcome::blocked) return ended(ControlOutcome::blocked);
      if (done.outcome == StepOutcome::not_finite) return ended(ControlOutcome::not_finite);
      if (done.outcome == StepOutcome::not_converged) ++result_.not_converged;
      ++result_.steps;
      result_.time += done.time;
      if (options_.stops && options_.stops(result_.time, world_)) {
        return ended(ControlOutcome::stopped);
      }
    }
    return result_;
  }

 private:
  ControlledRun ended(ControlOutcome outcome) {
    result_.outcome = outcome;
    return result_;
  }

  bool ask_all(double step) {
    for (std::size_t c = 0; c < robots_.size(); ++c) {
      WorldRobot& robot = world_.robots[index(robots_[c].robot)];
      const ControlState state{result_.time, step, robot, world_.gravity};
      Eigen::VectorXd effort = robots_[c].controller(state);
      if (effort.size() != robot.model->dofs()) {
        result_.why = formatted("%s: the controller answered %ld efforts for %ld at %.9g s",
                                robot.name.c_str(), static_cast<long>(effort.size()),
                                static_cast<long>(robot.model->dofs()), result_.time);
        result_.outcome = ControlOutcome::wrong_size;
        return false;
      }
      if (effort.array().isNaN().any()) {
        result_.why = formatted(
            "%s: the controller answered an effort that is not a number at "
            "%.9g s",
            robot.name.c_str(), result_.time);
        result_.outcome = ControlOutcome::not_a_number;
        return false;
      }
      robot.effort = effort.cwiseMax(-most_[c]).cwiseMin(most_[c]);
    }
    return true;
  }

  World& world_;
  const std::vector<ControlledRobot>& robots_;
  const ControlledRunOptions& options_;
  std::vector<Eigen::VectorXd> most_;
  ControlledRun result_;
};

}  // namespace

ControlledRun run_controlled(World& world, const std::vector<ControlledRobot>& robots,
                             const ControlledRunOptions& options, const RunContext& context) {
  require_run(world, robots, options);
  return Run(world, robots, options).run(context);
}

}  // namespace prehend
