#include "sim/manipulation/shake.h"

#include <algorithm>
#include <cmath>

#include "sim/base/index.h"
#include "sim/manipulation/base_motion.h"

namespace prehend {
namespace {

// An object that rests: slower than this for so long ends a phase that only waits [m/s, s].
constexpr double kResting = 1e-4;
constexpr double kRestingFor = 0.05;

Vector3 center_of(const World& world) {
  const WorldBody& object = world.bodies[index(kHeldObject)];
  return center_in_world(object.inertial, object.motion.X_WB);
}

Pose object_in_hand(const World& world) {
  return world.robots[index(kGraspingHand)].X_WB.inverse() *
         world.bodies[index(kHeldObject)].motion.X_WB;
}

double angle_between(const Pose& X, const Pose& Y) {
  return Eigen::AngleAxisd(Matrix3(X.linear().transpose() * Y.linear())).angle();
}

// A direction of the protocol in world axes.
Vector3 in_world(const Vector3& v, ProtocolFrame frame, const Hand& hand, const Pose& X_WO,
                 const Pose& X_WH) {
  if (frame == ProtocolFrame::world) return v;
  if (frame == ProtocolFrame::object) return X_WO.linear() * v;
  Matrix3 R_HG;  // axes of the grip in the hand's base
  R_HG.col(2) = hand.approach;
  R_HG.col(0) = hand.closing;
  R_HG.col(1) = hand.approach.cross(hand.closing);
  return X_WH.linear() * R_HG * v;
}

// Runs the phases of one test on a world of its own.
class PhaseRun {
 public:
  PhaseRun(World world, const CompiledScene& scene, const GraspPosture& grasp,
           const Protocol& protocol, const ShakeOptions& options, const RunContext& context,
           SimulationEffort& effort)
      : world_(std::move(world)),
        scene_(scene),
        grasp_(grasp),
        protocol_(protocol),
        options_(options),
        context_(context),
        effort_(effort) {
    options_.step.step = protocol.step;
  }

  ShakeTestReport run(const std::string& name, const std::vector<ProtocolPhase>& phases) {
    report_.name = name;
    for (const ProtocolPhase& phase : phases) {
      run_phase(phase);
      if (report_.outcome == ShakeOutcome::survived) continue;
      report_.failed_at = time_;
      break;
    }
    return std::move(report_);
  }

  World& world() { return world_; }

 private:
  WorldRobot& hand() { return world_.robots[index(kGraspingHand)]; }
  WorldBody& object() { return world_.bodies[index(kHeldObject)]; }

  void begin(const ProtocolPhase& phase) {
    report_.phases.push_back({.kind = phase.kind});
    X_WH_start_ = hand().X_WB;
    X_HO_start_ = object_in_hand(world_);
    center_start_ = center_of(world_);
    const Hand& as_hand = *scene_.scene.hand.hand;
    const Pose& X_WO = scene_.scene.object.X_WO;
    const auto turned = [&](const Vector3& v) {
      return in_world(v, phase.frame, as_hand, X_WO, X_WO * grasp_.X_OH);
    };
    axis_W_ = in_world(phase.axis, phase.frame, as_hand, X_WO, X_WH_start_);
    world_.gravity = phase.gravity ? turned(*phase.gravity) : protocol_.gravity;
    pull_W_ = turned(phase.pull);
    object().asleep = false;
    object().rest_time = 0.0;
    const double edge = bounds(scene_.scene.object.mesh).size().maxCoeff();
    height_ = std::max(phase.height, phase.height_in_edges * edge);
    if (phase.kind == PhaseKind::close) hand().drives = closing_drives(*hand().model);
  }

  void run_phase(const ProtocolPhase& phase) {
    begin(phase);
    const bool may_end_early = phase.kind == PhaseKind::settle || phase.kind == PhaseKind::close;
    double resting = 0.0;
    for (double time = 0.0; time < phase.duration - 1e-9;) {
      context_.cancellation.check();
      const double step = std::min(protocol_.step, phase.duration - time);
      if (phase.kind == PhaseKind::open) {
        hand().drives = opening_drives(*hand().model, hand().x, open_posture());
      }
      move_base(phase, time, step);
      const double share = phase.pull_grows ? (time + step) / phase.duration : 1.0;
      object().force_W = object().inertial.mass * share * pull_W_;
      const double done = advance(step);
      if (report_.outcome != ShakeOutcome::survived) return;
      time += done;
      time_ += done;
      measure(time);
      if (fails_on_the_way(phase.fails)) return;
      if (phase.pull_grows) report_.largest_pull = share * pull_W_.norm();
      resting = is_resting() ? resting + done : 0.0;
      if (may_end_early && resting >= kRestingFor) break;
    }
    hand().base_linear.setZero();
    hand().base_angular.setZero();
    end(phase);
  }

  // Base velocities that lead to the pose at the end of the step.
  void move_base(const ProtocolPhase& phase, double time, double step) {
    const Pose to = base_pose(phase, {X_WH_start_, axis_W_, height_}, time + step);
    const Pose& from = hand().X_WB;
    hand().base_linear = (to.translation() - from.translation()) / step;
    const Eigen::AngleAxisd turn(Matrix3(to.linear() * from.linear().transpose()));
    hand().base_angular = turn.angle() / step * turn.axis();
  }

