#include "sim/manipulation/phase_run.h"

#include <algorithm>
#include <cmath>

#include "sim/base/index.h"
#include "sim/manipulation/base_motion.h"
#include "sim/motion/dynamic_grasp/hand_drives.h"
#include "sim/motion/dynamic_grasp/object_watch.h"
#include "sim/motion/step_world.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {
namespace {

Vector3 center_of(const World& world) {
  const WorldBody& object = world.bodies[index(kObjectBody)];
  return center_in_world(object.inertial, object.motion.X_WB);
}

Pose object_in_hand(const World& world, const WorldHand& hand) {
  return hand_pose(world, hand).inverse() * world.bodies[index(kObjectBody)].motion.X_WB;
}

double angle_between(const Pose& X, const Pose& Y) {
  return Eigen::AngleAxisd(Matrix3(X.linear().transpose() * Y.linear())).angle();
}

// Of an object in a hand that stands still: what is so slow for so long, and does not get faster,
// neither slides nor tips. Stricter than what ends a closing, after which the hand goes on
// pressing.
constexpr RestLimits kHeldStill{.slowest = 1e-5, .time = 0.1, .slows_down = true};

// Whether nothing new happens in the rest of a phase once everything rests.
bool ends_at_rest(const ProcedurePhase& phase) {
  switch (phase.kind) {
    case PhaseKind::settle:
    case PhaseKind::close:
    case PhaseKind::open:
      return true;
    case PhaseKind::hold:
      return !phase.pull_grows;
    default:
      return false;
  }
}

// A direction of the protocol in world axes.
Vector3 in_world(const Vector3& v, ProcedureFrame frame, const Hand& hand, const Pose& X_WO,
                 const Pose& X_WH) {
  if (frame == ProcedureFrame::world) return v;
  if (frame == ProcedureFrame::object) return X_WO.linear() * v;
  Matrix3 R_HG;  // axes of the grip in the hand's base
  R_HG.col(2) = hand.approach;
  R_HG.col(0) = hand.closing;
  R_HG.col(1) = hand.approach.cross(hand.closing);
  return X_WH.linear() * R_HG * v;
}

}  // namespace

std::vector<double> widest_posture(const Hand& hand, const std::vector<double>& otherwise) {
  std::vector<double> open = otherwise;
  double widest = -1.0;
  for (const Preshape& preshape : hand.preshapes) {
    if (preshape.max_width <= widest) continue;
    widest = preshape.max_width;
    open = preshape.dofs;
  }
  return open;
}

PhaseRun::PhaseRun(World world, const PhaseSetting& setting, const StepOptions& options,
                   const RunContext& context, SimulationEffort& effort)
    : world_(std::move(world)),
      setting_(setting),
      options_(options),
      context_(context),
      effort_(effort),
      mover_(world_, setting.hand),
      closing_(setting.scene.scene.hand, setting.strategy) {
  options_.step = setting.procedure.step;
}

WorldRobot& PhaseRun::robot() { return world_.robots[index(setting_.hand.robot)]; }
WorldBody& PhaseRun::object() { return world_.bodies[index(kObjectBody)]; }

ShakeTestReport PhaseRun::run(const std::string& name, const std::vector<ProcedurePhase>& phases) {
  report_.name = name;
  for (const ProcedurePhase& phase : phases) {
    run_phase(phase);
    if (report_.outcome == ShakeOutcome::survived) continue;
    report_.failed_at = time_;
    break;
  }
  return std::move(report_);
}

void PhaseRun::begin(const ProcedurePhase& phase) {
  report_.phases.push_back({.kind = phase.kind});
  X_WH_start_ = hand_pose(world_, setting_.hand);
  X_HO_start_ = object_in_hand(world_, setting_.hand);
  center_start_ = center_of(world_);
  const Hand& as_hand = *setting_.scene.scene.hand.hand;
  const auto turned = [&](const Vector3& v) {
    return in_world(v, phase.frame, as_hand, setting_.X_WO, setting_.X_WH);
  };
  axis_W_ = in_world(phase.axis, phase.frame, as_hand, setting_.X_WO, X_WH_start_);
  if (phase.kind == PhaseKind::approach) axis_W_ = X_WH_start_.linear() * as_hand.approach;
  world_.gravity = phase.gravity ? turned(*phase.gravity) : setting_.procedure.gravity;
  pull_W_ = turned(phase.pull);
  object().asleep = false;
  object().rest_time = 0.0;
  const double edge = bounds(setting_.scene.scene.object.mesh).size().maxCoeff();
  height_ = std::max(phase.height, phase.height_in_edges * edge);
  if (phase.kind == PhaseKind::close) {
    closing_ = Closing(setting_.scene.scene.hand, setting_.strategy);
    close_hand();
  }
}

void PhaseRun::close_hand() {
  set_hand_drives(closing_drives(*robot().model, setting_.hand, closing_), setting_.hand, robot());
}

