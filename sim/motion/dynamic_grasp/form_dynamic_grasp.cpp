#include "sim/motion/dynamic_grasp/form_dynamic_grasp.h"

#include <algorithm>
#include <functional>

#include "sim/base/index.h"
#include "sim/base/require_settings.h"
#include "sim/motion/control/quintic_step.h"
#include "sim/motion/dynamic_grasp/hand_drives.h"
#include "sim/motion/dynamic_grasp/resting.h"
#include "sim/motion/require_world.h"
#include "sim/motion/solids.h"
#include "sim/motion/step_world.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {
namespace {

class DynamicGraspRun {
 public:
  DynamicGraspRun(World world, const WorldHand& hand, const CompiledScene& scene,
                  const DynamicGraspStart& start, const DynamicGraspOptions& options,
                  const RunContext& context)
      : world_(std::move(world)),
        hand_(hand),
        as_hand_(scene.scene.hand),
        closing_(as_hand_, start.strategy),
        center_O_(scene.wrench_frame.torque_origin),
        farthest_(start.farthest),
        options_(options),
        context_(context),
        watch_(world_, hand) {}

  DynamicGrasp run() {
    center_W_ = object_center();
    const bool closed = wait(options_.settle) && close();
    formation_.X_WO = world_.bodies[index(kObjectBody)].motion.X_WB;
    formation_.X_WH = hand_pose(world_, hand_);
    formation_.dofs = hand_dofs(world_, hand_);
    formation_.joints = hand_joints(world_, hand_);
    if (closed && stands_on_something()) lift();
    formation_.end = went_far_ ? ObjectEnd::pushed_away : watch_.end();
    formation_.events = watch_.events();
    return std::move(formation_);
  }

 private:
  WorldRobot& robot() { return world_.robots[index(hand_.robot)]; }

  bool stands_on_something() const { return world_.bodies.size() > 1 && options_.lift > 0.0; }

  // One step of at most this time; what it took, 0 where it failed.
  double step(double longest) {
    context_.cancellation.check();
    // What a hand does to an object does not hang on a thousandth of a force, which some steps of
    // jammed contacts take a hundred times as long to find.
    constexpr double kAcceptable = 1e-3;
    StepOptions options;
    options.acceptable = kAcceptable;
    options.step = std::min(fitting_step(), longest);
    const StepResult result = step_world(world_, options);
    formation_.last = result.outcome;
    formation_.seconds += result.time;
    ++formation_.steps;
    watch_.look(world_, formation_.seconds);
    return result.time;
  }

  // The longest step in which no point of the hand, its base held still, or of the object moves by
  // more than options.travel. Impacts and falls get the steps of any world.
  double fitting_step() const {
    const WorldRobot& robot = world_.robots[index(hand_.robot)];
    const Solids solids(world_);
    double fastest = 0.0;
    for (const Solid& solid : solids.all()) {
      if (!solid.moves) continue;
      const ProximityMesh& mesh = solid.shape->mesh;
      const Vector3 center = solid.velocity_at(solid.X_WS * mesh.ball_center());
      fastest = std::max(
          fastest, (center - robot.base_linear).norm() + solid.angular.norm() * mesh.ball_radius());
    }
    const double shortest = std::min(StepOptions{}.step, options_.step);
    return std::clamp(options_.travel / fastest, shortest, options_.step);
  }

  Vector3 object_center() const {
    return world_.bodies[index(kObjectBody)].motion.X_WB * center_O_;
  }

  bool is_lost() const {
    // One finger may push it to another, out of touch with both: it is then on its way for less
    // than this [s].
    constexpr double kOnItsWay = 0.3;
    return watch_.alone_for(formation_.seconds) > kOnItsWay && !fingers_are_coming();
  }

  // Whether a finger still closes without much in its way. It may be on its way to an object that
  // the palm touched before.
  bool fingers_are_coming() const {
    constexpr double kFree = 0.5;  // of its closing velocity
    const WorldRobot& robot = world_.robots[index(hand_.robot)];
    for (int d = hand_.first_dof; d < hand_.first_dof + hand_.dofs; ++d) {
      const double closing = robot.model->robot.dofs[index(d)].closing_velocity;
      if (closing != 0.0 && robot.rate[d] / closing > kFree) return true;
    }
    return false;
  }

  // Until everything rests, the object is lost, or the time is over. False where a step failed.
  // `after` each step, with the time that it took.
  bool wait(double seconds, const std::function<void(double)>& after = {}) {
    Resting resting;
    for (double time = 0.0; time < seconds - 1e-9;) {
      const double done = step(seconds - time);
      if (done == 0.0) return false;
      time += done;
      if (resting.look(world_, hand_, done) || is_lost()) break;
      went_far_ = after && (object_center() - center_W_).norm() > farthest_;
      if (went_far_) break;
      if (after) after(done);
    }
    return true;
  }

  void drive() { set_hand_drives(closing_drives(*robot().model, hand_, closing_), hand_, robot()); }

  bool close() {
    drive();
    const bool moved = wait((1 + closing_.stages()) * options_.close, [&](double done) {
      if (closing_.is_full()) return;
      closing_.look(closing_state(world_, hand_, as_hand_), done);
      drive();
    });
    return moved && !is_lost() && !went_far_;
  }

  void lift() {
    const double start = robot().X_WB.translation().z();
    for (double time = 0.0; time < options_.lift_time - 1e-9;) {
      const double next = std::min(fitting_step(), options_.lift_time - time);
      const double height =
          start + options_.lift * quintic_step((time + next) / options_.lift_time);
      robot().base_linear = {0.0, 0.0, (height - robot().X_WB.translation().z()) / next};
      const double done = step(next);
      if (done == 0.0 || is_lost()) return;
      time += done;
    }
    robot().base_linear.setZero();
    wait(options_.hold);
  }

  World world_;
  const WorldHand& hand_;
  const Robot& as_hand_;
  Closing closing_;
  Vector3 center_O_;
  Vector3 center_W_ = Vector3::Zero();  // at the start
  double farthest_;
  bool went_far_ = false;
  const DynamicGraspOptions& options_;
  const RunContext& context_;
  ObjectWatch watch_;
  DynamicGrasp formation_;
};

}  // namespace

DynamicGrasp form_dynamic_grasp(const CompiledScene& scene,
                                const std::shared_ptr<const RobotModel>& hand,
                                const DynamicGraspStart& start, const DynamicGraspOptions& options,
                                const RunContext& context) {
  require_settings(options);
  World world = make_scene_world(scene, true);
  world.gravity = {0.0, 0.0, scene.has_obstacles() ? -options.gravity : 0.0};
  const WorldHand place = add_hand(world, scene, hand, start.X_WH, start.dofs, start.joints);
  StepOptions step;
  step.step = options.step;
  require_quantities(world, step);
  if (overlap_in(world, step)) {
    DynamicGrasp formation;
    formation.X_WO = scene.scene.object.X_WO;
    formation.X_WH = start.X_WH;
    formation.dofs = start.dofs;
    formation.joints = hand_joints(world, place);
    formation.last = StepOutcome::blocked;
    return formation;
  }
  return DynamicGraspRun(std::move(world), place, scene, start, options, context).run();
}

}  // namespace prehend