  double advance(double step) {
    StepOptions options = options_.step;
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

  // The preshape with which the hand is open widest, or the lower limits of what closes.
  std::vector<double> open_posture() const {
    const Hand& as_hand = *scene_.scene.hand.hand;
    std::vector<double> open = grasp_.dofs;
    double widest = -1.0;
    for (const Preshape& preshape : as_hand.preshapes) {
      if (preshape.max_width <= widest) continue;
      widest = preshape.max_width;
      open = preshape.dofs;
    }
    return open;
  }

  bool is_resting() const {
    const WorldBody& body = world_.bodies[index(kHeldObject)];
    const double speed =
        body.motion.linear.norm() + body.motion.angular.norm() * body.shape.mesh.ball_radius();
    const WorldRobot& robot = world_.robots[index(kGraspingHand)];
    return speed < kResting && robot.rate.lpNorm<Eigen::Infinity>() < 10.0 * kResting;
  }

  void measure(double time) {
    PhaseReport& phase = report_.phases.back();
    const Pose X_HO = object_in_hand(world_);
    const Vector3& center_O = object().inertial.center_of_mass;
    phase.seconds = time;
    phase.moved = std::max(phase.moved, (X_HO * center_O - X_HO_start_ * center_O).norm());
    phase.turned = std::max(phase.turned, angle_between(X_HO, X_HO_start_));
    phase.rose = center_of(world_).z() - center_start_.z();
    phase.sank = std::max(phase.sank, -phase.rose);
    std::vector<int> links;
    for (const WorldContact& contact : world_.contacts) {
      if (contact.a.robot < 0 && contact.b.robot < 0) continue;
      if (contact.impulse_W.isZero(0.0)) continue;
      const SolidId& link = contact.a.robot >= 0 ? contact.a : contact.b;
      const SolidId& other = contact.a.robot >= 0 ? contact.b : contact.a;
      if (other != SolidId{-1, kHeldObject}) continue;
      links.push_back(link.index);
      if (report_.first_slip || contact.slip < options_.step.sliding) continue;
      report_.first_slip = {hand().model->robot.links[index(link.index)].name, time_};
    }
    std::sort(links.begin(), links.end());
    phase.touching = static_cast<int>(std::unique(links.begin(), links.end()) - links.begin());
  }

  // Failures that no later moment can make good.
  bool fails_on_the_way(const PhaseLimits& limits) {
    const PhaseReport& phase = report_.phases.back();
    if (phase.moved > limits.moved) report_.outcome = ShakeOutcome::moved;
    if (phase.turned > limits.turned) report_.outcome = ShakeOutcome::turned;
    if (phase.sank > limits.dropped) report_.outcome = ShakeOutcome::dropped;
    return report_.outcome != ShakeOutcome::survived;
  }

  void end(const ProtocolPhase& phase) {
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

  World world_;
  const CompiledScene& scene_;
  const GraspPosture& grasp_;
  const Protocol& protocol_;
  ShakeOptions options_;
  const RunContext& context_;
  SimulationEffort& effort_;
  ShakeTestReport report_;
  double time_ = 0.0;  // since the test began
  double height_ = 0.0;
  Vector3 axis_W_ = Vector3::UnitZ();
  Vector3 pull_W_ = Vector3::Zero();  // the phase's, at its largest [m/s^2]
  Pose X_WH_start_ = Pose::Identity();
  Pose X_HO_start_ = Pose::Identity();
  Vector3 center_start_ = Vector3::Zero();
};

bool is_preparation(const ShakeTestReport& test) { return test.name == "prepare"; }

}  // namespace

int ShakeReport::survived() const {
  return static_cast<int>(std::count_if(tests.begin(), tests.end(), [](const auto& test) {
    return !is_preparation(test) && test.outcome == ShakeOutcome::survived;
  }));
}

int ShakeReport::count() const {
  return static_cast<int>(std::count_if(tests.begin(), tests.end(),
                                        [](const auto& test) { return !is_preparation(test); }));
}

bool ShakeReport::holds() const {
  return std::all_of(tests.begin(), tests.end(),
                     [](const auto& test) { return test.outcome == ShakeOutcome::survived; });
}

std::optional<double> ShakeReport::largest_pull() const {
  std::optional<double> weakest;
  for (const ShakeTestReport& test : tests) {
    if (!test.largest_pull) continue;
    weakest = std::min(weakest.value_or(kNoLimit), *test.largest_pull);
  }
  return weakest;
}

ShakeReport shake_grasp(const CompiledScene& scene, const std::shared_ptr<const RobotModel>& hand,
                        const GraspPosture& grasp, const Protocol& protocol,
                        const ShakeOptions& options, const RunContext& context) {
  ShakeReport report;
  report.protocol = protocol.name;
  World world = make_grasp_world(scene, hand, grasp, protocol);
  StepOptions step = options.step;
  step.step = protocol.step;
  require_world(world, step);
  if (!protocol.prepare.empty()) {
    PhaseRun prepare(std::move(world), scene, grasp, protocol, options, context, report.effort);
    report.tests.push_back(prepare.run("prepare", protocol.prepare));
    world = std::move(prepare.world());
  }
  for (const ProtocolTest& test : protocol.tests) {
    PhaseRun run(world, scene, grasp, protocol, options, context, report.effort);
    report.tests.push_back(run.run(test.name, test.phases));
  }
  return report;
}

}  // namespace prehend
