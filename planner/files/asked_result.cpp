#include "planner/files/asked_result.h"

#include <algorithm>
#include <cmath>

#include "planner/files/asked_path.h"

namespace prehend {
namespace {

// The posture that the file gives: where the fingers ended if it says so, else the preshape.
std::vector<double> posture(const JsonField& grasp, const Candidate& candidate,
                            const Robot& robot) {
  if (grasp.has("joints")) return grasp["joints"].numbers(robot.joints.size());
  if (!candidate.joints.empty()) return candidate.joints;
  if (!candidate.preshape) return joint_values(robot, candidate.dofs);
  if (grasp.has("dofs")) return joint_values(robot, grasp["dofs"].numbers(robot.dofs.size()));
  const auto p = static_cast<std::size_t>(*candidate.preshape);
  return joint_values(robot, robot.hand->preshapes[p].dofs);
}

Wrench weakest_of(const JsonField& grasp) {
  Wrench wrench = Wrench::Zero();
  if (!grasp.has("weakest_wrench")) return wrench;
  wrench.head<3>() = grasp["weakest_wrench"]["force"].vector3();
  wrench.tail<3>() = grasp["weakest_wrench"]["torque"].vector3();
  return wrench;
}

void read_approach(const JsonField& approach, ScoredGrasp& result) {
  if (approach.has("direction")) {
    const Vector3 direction = approach["direction"].vector3();
    if (!(direction.norm() > 0.0)) approach["direction"].fail("must not be zero");
    result.candidate.approach_O = direction.normalized();
  }
  result.trial.travel = approach.number_or("travel", 0.0);
  if (result.trial.travel < 0.0) approach["travel"].fail("must not be negative");
}

Outcome outcome_named(const std::string& name) {
  for (const Outcome outcome : kOutcomes) {
    if (outcome_name(outcome) == name) return outcome;
  }
  return Outcome::no_contact;
}

constexpr double kSamePosture = 1e-6;  // what rounding may change in the file [rad or m]

bool is_same(const DofValues& a, const DofValues& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return std::abs(x - y) <= kSamePosture; });
}

// A file without "arm_line" says only how the arm holds the hand in the end: the approach that ends
// so is found again.
void read_arm(const JsonField& grasp, const CompiledArm& arm, const HandLine& line, Trial& trial) {
  if (grasp.has("arm_dofs")) trial.arm_dofs = asked_dofs(grasp["arm_dofs"], arm.robot());
  if (grasp.has("arm_line")) {
    const JsonField field = grasp["arm_line"];
    for (const JsonField& item : field.items()) {
      trial.arm_line.push_back(asked_dofs(item, arm.robot()));
    }
    if (trial.arm_line.empty()) field.fail("must not be empty");
    if (trial.arm_dofs.empty()) trial.arm_dofs = trial.arm_line.back();
    if (!is_same(trial.arm_line.back(), trial.arm_dofs)) field.fail("must end at arm_dofs");
  } else if (!trial.arm_dofs.empty()) {
    trial.arm_line = line_ending_in(arm, line, trial.arm_dofs, ReachOptions{});
    if (trial.arm_line.empty()) trial.arm_line = {trial.arm_dofs};
  }
}

}  // namespace

ScoredGrasp asked_result(const JsonField& grasp, const AskedGrasp& asked,
                         const CompiledScene& scene) {
  ScoredGrasp result;
  result.candidate = asked.candidate;
  Trial& trial = result.trial;
  trial.X_OH = asked.candidate.X_OH;
  trial.joints = posture(grasp, asked.candidate, scene.scene.hand);
  trial.contacts = asked.contacts;
  trial.epsilon.weakest = weakest_of(grasp);
  trial.epsilon.lower = grasp.number_or("epsilon", 0.0);
  if (grasp.has("outcome")) trial.outcome = outcome_named(grasp["outcome"].text());
  result.volume = grasp.number_or("volume", 0.0);
  if (grasp.has("approach")) read_approach(grasp["approach"], result);
  if (!scene.arm) return result;
  read_arm(grasp, *scene.arm, approach_line(scene, result.candidate, trial), trial);
  if (grasp.has("path")) result.path = asked_path(grasp["path"], scene.arm->robot());
  return result;
}

}  // namespace prehend
