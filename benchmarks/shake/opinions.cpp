#include "benchmarks/shake/opinions.h"

#include <memory>
#include <utility>

#include "planner/show/exports/export_files.h"
#include "planner/show/exports/export_formats.h"
#include "sim/manipulation/shake.h"

namespace prehend::bench {
namespace {

std::vector<JointLock> locks_of(const RobotModel& hand) {
  std::vector<JointLock> locks;
  for (const Clutch& clutch : hand.clutches) {
    if (clutch.locks == 0.0) continue;
    for (const int joint : clutch.joints) {
      locks.push_back({hand.robot.joints[static_cast<std::size_t>(joint)].name, clutch.locks});
    }
  }
  return locks;
}

double between(double a, double b, double part) { return a + part * (b - a); }

// The grasp with the fingers a part of the way back to where they were before they closed.
GraspPosture opened_posture(const ShakeCase& shaken, const ShakenGrasp& grasp, double part) {
  GraspPosture posture = posture_of(grasp.grasp.trial);
  if (part == 0.0) return posture;
  const ExportGrasp exported = export_of(shaken.scene, grasp.grasp, grasp.rank);
  posture.joints = exported.closed_joints;
  for (std::size_t j = 0; j < posture.joints.size(); ++j) {
    posture.joints[j] = between(posture.joints[j], exported.pregrasp_joints[j], part);
  }
  const Candidate& candidate = grasp.grasp.candidate;
  const std::vector<double>& open =
      candidate.preshape
          ? shaken.scene.scene.hand.hand->preshapes[static_cast<std::size_t>(*candidate.preshape)]
                .dofs
          : candidate.dofs;
  for (std::size_t d = 0; d < posture.dofs.size(); ++d) {
    posture.dofs[d] = between(posture.dofs[d], open[d], part);
  }
  return posture;
}

// Failures are named in the order of ShakeOutcome.
PhaseFailure failure_of(ShakeOutcome outcome) {
  return kAll<PhaseFailure>[static_cast<std::size_t>(outcome)];
}

ShakeTestResult result_of(const ShakeTestReport& test) {
  ShakeTestResult result{.name = test.name, .phases = {}};
  for (const PhaseReport& phase : test.phases) {
    PhaseMeasure measure;
    measure.moved = phase.moved;
    measure.turned = phase.turned;
    measure.dropped = phase.sank;
    measure.rise = phase.rose;
    measure.in_contact = phase.touching > 0;
    result.phases.push_back({phase.kind, measure, PhaseFailure::none});
  }
  result.phases.back().failure = failure_of(test.outcome);
  return result;
}

// The hand without clutches: joints keep the way that they are behind others in this posture.
Robot without_clutches(Robot hand, const GraspPosture& posture) {
  for (DegreeOfFreedom& dof : hand.dofs) {
    if (dof.coupling == Coupling::breakaway) dof.coupling = Coupling::rigid;
  }
  for (std::size_t j = 0; j < hand.joints.size(); ++j) {
    Joint& joint = hand.joints[j];
    joint.offset =
        posture.joints[j] - joint.ratio * posture.dofs[static_cast<std::size_t>(joint.dof)];
  }
  return hand;
}

}  // namespace

ShakeResult in_prehend(const ShakeCase& shaken, const ShakenGrasp& grasp,
                       const TestProcedure& procedure, const OwnRun& run) {
  const GraspPosture posture = opened_posture(shaken, grasp, run.opened);
  const Robot& robot = shaken.scene.scene.hand;
  RobotModel hand = make_robot_model(run.clutches ? robot : without_clutches(robot, posture));
  if (!run.locks) {
    for (Clutch& clutch : hand.clutches) clutch.locks = 0.0;
  }
  TestProcedure with_step = procedure;
  with_step.step *= run.step;
  const ShakeReport report = shake_grasp(
      shaken.scene, std::make_shared<const RobotModel>(std::move(hand)), posture, with_step);
  ShakeResult result;
  result.prepare.name = "prepare";
  for (const ShakeTestReport& test : report.tests) {
    if (test.name == "prepare") {
      result.prepare = result_of(test);
    } else {
      result.tests.push_back(result_of(test));
    }
  }
  result.steps = report.effort.steps;
  result.opened = run.opened;
  return result;
}

MujocoCase mujoco_case(const ShakeCase& shaken, const ShakenGrasp& grasp,
                       const TestProcedure& procedure, const MujocoRun& run) {
  const RobotModel hand = make_robot_model(shaken.scene.scene.hand);
  ShakeSubject subject = subject_of(shaken.scene);
  MjcfOptions options;
  options.obstacles = procedure.on_support;
  options.time_step *= run.step;
  options.contact_time *= run.step;
  if (run.clutches) {
    options.clutches = hand.clutches;
    subject.locks = locks_of(hand);
  }
  const ExportGrasp exported = export_of(shaken.scene, grasp.grasp, grasp.rank);
  subject.strategy = exported.strategy;
  return {mjcf_text(shaken.scene, shaken.shapes, exported, options), std::move(subject)};
}

ShakeResult in_mujoco(const ShakeCase& shaken, const ShakenGrasp& grasp,
                      const TestProcedure& procedure, const MujocoRun& run) {
  const MujocoCase model = mujoco_case(shaken, grasp, procedure, run);
  return shake_in_mujoco(model.mjcf, procedure, model.subject, run.start);
}

std::vector<Opinion> opinions() {
  return {{"prehend",
           [](const ShakeCase& shaken, const ShakenGrasp& grasp, const TestProcedure& procedure) {
             return in_prehend(shaken, grasp, procedure);
           }},
          {"MuJoCo",
           [](const ShakeCase& shaken, const ShakenGrasp& grasp, const TestProcedure& procedure) {
             return in_mujoco(shaken, grasp, procedure);
           }}};
}

}  // namespace prehend::bench
