#include "planner/results/json_grasp.h"

#include "planner/results/grasp_fields.h"
#include "sim/base/json/field_schema.h"

namespace prehend {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kSamePosture = 1e-6;  // what rounding may change in the file [rad or m]

bool is_same(const DofValues& a, const DofValues& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return std::abs(x - y) <= kSamePosture; });
}

// A file without "arm_line" says only how the arm holds the hand in the end. An approach that ends
// in this posture is computed backwards from it; where there is none, the arm is shown in this
// posture only.
void read_arm_line(const JsonField& grasp, const CompiledArm& arm, const HandLine& line,
                   Trial& trial) {
  if (grasp.has("arm_dofs")) trial.arm_dofs = read_dofs(grasp["arm_dofs"], arm.robot());
  if (grasp.has("arm_line")) {
    const JsonField field = grasp["arm_line"];
    for (const JsonField& item : field.items()) {
      trial.arm_line.push_back(read_dofs(item, arm.robot()));
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

std::vector<double> dofs_of_joints(const std::vector<double>& joints, const Robot& hand) {
  std::vector<double> dofs = initial_dofs(hand);
  std::vector<bool> known(dofs.size(), false);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = hand.joints[j];
    const auto d = static_cast<std::size_t>(joint.dof);
    const double value = (joints[j] - joint.offset) / joint.ratio;
    const double v = hand.dofs[d].closing_velocity;
    if (!known[d] || (value - dofs[d]) * (v < 0.0 ? -1.0 : 1.0) > 0.0) dofs[d] = value;
    known[d] = true;
  }
  return dofs;
}

void read_posture(FieldReader& fields, ScoredGrasp& grasp, const Robot& hand) {
  Candidate& candidate = grasp.candidate;
  Trial& trial = grasp.trial;
  const JsonField field = fields.field();
  const bool has_preshape = fields.allow("preshape") && !field["preshape"].is_null();
  if (fields.allow("dofs")) trial.dofs = read_dofs(field["dofs"], hand);
  if (fields.allow("joints")) trial.joints = read_joints(field["joints"], hand);
  if (fields.allow("start_dofs")) candidate.dofs = read_dofs(field["start_dofs"], hand);
  if (has_preshape) {
    fields.named("preshape", candidate.preshape.emplace(), names_of(hand.hand->preshapes));
  } else if (!candidate.dofs.empty()) {
    if (trial.dofs.empty()) trial.dofs = candidate.dofs;
  } else if (!trial.joints.empty()) {
    candidate.joints = trial.joints;
    candidate.dofs = trial.dofs.empty() ? dofs_of_joints(trial.joints, hand) : trial.dofs;
  } else if (!trial.dofs.empty()) {
    candidate.dofs = trial.dofs;
  } else {
    field.fail("needs a preshape, dofs or joints");
  }
  if (fields.allow("strategy") && !field["strategy"].is_null()) {
    fields.named("strategy", candidate.strategy.emplace(), names_of(hand.hand->strategies));
  }
  // What is missing of the final posture: the fingers are where they start.
  if (trial.dofs.empty()) {
    trial.dofs =
        has_preshape ? hand.hand->preshapes[index(*candidate.preshape)].dofs : candidate.dofs;
  }
  if (trial.joints.empty()) trial.joints = joint_values(hand, trial.dofs);
}

void read_pose(FieldReader& fields, ScoredGrasp& grasp, const Scene& scene) {
  const bool in_world = fields.allow("X_world_hand");
  if (fields.allow("X_object_hand")) {
    fields("X_object_hand", grasp.trial.X_OH);
  } else if (in_world) {
    Pose X_WH;
    fields("X_world_hand", X_WH);
    grasp.trial.X_OH = scene.object.X_WO.inverse() * X_WH;
  } else {
    fields.field().fail("needs X_object_hand");
  }
  grasp.candidate.X_OH = grasp.trial.X_OH;
  grasp.candidate.approach_O = grasp.trial.X_OH.linear() * scene.hand.hand->approach;
}

void read_arm(FieldReader& fields, ScoredGrasp& grasp, const CompiledScene& scene) {
  // Permitted in every scene, and ignored in one without an arm.
  for (const char* name : {"arm_dofs", "arm_line", "path", "lift"}) (void)fields.allow(name);
  if (!scene.arm) return;
  const JsonField& field = fields.field();
  read_arm_line(field, *scene.arm, approach_line(scene, grasp.candidate, grasp.trial), grasp.trial);
  if (field.has("path")) grasp.path = read_trajectory(field["path"], scene.arm->robot());
  fields("lift", grasp.lift);
}

Json grasp_to_json(const ScoredGrasp& grasp, const CompiledScene& scene,
                   const std::vector<Primitive>& primitives) {
  FieldWriter fields;
  grasp_fields(fields, grasp, scene, primitives);
  return std::move(fields).json();
}

ReadGrasp read_grasp(const JsonField& field, const CompiledScene& scene,
                     const std::vector<Primitive>& primitives) {
  ReadGrasp read;
  FieldReader fields(field);
  grasp_fields(fields, read.grasp, scene, primitives);
  fields.finish();
  read.judged = field.has("outcome") || field.has("epsilon");
  return read;
}

Json grasp_schema() {
  CompiledScene scene;
  scene.scene.hand.hand.emplace();
  const ScoredGrasp grasp;
  FieldSchema fields;
  grasp_fields(fields, grasp, scene, {});
  return std::move(fields).json();
}

}  // namespace prehend
