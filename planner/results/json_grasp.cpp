#include "planner/results/json_grasp.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "planner/results/json_contact.h"
#include "planner/results/json_posture.h"
#include "planner/results/json_shake.h"
#include "planner/results/json_trajectory.h"
#include "sim/base/index.h"
#include "sim/base/json/json_fields.h"
#include "sim/trial/approach_line.h"
#include "sim/trial/success.h"

namespace prehend {
namespace {

using Json = nlohmann::ordered_json;

// A grasp is written and read by the same visitors (json_fields.h). The order of the visitors in
// grasp_fields matters for reading: the pose gives the approach that approach_fields may replace,
// and pose, posture and approach together give the line that the arm has to follow.

ValueNames<LinkId> link_names(const CompiledScene& scene) {
  ValueNames<LinkId> names;
  for (const auto& link : scene.links) names.emplace_back(link.name, link_id(names.size()));
  return names;
}

ValueNames<int> preshape_names(const Hand& hand) {
  ValueNames<int> names;
  for (const Preshape& preshape : hand.preshapes) {
    names.emplace_back(preshape.name, static_cast<int>(names.size()));
  }
  return names;
}

void grasp_contact_fields(auto& fields, auto& contact, const ValueNames<LinkId>& links) {
  fields.needs("link");
  fields.named("link", contact.link, links);
  contact_fields(fields, contact.point);
  fields("gap", contact.gap);
}

void approach_fields(auto& fields, auto& grasp) {
  fields("direction", grasp.candidate.approach_O);
  const double length = grasp.candidate.approach_O.norm();
  fields.require("direction", length > kShortestDirection, "must not be zero");
  // Directions written by hand need not be unit and are normalised. One that is unit up to rounding
  // stays as it is, so that writing and reading back does not change any bit.
  if constexpr (kReads<decltype(fields)>) {
    if (std::abs(length - 1.0) > 1e-12) grasp.candidate.approach_O /= length;
  }
  fields("distance", grasp.candidate.approach_distance);
  fields.require("distance", grasp.candidate.approach_distance >= 0.0, "must not be negative");
  fields("travel", grasp.trial.travel);
  fields.require("travel", grasp.trial.travel >= 0.0, "must not be negative");
  fields("gave_way", grasp.trial.overlap_shift);
  fields("back_offs", grasp.trial.back_offs);
  fields("pushed", grasp.trial.pushed);
  fields("turned", grasp.trial.turned);
  fields("slid", grasp.trial.slid);
}

// "index", "shape" and "rule": the primitive that the grasp was proposed for.
void primitive_fields(auto& fields, auto& grasp, const std::vector<Primitive>& primitives) {
  for (const char* name : {"index", "rule"}) fields.needs(name);
  int place = grasp.primitive.value_or(-1);
  fields("index", place);
  fields.require("index", place >= 0 && place < static_cast<int>(primitives.size()),
                 "must be the place of one of the file's primitives");
  if constexpr (kReads<decltype(fields)>) grasp.primitive = place;
  fields.derived("shape", [&] { return shape_name(primitives[index(place)].shape); });
  fields("rule", grasp.rule);
}

void weakest_wrench_fields(auto& fields, auto& wrench) {
  for (const char* name : {"force", "torque"}) fields.needs(name);
  Vector3 force = wrench.template head<3>();
  Vector3 torque = wrench.template tail<3>();
  fields("force", force);
  fields("torque", torque);
  if constexpr (kReads<decltype(fields)>) wrench << force, torque;
}

// Written for information only: link and body are names, from which the trial is not rebuilt.
Json blocked_json(const CompiledScene& scene, const Trial& trial) {
  const CollisionNames blocked = collision_of(scene, trial);
  if (blocked.link.empty()) return nullptr;
  Json json = {{"link", blocked.link}, {"by", blocked.by}};
  if (trial.overlap) json["overlap"] = *trial.overlap;
  return json;
}

// Degrees of freedom for given joints. The joints of one degree of freedom may stand at different
// values of it, because a finger stops when it touches while others close on. The value that is
// farthest in the closing direction is taken.
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

// Where the hand starts, and where its fingers ended. In a file that prehend wrote "dofs" and
// "joints" are where they ended, and "preshape" is where they started; where that is null they
// started at "start_dofs". In other files the first of preshape, joints and dofs is where it
// starts.
struct PostureFields {
  const Robot& hand;

  void operator()(FieldWriter& fields, const ScoredGrasp& grasp) const {
    const std::optional<int>& preshape = grasp.candidate.preshape;
    if (preshape) {
      fields.named("preshape", *preshape, preshape_names(*hand.hand));
    } else {
      fields.derived("preshape", [] { return nullptr; });
      if (grasp.candidate.joints.empty()) fields("start_dofs", grasp.candidate.dofs);
    }
    fields("dofs", grasp.trial.dofs);
    fields("joints", grasp.trial.joints);
  }

