#include <algorithm>
#include <utility>

#include "planner/live/session.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/joined.h"
#include "sim/base/range.h"
#include "sim/trial/approach.h"
#include "sim/trial/grasp_contacts.h"
#include "sim/trial/run_trial.h"

// What a session does with its hand.
namespace prehend {

TrialOptions Session::trial_options() const {
  TrialOptions options;
  options.contacts = state_.switches.soft_fingers ? ContactKind::soft : ContactKind::hard;
  return options;
}

// The hand as it is, as the end of a trial that nothing is known of.
Trial Session::as_trial() const {
  Trial trial;
  trial.X_OH = state_.hand.X_OH;
  trial.dofs = state_.hand.dofs;
  trial.joints = state_.hand.joints;
  return trial;
}

HandMotion Session::go(const HandPosture& to, const std::optional<Dragged>& dragged) {
  HandMotion motion;
  motion.posture = to;
  if (state_.switches.stop_at_contact && state_.world->is_ready()) {
    motion = move_to_contact(state_.world->compiled(), state_.hand, to, trial_options());
  }
  SessionState next = state_;
  next.hand = motion.posture;
  next.outcome.reset();
  next.grasp.reset();
  settle_arm(next);
  push(std::move(next), dragged);
  return motion;
}

HandMotion Session::move_hand(const Pose& X_OH, Gesture gesture) {
  // Motions that follow each other must not lead farther and farther away either.
  require_place(X_OH);
  require_place(state_.world->X_WO() * X_OH);
  HandPosture to = state_.hand;
  to.X_OH = X_OH;
  if (!gesture) return go(to);
  return go(to, Dragged{*gesture, "hand"});
}

HandMotion Session::go_to_dofs(std::vector<double> dofs, const std::optional<Dragged>& dragged) {
  const Robot& hand = state_.world->scene().hand;
  for (std::size_t d = 0; d < dofs.size(); ++d) {
    dofs[d] = std::clamp(dofs[d], hand.dofs[d].lower, hand.dofs[d].upper);
  }
  HandPosture to = state_.hand;
  to.joints = joint_values(hand, dofs);
  // Joints of a degree of freedom that is not asked to move stay where contact stopped them.
  for (std::size_t j = 0; j < to.joints.size(); ++j) {
    const std::size_t d = index(hand.joints[j].dof);
    if (dofs[d] == state_.hand.dofs[d]) to.joints[j] = state_.hand.joints[j];
  }
  to.dofs = std::move(dofs);
  return go(to, dragged);
}

HandMotion Session::set_dofs(const std::vector<double>& dofs, Gesture gesture) {
  require(dofs.size() == state_.hand.dofs.size(),
          {.field = "dofs",
           .problem = "must have " + std::to_string(state_.hand.dofs.size()) + " numbers",
           .value = std::to_string(dofs.size())});
  if (!gesture) return go_to_dofs(dofs);
  return go_to_dofs(dofs, Dragged{*gesture, "dofs"});
}

HandMotion Session::take_preshape(const std::string& name) {
  const std::vector<Preshape>& preshapes = state_.world->scene().hand.hand->preshapes;
  const auto found = std::find_if(preshapes.begin(), preshapes.end(),
                                  [&](const Preshape& preshape) { return preshape.name == name; });
  const std::string known = joined(preshapes, ", ", &Preshape::name);
  require(found != preshapes.end(),
          {.field = "preshape", .problem = "must be one of " + known, .value = name});
  return go_to_dofs(found->dofs);
}

HandMotion Session::open_hand() {
  return go_to_dofs(opened_dofs(state_.world->scene().hand, state_.hand.dofs));
}

HandMotion Session::back_off(double distance) {
  require_in(kDistance, distance, "distance");
  const Vector3& approach_H = state_.world->scene().hand.hand->approach;
  return move_hand(state_.hand.X_OH * translation(-distance * approach_H));
}

HandMotion Session::approach(double distance) {
  require_in(kDistance, distance, "distance");
  const CompiledScene& scene = state_.world->compiled();
  const Vector3 approach_O = state_.hand.X_OH.linear() * scene.scene.hand.hand->approach;
  const ApproachMotion motion{translation(distance * approach_O) * state_.hand.X_OH, approach_O,
                              distance};
  const ApproachResult reached =
      prehend::approach(scene, state_.hand.joints, motion, trial_options());
  HandMotion moved{MotionEnd::arrived, 0.0, state_.hand, "", ""};
  if (reached.end == ApproachEnd::stand_off) return moved;
  moved.link = scene.links[index(reached.touch->link)].name;
  moved.by = scene.body(reached.touch->body).name;
  moved.end = MotionEnd::starts_in_collision;
  if (reached.end == ApproachEnd::starts_in_collision) return moved;
  moved.end = MotionEnd::touched;
  moved.share = distance > 0.0 ? reached.travel / distance : 0.0;
  moved.posture.X_OH = motion.at(reached.travel);
  SessionState next = state_;
  next.hand = moved.posture;
  next.outcome.reset();
  next.grasp.reset();
  settle_arm(next);
  push(std::move(next));
  return moved;
}

Trial Session::auto_grasp() {
  const CompiledScene& scene = state_.world->compiled();
  Candidate candidate;
  candidate.X_OH = state_.hand.X_OH;
  candidate.approach_O = state_.hand.X_OH.linear() * scene.scene.hand.hand->approach;
  candidate.dofs = state_.hand.dofs;
  candidate.joints = state_.hand.joints;
  TrialWorkspace workspace;
  Trial trial;
  run_hand_trial(scene, candidate, trial_options(), workspace, trial, {});
  SessionState next = state_;
  next.outcome = trial.outcome;
  next.grasp.reset();
  if (trial.outcome != Outcome::hand_blocked) {
    next.hand = {hand_in_scene(trial), trial.dofs, trial.joints};
    settle_arm(next);
  }
  if (trial.outcome == Outcome::stable) {
    next.grasp = std::make_shared<const TriedGrasp>(
        grasp_taken_back(scene, next.hand, candidate.dofs, trial_options()));
  }
  push(std::move(next));
  return trial;
}

std::vector<GraspContact> Session::contacts() const {
  return grasp_contacts(state_.world->compiled(), state_.hand.X_OH, state_.hand.joints,
                        trial_options());
}

GraspScore Session::quality(bool sections) const {
  return judge_grasp_of(state_.world->compiled(), as_trial(), trial_options(), state_.judge,
                        sections);
}

ContactForces Session::forces(const Vector3& force_O, const Vector3& torque_O,
                              bool joint_limits) const {
  Trial trial = as_trial();
  trial.contacts = contacts();
  return forces_for(state_.world->compiled(), trial, force_O, torque_O, joint_limits);
}

std::vector<Overlap> Session::collisions() const {
  const CompiledScene& scene = state_.world->compiled();
  std::vector<Overlap> found = overlaps_of(scene, state_.hand.X_OH, state_.hand.joints);
  if (!scene.arm || !state_.arm || !state_.arm->holds_hand) return found;
  const std::vector<double> joints = arm_joints(*scene.arm, state_.arm->dofs, state_.hand.joints);
  for (const Overlap& overlap : arm_overlaps(*scene.arm, joints)) found.push_back(overlap);
  return found;
}

}  // namespace prehend
