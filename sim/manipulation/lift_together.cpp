#include "sim/manipulation/lift_together.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "sim/base/index.h"
#include "sim/base/require_settings.h"
#include "sim/motion/control/quintic_step.h"
#include "sim/motion/dynamic_grasp/hand_drives.h"
#include "sim/motion/dynamic_grasp/object_watch.h"
#include "sim/motion/dynamic_grasp/resting.h"
#include "sim/motion/require_world.h"
#include "sim/motion/step_world.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/trial.h"

namespace prehend {
namespace {

// Of the height, what the object may stay behind, and the most that it may tilt [rad].
constexpr double kMostBehind = 0.1;
constexpr double kMostTilt = 0.2;

class SharedLiftRun {
 public:
  SharedLiftRun(std::span<const HoldingHand> hands, const SharedLiftOptions& options,
                const RunContext& context)
      : options_(options),
        context_(context),
        center_O_(hands.front().scene.wrench_frame.torque_origin),
        world_(make_scene_world(hands.front().scene, true)) {
    world_.gravity = {0.0, 0.0, -options.gravity};
    const Pose X_WO = object_pose();
    for (const HoldingHand& hand : hands) {
      places_.push_back(add_hand(world_, hand.scene, hand_model(hand.scene), X_WO * hand.trial.X_OH,
                                 hand.trial.dofs, hand.trial.joints));
    }
    require_quantities(world_, step_);
  }

  SharedLift run() {
    SharedLift lift;
    if (overlap_in(world_, step_)) return lift;
    const Pose start = object_pose();
    for (const WorldHand& place : places_) {
      WorldRobot& robot = robot_of(place);
      set_hand_drives(closing_drives(*robot.model, place), place, robot);
    }
    const bool moved = press() && rise() && wait(options_.hold);
    lift.risen = (object_pose() * center_O_ - start * center_O_).z();
    const double cosine = object_pose().linear().row(2).dot(start.linear().row(2));
    lift.tilt = std::acos(std::clamp(cosine, -1.0, 1.0));
    if (moved) lift.end = end_of(lift);
    return lift;
  }

 private:
  WorldRobot& robot_of(const WorldHand& place) { return world_.robots[index(place.robot)]; }
  const Pose& object_pose() const { return world_.bodies[index(kObjectBody)].motion.X_WB; }

  SharedLiftEnd end_of(const SharedLift& lift) const {
    const bool touched = std::all_of(places_.begin(), places_.end(), [&](const WorldHand& place) {
      return !links_on_object(world_, place).empty();
    });
    if (!touched) return SharedLiftEnd::lost;
    const bool came_along =
        lift.risen > (1.0 - kMostBehind) * options_.height && lift.tilt < kMostTilt;
    return came_along ? SharedLiftEnd::lifted : SharedLiftEnd::slipped;
  }

  // One step of at most this time; what it took, 0 where it failed.
  double step(double longest) {
    context_.cancellation.check();
    StepOptions options = step_;
    options.step = std::min(options.step, longest);
    const StepResult result = step_world(world_, options);
    const bool failed =
        result.outcome == StepOutcome::blocked || result.outcome == StepOutcome::not_finite;
    return failed ? 0.0 : result.time;
  }

  // Until the object and all hands rest, or the time is over.
  bool press() {
    std::vector<Resting> resting(places_.size());
    for (double time = 0.0; time < options_.close - 1e-9;) {
      const double done = step(options_.close - time);
      if (done == 0.0) return false;
      time += done;
      bool all_rest = true;
      for (std::size_t i = 0; i < places_.size(); ++i) {
        all_rest = resting[i].look(world_, places_[i], done) && all_rest;
      }
      if (all_rest) break;
    }
    return true;
  }

  bool rise() {
    std::vector<double> starts;
    for (const WorldHand& place : places_) {
      starts.push_back(robot_of(place).X_WB.translation().z());
    }
    for (double time = 0.0; time < options_.time - 1e-9;) {
      const double next = std::min(step_.step, options_.time - time);
      const double risen = options_.height * quintic_step((time + next) / options_.time);
      for (std::size_t i = 0; i < places_.size(); ++i) {
        WorldRobot& robot = robot_of(places_[i]);
        robot.base_linear.z() = (starts[i] + risen - robot.X_WB.translation().z()) / next;
      }
      const double done = step(next);
      if (done == 0.0) return false;
      time += done;
    }
    for (const WorldHand& place : places_) robot_of(place).base_linear.setZero();
    return true;
  }

  bool wait(double seconds) {
    for (double time = 0.0; time < seconds - 1e-9;) {
      const double done = step(seconds - time);
      if (done == 0.0) return false;
      time += done;
    }
    return true;
  }

  const SharedLiftOptions& options_;
  const RunContext& context_;
  StepOptions step_;
  Vector3 center_O_;
  World world_;
  std::vector<WorldHand> places_;
};

}  // namespace

SharedLift lift_together(std::span<const HoldingHand> hands, const SharedLiftOptions& options,
                         const RunContext& context) {
  require_settings(options);
  return SharedLiftRun(hands, options, context).run();
}

}  // namespace prehend
