#include "benchmarks/shake/mujoco_shake.h"

#include <algorithm>
#include <cmath>

#include "benchmarks/shake/mujoco_world.h"
#include "sim/manipulation/base_motion.h"
#include "sim/motion/dynamic_grasp/closing.h"
#include "sim/shape/mass_properties.h"

namespace prehend::bench {
namespace {

// An object that was slower than this for so long has settled [m/s, s].
constexpr double kRestSpeed = 1e-3;
constexpr double kRestTime = 0.1;

class ShakeRun {
 public:
  ShakeRun(const std::string& mjcf, const TestProcedure& procedure, const ShakeSubject& subject,
           const StartOptions& start);

  ShakeResult run();

 private:
  bool run_phases(const std::vector<ProcedurePhase>& phases, ShakeTestResult& result);
  PhaseResult run_phase(const ProcedurePhase& phase);
  ClosingState closing_state() const;
  void drive(const Closing& closing);
  void measure(const Pose& X_HO, const Vector3& p_H, double z, PhaseMeasure& measure) const;
  Matrix3 axes_of(ProcedureFrame frame) const;
  double object_mass() const;

  const TestProcedure& procedure_;
  const ShakeSubject& subject_;
  MujocoWorld world_;
  Matrix3 R_WO_;  // at the start
  double steps_ = 0.0;
};

ShakeRun::ShakeRun(const std::string& mjcf, const TestProcedure& procedure,
                   const ShakeSubject& subject, const StartOptions& start)
    : procedure_(procedure), subject_(subject), world_(mjcf) {
  if (procedure.object.mass) world_.set_object_mass(*procedure.object.mass);
  if (procedure.object.density) world_.set_object_mass(*procedure.object.density * subject.volume);
  if (procedure.friction) world_.set_friction(*procedure.friction);
  if (procedure.torsion) world_.set_torsion(*procedure.torsion);
  world_.set_locks(subject.locks);
  world_.start(start);
  R_WO_ = world_.object().linear();
}

Matrix3 ShakeRun::axes_of(ProcedureFrame frame) const {
  if (frame == ProcedureFrame::object) return R_WO_;
  if (frame == ProcedureFrame::hand) return world_.base().linear() * subject_.R_HG;
  return Matrix3::Identity();
}

void ShakeRun::measure(const Pose& X_HO, const Vector3& p_H, double z,
                       PhaseMeasure& measure) const {
  const Pose X_HW = world_.base().inverse();
  const Vector3 com_W = world_.center_of_mass();
  measure.moved_end = (X_HW * com_W - p_H).norm();
  measure.moved = std::max(measure.moved, measure.moved_end);
  const Matrix3 turn = X_HO.linear().transpose() * (X_HW * world_.object()).linear();
  measure.turned = std::max(measure.turned, Eigen::AngleAxisd(turn).angle());
  measure.rise = com_W.z() - z;
  measure.dropped = std::max(measure.dropped, -measure.rise);
  measure.deepest = std::max(measure.deepest, world_.overlap());
}

ClosingState ShakeRun::closing_state() const {
  const Robot& hand = subject_.hand;
  ClosingState state{std::vector<bool>(hand.dofs.size(), false),
                     std::vector<double>(hand.dofs.size(), 0.0)};
  for (const Link& link : hand.links) {
    if (!world_.presses(link.name)) continue;
    for (const int joint : joints_to(hand, link.joint)) {
      state.touches[static_cast<std::size_t>(hand.joints[static_cast<std::size_t>(joint)].dof)] =
          true;
    }
  }
  for (const Joint& joint : hand.joints) {
    double& rate = state.rates[static_cast<std::size_t>(joint.dof)];
    const double own = world_.joint_rate(joint.name) / joint.ratio;
    if (std::abs(own) > std::abs(rate)) rate = own;
  }
  return state;
}

void ShakeRun::drive(const Closing& closing) {
  for (const Joint& joint : subject_.hand.joints) {
    const auto dof = static_cast<std::size_t>(joint.dof);
    if (subject_.hand.dofs[dof].closing_velocity == 0.0) continue;
    world_.set_effort(joint.name, closing.effort(dof));
  }
}

PhaseResult ShakeRun::run_phase(const ProcedurePhase& phase) {
  Closing closing(subject_.hand, subject_.strategy);
  if (phase.kind == PhaseKind::close) {
    world_.close();
    drive(closing);
  }
  if (phase.kind == PhaseKind::open) world_.open();
  const Matrix3 R = axes_of(phase.frame);
  world_.set_gravity(phase.gravity ? Vector3(R * *phase.gravity) : procedure_.gravity);
  const Vector3 pull_W = world_.object_mass() * (R * phase.pull);
  const BaseStart start{
      .X_WH = world_.base(),
      .axis_W = R * phase.axis,
      .height = std::max(phase.height, phase.height_in_edges * subject_.longest_edge)};
  const Pose X_HO = world_.base().inverse() * world_.object();
  const Vector3 p_H = world_.base().inverse() * world_.center_of_mass();
  const double z = world_.center_of_mass().z();
  PhaseResult result;
  result.kind = phase.kind;
  const double h = world_.time_step();
  const int steps = static_cast<int>(std::ceil(phase.duration / h - 1e-9));
  int resting = 0;
  for (int k = 1; k <= steps; ++k) {
    world_.set_pull((phase.pull_grows ? k * h / phase.duration : 1.0) * pull_W);
    world_.step_to(base_pose(phase, start, k * h));
    steps_ += 1.0;
    if (phase.kind == PhaseKind::close && !closing.is_full()) {
      closing.look(closing_state(), h);
      drive(closing);
    }
    measure(X_HO, p_H, z, result.measure);
    resting = world_.object_speed() < kRestSpeed ? resting + 1 : 0;
    if (phase.kind == PhaseKind::settle && resting * h > kRestTime) break;
    if (world_.is_unstable()) break;
  }
  result.measure.in_contact = world_.in_contact();
  result.failure =
      world_.is_unstable() ? PhaseFailure::unstable : judged(result.measure, phase.fails);
  return result;
}

bool ShakeRun::run_phases(const std::vector<ProcedurePhase>& phases, ShakeTestResult& result) {
  for (const ProcedurePhase& phase : phases) {
    result.phases.push_back(run_phase(phase));
    if (!result.survived()) return false;
  }
  return true;
}

ShakeResult ShakeRun::run() {
  ShakeResult result;
  result.prepare.name = "prepare";
  if (run_phases(procedure_.prepare, result.prepare)) {
    world_.keep();
    for (const ProcedureTest& test : procedure_.tests) {
      world_.go_back();
      result.tests.push_back({.name = test.name, .phases = {}});
      run_phases(test.phases, result.tests.back());
    }
  }
  result.steps = steps_;
  result.opened = world_.opened();
  return result;
}

}  // namespace

ShakeSubject subject_of(const CompiledScene& scene) {
  ShakeSubject subject;
  const Hand& hand = *scene.scene.hand.hand;
  subject.R_HG << hand.closing, hand.approach.cross(hand.closing), hand.approach;
  subject.volume = mass_properties(scene.scene.object.mesh).volume;
  subject.hand = scene.scene.hand;
  subject.longest_edge = bounds(scene.scene.object.mesh).size().maxCoeff();
  return subject;
}

ShakeResult shake_in_mujoco(const std::string& mjcf, const TestProcedure& procedure,
                            const ShakeSubject& subject, const StartOptions& start) {
  return ShakeRun(mjcf, procedure, subject, start).run();
}

}  // namespace prehend::bench
