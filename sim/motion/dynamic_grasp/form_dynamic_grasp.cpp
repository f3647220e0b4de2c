#include "sim/motion/dynamic_grasp/form_dynamic_grasp.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

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

// As far as this from where it stood, the object meets no obstacle that is not near [m].
constexpr double kNearWay = 0.1;

// A bound on how far a point of the hand is from the origin of its base, in any posture [m].
double farthest_of_hand(const Robot& hand) {
  double farthest = 0.0;
  for (const Link& link : hand.links) {
    double reach = 0.0;
    for (const Vector3& p : link.mesh.vertices) reach = std::max(reach, p.norm());
    for (const int j : joints_to(hand, link.joint)) {
      const Joint& joint = hand.joints[index(j)];
      reach += joint.X_PJ.translation().norm() + joint.X_JA.translation().norm();
      if (joint.type == JointType::prismatic) {
        reach += std::abs(joint.zero) + std::max(std::abs(joint.lower), std::abs(joint.upper));
      }
    }
    farthest = std::max(farthest, reach);
  }
  return farthest;
}

// The obstacles that the hand can touch, and the object within kNearWay of where it stands: few of
// thousands, each of which would cost time in every step.
std::vector<BodyId> obstacles_near(const CompiledScene& scene, const Pose& X_WH,
                                   const DynamicGraspOptions& options) {
  const ProximityMesh& object = scene.object().mesh;
  const Vector3 p_OH = (scene.scene.object.X_WO.inverse() * X_WH).translation();
  const double more = options.lift + kNearWay;
  std::vector<BodyId> near;
  NearBodies found;
  const auto add = [&](const Vector3& center_O, double radius) {
    scene.near_obstacles.find({center_O, center_O, radius + more}, found);
    near.insert(near.end(), found.found.begin(), found.found.end());
  };
  add(object.ball_center(), object.ball_radius());
  add(p_OH, farthest_of_hand(scene.scene.hand));
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

class DynamicGraspRun {
 public:
  // `leash`: how far the object may go before the run ends, since there is more than what the world
  // holds [m].
  DynamicGraspRun(World world, const WorldHand& hand, const CompiledScene& scene,
                  const DynamicGraspStart& start, double leash, const DynamicGraspOptions& options,
                  const RunContext& context)
      : world_(std::move(world)),
        hand_(hand),
        as_hand_(scene.scene.hand),
        has_obstacles_(scene.has_obstacles()),
        closing_(as_hand_, start.strategy),
        center_O_(scene.wrench_frame.torque_origin),
        farthest_(start.farthest),
        leash_(leash),
        options_(options),
        context_(context),
        watch_(world_, hand) {}

  // None where the object reached the end of the leash.
  std::optional<DynamicGrasp> run() {
    center_W_ = object_center();
    ball_W_ = ball_center();
    const bool closed = wait(options_.settle) && close();
    formation_.X_WO = world_.bodies[index(kObjectBody)].motion.X_WB;
    formation_.X_WH = hand_pose(world_, hand_);
    formation_.dofs = hand_dofs(world_, hand_);
    formation_.joints = hand_joints(world_, hand_);
    if (closed && stands_on_something()) lift();
    if (is_off_leash_) return std::nullopt;
    formation_.end = went_far_ ? ObjectEnd::pushed_away : watch_.end();
    formation_.events = watch_.events();
    return std::move(formation_);
  }

 private:
  WorldRobot& robot() { return world_.robots[index(hand_.robot)]; }

  bool stands_on_something() const { return has_obstacles_ && options_.lift > 0.0; }

  // One step of at most this time; what it took, 0 where it failed.
  double step(double longest) {
    context_.cancellation.check();
    // What a hand does to an object does not hang on a thousandth of a force, which some steps of
    // jammed contacts take a hundred times as long to find.
    constexpr double kAcceptable = 1e-3;
    constexpr double kTolerance = 1e-5;
    StepOptions options;
    options.tolerance = kTolerance;
    options.acceptable = kAcceptable;
    options.step = std::min(fitting_step(), longest);
    const StepResult result = step_world(world_, options);
    formation_.last = result.outcome;
    formation_.seconds += result.time;
    ++formation_.steps;
    watch_.look(world_, formation_.seconds);
    is_off_leash_ = (ball_center() - ball_W_).norm() > leash_;
    return is_off_leash_ ? 0.0 : result.time;
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

  Vector3 ball_center() const {
    const WorldBody& object = world_.bodies[index(kObjectBody)];
    return object.motion.X_WB * object.shape.mesh.ball_center();
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
  bool has_obstacles_;
  Closing closing_;
  Vector3 center_O_;
  Vector3 center_W_ = Vector3::Zero();  // at the start
  Vector3 ball_W_ = Vector3::Zero();    // centre of the ball about the object, at the start
  double farthest_;
  double leash_;
  bool is_off_leash_ = false;
  bool went_far_ = false;
  const DynamicGraspOptions& options_;
  const RunContext& context_;
  ObjectWatch watch_;
  DynamicGrasp formation_;
};

// With these obstacles.
std::optional<DynamicGrasp> form_among(const std::vector<BodyId>& obstacles, double leash,
                                       const CompiledScene& scene,
                                       const std::shared_ptr<const RobotModel>& hand,
                                       const DynamicGraspStart& start,
                                       const DynamicGraspOptions& options,
                                       const RunContext& context) {
  World world = make_scene_world(scene, obstacles);
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
  return DynamicGraspRun(std::move(world), place, scene, start, leash, options, context).run();
}

}  // namespace

DynamicGrasp form_dynamic_grasp(const CompiledScene& scene,
                                const std::shared_ptr<const RobotModel>& hand,
                                const DynamicGraspStart& start, const DynamicGraspOptions& options,
                                const RunContext& context) {
  require_settings(options);
  const auto among = [&](const std::vector<BodyId>& obstacles, double leash) {
    return form_among(obstacles, leash, scene, hand, start, options, context);
  };
  std::vector<BodyId> near = obstacles_near(scene, start.X_WH, options);
  if (near.size() < scene.scene.obstacles.size()) {
    if (auto formation = among(near, options.lift + kNearWay)) return std::move(*formation);
  }
  near.clear();
  for (std::size_t i = 0; i < scene.scene.obstacles.size(); ++i) {
    near.push_back(BodyId::obstacle(static_cast<int>(i)));
  }
  return *among(near, std::numeric_limits<double>::infinity());
}

}  // namespace prehend