void PhaseRun::run_phase(const ProcedurePhase& phase) {
  begin(phase);
  Resting resting(phase.kind == PhaseKind::hold ? kHeldStill : RestLimits{});
  for (double time = 0.0; time < phase.duration - 1e-9;) {
    context_.cancellation.check();
    const double step = std::min(setting_.procedure.step, phase.duration - time);
    if (phase.kind == PhaseKind::open) {
      const auto drives = opening_drives(*robot().model, setting_.hand, robot().x, setting_.open);
      set_hand_drives(drives, setting_.hand, robot());
    }
    if (!move_hand(phase, time, step)) return;
    const double share = phase.pull_grows ? (time + step) / phase.duration : 1.0;
    object().force_W = object().inertial.mass * share * pull_W_;
    const double done = advance(step);
    if (report_.outcome != ShakeOutcome::survived) return;
    time += done;
    time_ += done;
    measure(time);
    if (setting_.watcher) setting_.watcher(time_, world_);
    if (fails_on_the_way(phase.fails)) return;
    if (phase.pull_grows) report_.largest_pull = share * pull_W_.norm();
    const bool rests = resting.look(world_, setting_.hand, done);
    if (phase.kind == PhaseKind::close && !closing_.is_full()) {
      closing_.look(closing_state(world_, setting_.hand, setting_.scene.scene.hand), done);
      close_hand();
    } else if (rests && ends_at_rest(phase)) {
      break;
    }
  }
  mover_.stop(world_);
  end(phase);
}

// To the pose at the end of the step.
bool PhaseRun::move_hand(const ProcedurePhase& phase, double time, double step) {
  const BaseStart start{X_WH_start_, axis_W_, height_, phase.distance};
  if (mover_.move(base_pose(phase, start, time + step), step, world_)) return true;
  report_.outcome = ShakeOutcome::unreachable;
  return false;
}

double PhaseRun::advance(double step) {
  StepOptions options = options_;
  options.step = step;
  const StepResult result = step_world(world_, options);
  ++effort_.steps;
  effort_.shortened += result.shortened;
  effort_.crossings += result.crossings;
  effort_.simulated += result.time;
  effort_.violation = std::max(effort_.violation, result.violation);
  if (result.outcome == StepOutcome::not_converged) ++effort_.not_converged;
  if (result.time == 0.0) {
    report_.outcome = ShakeOutcome::not_simulated;
    effort_.last = result.outcome;
  }
  return result.time;
}

void PhaseRun::measure(double time) {
  PhaseReport& phase = report_.phases.back();
  const Pose X_HO = object_in_hand(world_, setting_.hand);
  const Vector3& center_O = object().inertial.center_of_mass;
  phase.seconds = time;
  phase.moved = std::max(phase.moved, (X_HO * center_O - X_HO_start_ * center_O).norm());
  phase.turned = std::max(phase.turned, angle_between(X_HO, X_HO_start_));
  phase.rose = center_of(world_).z() - center_start_.z();
  phase.sank = std::max(phase.sank, -phase.rose);
  phase.touching = static_cast<int>(links_on_object(world_, setting_.hand).size());
  if (!report_.first_slip) note_slip();
}

void PhaseRun::note_slip() {
  for (const WorldContact& contact : world_.contacts) {
    const bool a_is_link = setting_.hand.has(contact.a);
    const SolidId& link = a_is_link ? contact.a : contact.b;
    const SolidId& other = a_is_link ? contact.b : contact.a;
    if (!setting_.hand.has(link) || other != kObjectSolid || contact.impulse_W.isZero(0.0))
      continue;
    if (contact.slip < options_.sliding) continue;
    report_.first_slip = {robot().model->robot.links[index(link.index)].name, time_};
    return;
  }
}

// Failures that no later moment can make good.
bool PhaseRun::fails_on_the_way(const PhaseLimits& limits) {
  const PhaseReport& phase = report_.phases.back();
  if (phase.moved > limits.moved) report_.outcome = ShakeOutcome::moved;
  if (phase.turned > limits.turned) report_.outcome = ShakeOutcome::turned;
  if (phase.sank > limits.dropped) report_.outcome = ShakeOutcome::dropped;
  return report_.outcome != ShakeOutcome::survived;
}

void PhaseRun::end(const ProcedurePhase& phase) {
  const PhaseReport& measured = report_.phases.back();
  const PhaseLimits& limits = phase.fails;
  if (limits.least_rise > 0.0 && measured.rose < limits.least_rise) {
    report_.outcome = ShakeOutcome::not_lifted;
  }
  if (limits.loses_contact && measured.touching == 0) {
    report_.outcome = ShakeOutcome::lost_contact;
  }
  if (limits.least_fall > 0.0 && measured.sank < limits.least_fall) {
    report_.outcome = ShakeOutcome::not_released;
  }
}

}  // namespace prehend