  void operator()(FieldReader& fields, ScoredGrasp& grasp) const {
    Candidate& candidate = grasp.candidate;
    Trial& trial = grasp.trial;
    const JsonField field = fields.field();
    const bool has_preshape = fields.allow("preshape") && !field["preshape"].is_null();
    if (fields.allow("dofs")) trial.dofs = read_dofs(field["dofs"], hand);
    if (fields.allow("joints")) trial.joints = read_joints(field["joints"], hand);
    if (fields.allow("start_dofs")) candidate.dofs = read_dofs(field["start_dofs"], hand);
    if (has_preshape) {
      fields.named("preshape", candidate.preshape.emplace(), preshape_names(*hand.hand));
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
    // What is missing of the final posture: the fingers are where they start.
    if (trial.dofs.empty()) {
      trial.dofs =
          has_preshape ? hand.hand->preshapes[index(*candidate.preshape)].dofs : candidate.dofs;
    }
    if (trial.joints.empty()) trial.joints = joint_values(hand, trial.dofs);
  }
};

// "X_object_hand" is read, or else "X_world_hand".
struct PoseFields {
  const Pose& X_WO;
  const Hand& hand;

  void operator()(FieldWriter& fields, const ScoredGrasp& grasp) const {
    fields("X_object_hand", grasp.trial.X_OH);
    fields("X_world_hand", Pose(X_WO * hand_in_scene(grasp.trial)));
  }

  void operator()(FieldReader& fields, ScoredGrasp& grasp) const {
    const bool in_world = fields.allow("X_world_hand");
    if (fields.allow("X_object_hand")) {
      fields("X_object_hand", grasp.trial.X_OH);
    } else if (in_world) {
      Pose X_WH;
      fields("X_world_hand", X_WH);
      grasp.trial.X_OH = X_WO.inverse() * X_WH;
    } else {
      fields.field().fail("needs X_object_hand");
    }
    grasp.candidate.X_OH = grasp.trial.X_OH;
    grasp.candidate.approach_O = grasp.trial.X_OH.linear() * hand.approach;
  }
};

// Left out where it was not computed.
void nearby_field(auto& fields, auto& grasp) {
  if (!kReads<decltype(fields)> && !grasp.epsilon_nearby) return;
  fields.object("epsilon_nearby", [&](auto& inner) {
    Interval range = grasp.epsilon_nearby.value_or(Interval{});
    inner.needs("lowest");
    inner.needs("highest");
    inner("lowest", range.lower);
    inner("highest", range.upper);
    if constexpr (kReads<decltype(fields)>) grasp.epsilon_nearby = range;
  });
}

// Only of grasps that a refinement found.
void refinement_field(auto& fields, auto& grasp) {
  if (!kReads<decltype(fields)> && !grasp.refinement) return;
  fields.object("refinement", [&](auto& inner) {
    Refinement refinement = grasp.refinement.value_or(Refinement{});
    for (const char* name : {"gain", "trials"}) inner.needs(name);
    inner("gain", refinement.gain);
    inner("trials", refinement.trials);
    if constexpr (kReads<decltype(fields)>) grasp.refinement = refinement;
  });
}

// Written for information: a grasp that is read has to be shaken again.
void shake_field(auto& fields, auto& grasp) {
  if (!kReads<decltype(fields)> && !grasp.shake) return;
  fields.derived("shake", [&] { return shake_to_json(*grasp.shake); });
}

// No number is infinite in JSON: null stands for it.
Json finite(double number) { return std::isfinite(number) ? Json(number) : Json(); }

Json burden_to_json(const LoadCase& load_case) {
  return {{"down", {load_case.down_O.x(), load_case.down_O.y(), load_case.down_O.z()}},
          {"squeeze", finite(load_case.sum_of_normals)},
          {"largest_normal", finite(load_case.largest_normal)},
          {"strength", finite(load_case.strength)}};
}

// Written for information: what is read is computed again.
void holding_field(auto& fields, auto& grasp) {
  if (!kReads<decltype(fields)> && !grasp.holding) return;
  fields.derived("weight", [&] {
    return Json{{"holds", grasp.holding->holds()},
                {"given", burden_to_json(grasp.holding->given)},
                {"worst", burden_to_json(grasp.holding->worst)}};
  });
}

Json robustness_to_json(const Robustness& robustness) {
  const Interval interval = held_interval(robustness.held, robustness.samples);
  Json outcomes = Json::object();
  for (const Outcome outcome : kOutcomes) {
    const int count = robustness.outcomes[static_cast<std::size_t>(outcome)];
    if (count > 0) outcomes[outcome_name(outcome)] = count;
  }
  const Vector3& weakest = robustness.weakest_O;
  return {{"samples", robustness.samples},
          {"held", robustness.held},
          {"probability", robustness.probability()},
          {"success", success_probability(robustness)},
          {"strength", finite(robustness.strength)},
          {"interval", {interval.lower, interval.upper}},
          {"epsilon_mean", robustness.epsilon_mean},
          {"epsilon_low", robustness.epsilon_low},
          {"outcomes", outcomes},
          {"spare", robustness.position_margin},
          {"weakest", {weakest.x(), weakest.y(), weakest.z()}},
          {"weakest_outcome", outcome_name(robustness.weakest_end)}};
}

// Written for information, as the weight.
void robustness_field(auto& fields, auto& grasp) {
  if (!kReads<decltype(fields)> && !grasp.robustness) return;
  fields.derived("robustness", [&] { return robustness_to_json(*grasp.robustness); });
}

void outcome_fields(auto& fields, auto& grasp) {
  auto& trial = grasp.trial;
  double epsilon = trial.outcome == Outcome::stable ? trial.epsilon.lower : 0.0;
  fields.named("outcome", trial.outcome, value_names(kOutcomes, outcome_name));
  fields("epsilon", epsilon);
  fields("volume", grasp.volume);
  nearby_field(fields, grasp);
  holding_field(fields, grasp);
  robustness_field(fields, grasp);
  fields.derived("force_closure", [&] { return trial.outcome == Outcome::stable; });
  if constexpr (kReads<decltype(fields)>) {
    trial.epsilon.lower = epsilon;
    // A file of another program may have a quality but no outcome.
    if (fields.allow("epsilon") && !fields.allow("outcome")) {
      trial.outcome = epsilon > 0.0 ? Outcome::stable : Outcome::not_force_closure;
    }
  }
}

// Only of grasps that formed in time, on an object that gave way.
void object_moved_field(auto& fields, auto& grasp) {
  if (!kReads<decltype(fields)> && !grasp.trial.X_OC) return;
  if constexpr (kReads<decltype(fields)>) {
    if (!fields.allow("X_object_moved")) return;
    fields("X_object_moved", grasp.trial.X_OC.emplace());
  } else {
    fields("X_object_moved", *grasp.trial.X_OC);
  }
}

constexpr double kSamePosture = 1e-6;  // what rounding may change in the file [rad or m]

bool is_same(const DofValues& a, const DofValues& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return std::abs(x - y) <= kSamePosture; });
}

// A file without "arm_line" says only how the arm holds the hand in the end. An approach that ends
// in this posture is computed backwards from it; where there is none, the arm is shown in this
// posture only.
void read_arm(const JsonField& grasp, const CompiledArm& arm, const HandLine& line, Trial& trial) {
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

void arm_fields(auto& fields, auto& grasp, const CompiledScene& scene) {
  if constexpr (kReads<decltype(fields)>) {
    // Permitted in every scene, and ignored in one without an arm.
    for (const char* name : {"arm_dofs", "arm_line", "path", "lift"}) (void)fields.allow(name);
    if (!scene.arm) return;
    const JsonField& field = fields.field();
    read_arm(field, *scene.arm, approach_line(scene, grasp.candidate, grasp.trial), grasp.trial);
    if (field.has("path")) grasp.path = read_trajectory(field["path"], scene.arm->robot());
    fields.named("lift", grasp.lift, value_names(kLiftEnds, lift_end_name));
  } else {
    if (!grasp.trial.arm_dofs.empty()) fields("arm_dofs", grasp.trial.arm_dofs);
    if (!grasp.trial.arm_line.empty()) fields("arm_line", grasp.trial.arm_line);
    if (grasp.path) {
      fields.derived("path", [&] { return trajectory_to_json(*grasp.path); });
      fields.named("lift", grasp.lift, value_names(kLiftEnds, lift_end_name));
    }
  }
}

// Null where the grasp was not proposed for a primitive but given by the caller.
void primitive_field(auto& fields, auto& grasp, const std::vector<Primitive>& primitives) {
  bool proposed = grasp.primitive.has_value();
  if constexpr (kReads<decltype(fields)>) {
    proposed = fields.allow("primitive") && !fields.field()["primitive"].is_null();
    if (!proposed) grasp.rule = "given";
  }
  if (proposed) {
    fields.object("primitive", [&](auto& inner) { primitive_fields(inner, grasp, primitives); });
  } else {
    fields.derived("primitive", [] { return nullptr; });
  }
}

void grasp_fields(auto& fields, auto& grasp, const CompiledScene& scene,
                  const std::vector<Primitive>& primitives) {
  auto& trial = grasp.trial;
  outcome_fields(fields, grasp);
  PoseFields{scene.scene.object.X_WO, *scene.scene.hand.hand}(fields, grasp);
  PostureFields{scene.scene.hand}(fields, grasp);
  const ValueNames<LinkId> links = link_names(scene);
  fields.objects("contacts", trial.contacts,
                 [&](auto& inner, auto& contact) { grasp_contact_fields(inner, contact, links); });
  fields.derived("torque_origin", [&] { return vector_to_json(scene.wrench_frame.torque_origin); });
  fields.derived("torque_scale", [&] { return scene.wrench_frame.torque_scale; });
  fields.object("weakest_wrench",
                [&](auto& inner) { weakest_wrench_fields(inner, trial.epsilon.weakest); });
  primitive_field(fields, grasp, primitives);
  refinement_field(fields, grasp);
  shake_field(fields, grasp);
  fields.object("approach", [&](auto& inner) { approach_fields(inner, grasp); });
  fields.derived("blocked", [&] { return blocked_json(scene, trial); });
  object_moved_field(fields, grasp);
  arm_fields(fields, grasp, scene);
}

}  // namespace

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

}  // namespace prehend
