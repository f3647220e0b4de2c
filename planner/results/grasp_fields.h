// The fields of a grasp, once for all: of an entry of "grasps" in a grasp file
// (docs/reference/grasps-file.md), of its schema and of the grasps in Python. They are
// visited as in json_fields.h, by
// - FieldWriter and FieldReader, so that writing and reading cannot differ,
// - FieldSchema, which writes down names and types,
// - the writer of Python's dictionaries (planner/python/dictionary_writer.h).
// `grasp` is a ScoredGrasp, mutable for a FieldReader.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "planner/plan/plan_result.h"
#include "planner/results/json_contact.h"
#include "planner/results/json_posture.h"
#include "planner/results/json_trajectory.h"
#include "planner/results/shake_fields.h"
#include "sim/base/index.h"
#include "sim/base/json/json_fields.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/seen_surface.h"
#include "sim/trial/approach_line.h"
#include "sim/trial/success.h"

namespace prehend {

// A list that is left out where it is empty.
template <typename T>
std::optional<std::vector<T>> unless_empty(const std::vector<T>& values) {
  return values.empty() ? std::nullopt : std::optional(values);
}

inline ValueNames<LinkId> link_names(const CompiledScene& scene) {
  ValueNames<LinkId> names;
  for (const auto& link : scene.links) names.emplace_back(link.name, link_id(names.size()));
  return names;
}

// Of the preshapes or the closing strategies of a hand.
ValueNames<int> names_of(const auto& of_hand) {
  ValueNames<int> names;
  for (const auto& one : of_hand) names.emplace_back(one.name, static_cast<int>(names.size()));
  return names;
}

void grasp_contact_fields(auto& fields, auto& contact, const CompiledScene& scene,
                          const ValueNames<LinkId>& links) {
  fields.needs("link");
  fields.named("link", contact.link, links);
  contact_fields(fields, contact.point);
  fields("gap", contact.gap);
  // Only of an object that was seen in part; not read, it follows from the position.
  std::optional<bool> seen;
  if constexpr (!kReads<decltype(fields)>) seen = is_seen_at(scene, contact.point.position);
  fields("seen", seen);
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

// The primitive that the grasp was proposed for: null where it was given by the caller.
void primitive_field(auto& fields, auto& grasp, const std::vector<Primitive>& primitives) {
  if constexpr (kReads<decltype(fields)>) {
    if (!fields.allow("primitive") || fields.field()["primitive"].is_null()) {
      grasp.rule = "given";
      return;
    }
  }
  fields.object_or_null("primitive", grasp.primitive.has_value(), [&](auto& inner) {
    for (const char* name : {"index", "rule"}) inner.needs(name);
    int place = grasp.primitive.value_or(-1);
    inner("index", place);
    inner.require("index", place >= 0 && place < static_cast<int>(primitives.size()),
                  "must be the place of one of the file's primitives");
    if constexpr (kReads<decltype(fields)>) grasp.primitive = place;
    inner.derived("shape", [&] { return std::string(shape_name(primitives[index(place)].shape)); });
    inner("rule", grasp.rule);
  });
}

void weakest_wrench_fields(auto& fields, auto& wrench) {
  for (const char* name : {"force", "torque"}) fields.needs(name);
  Vector3 force = wrench.template head<3>();
  Vector3 torque = wrench.template tail<3>();
  fields("force", force);
  fields("torque", torque);
  if constexpr (kReads<decltype(fields)>) wrench << force, torque;
}

// For information: link and body are names, from which the trial is not rebuilt.
void blocked_field(auto& fields, const Trial& trial, const CompiledScene& scene) {
  if constexpr (kReads<decltype(fields)>) {
    (void)fields.allow("blocked");
  } else {
    const CollisionNames names = collision_of(scene, trial);
    fields.object_or_null("blocked", !names.link.empty(), [&](auto& inner) {
      inner("link", names.link);
      inner("by", names.by);
      inner("overlap", trial.overlap);
    });
  }
}

// Degrees of freedom for given joints. The joints of one degree of freedom may stand at different
// values of it, because a finger stops when it touches while others close on. The value that is
// farthest in the closing direction is taken.
std::vector<double> dofs_of_joints(const std::vector<double>& joints, const Robot& hand);

// Reads where the hand starts and where its fingers ended. In a file that prehend wrote "dofs" and
// "joints" are where they ended, and "preshape" is where they started; where that is null they
// started at "start_dofs". In other files the first of preshape, joints and dofs is where it
// starts.
void read_posture(FieldReader& fields, ScoredGrasp& grasp, const Robot& hand);

void posture_fields(auto& fields, auto& grasp, const Robot& hand) {
  if constexpr (kReads<decltype(fields)>) {
    read_posture(fields, grasp, hand);
  } else {
    const Candidate& candidate = grasp.candidate;
    fields.named_or_null("preshape", candidate.preshape, names_of(hand.hand->preshapes));
    fields.named_or_null("strategy", candidate.strategy, names_of(hand.hand->strategies));
    const bool by_dofs = !candidate.preshape && candidate.joints.empty();
    fields("start_dofs", by_dofs ? std::optional(candidate.dofs) : std::nullopt);
    fields("dofs", grasp.trial.dofs);
    fields("joints", grasp.trial.joints);
  }
}

// "X_object_hand" is read, or else "X_world_hand".
void read_pose(FieldReader& fields, ScoredGrasp& grasp, const Scene& scene);

void pose_fields(auto& fields, auto& grasp, const Scene& scene) {
  if constexpr (kReads<decltype(fields)>) {
    read_pose(fields, grasp, scene);
  } else {
    fields("X_object_hand", grasp.trial.X_OH);
    fields("X_world_hand", Pose(scene.object.X_WO * hand_in_scene(grasp.trial)));
  }
}

// What it takes to hold the weight in one attitude (LoadCase).
void load_case_fields(auto& fields, auto& load_case) {
  fields("down", load_case.down_O);
  fields.unbounded("squeeze", load_case.sum_of_normals);
  fields.unbounded("largest_normal", load_case.largest_normal);
  fields.unbounded("strength", load_case.strength);
}

void robustness_fields(auto& fields, auto& robustness) {
  fields("samples", robustness.samples);
  fields("held", robustness.held);
  fields.derived("probability", [&] { return robustness.probability(); });
  fields.derived("success", [&] { return success_probability(robustness); });
  fields.unbounded("strength", robustness.strength);
  fields.derived("interval", [&] {
    const Interval interval = held_interval(robustness.held, robustness.samples);
    return std::array{interval.lower, interval.upper};
  });
  fields("epsilon_mean", robustness.epsilon_mean);
  fields("epsilon_low", robustness.epsilon_low);
  fields.counts("outcomes", robustness.outcomes);
  fields("spare", robustness.position_margin);
  fields("weakest", robustness.weakest_O);
  fields("weakest_outcome", robustness.weakest_end);
  fields.derived_part("free", robustness.free, [](auto& inner, auto& free) {
    inner("kept", free.kept);
    inner("epsilon", free.epsilon);
    inner.unbounded("strength", free.strength);
    inner("moved", free.moved);
  });
}

void pad_patch_fields(auto& fields, auto& patch, const ValueNames<LinkId>& links) {
  fields.named("link", patch.link, links);
  fields("nodes", patch.nodes);
  fields("approach", patch.approach);
  fields("load", patch.surface.load);
  fields("center", patch.surface.center);
  fields("normal", patch.surface.normal);
  fields("torsion", patch.surface.torsion);
  fields("fitted_torsion", patch.surface.fitted_torsion);
  fields("fit_error", patch.surface.error);
}

// The pads of a grasp: what each bears, and how stiffly they hold the object together.
void pads_fields(auto& fields, auto& pads, const ValueNames<LinkId>& links) {
  fields("softest", pads.softest);
  fields.objects("patches", pads.patches,
                 [&](auto& inner, auto& patch) { pad_patch_fields(inner, patch, links); });
}

// What was measured of the grasp. Weight and robustness are not read: they are computed again.
void measure_fields(auto& fields, auto& grasp) {
  fields("volume", grasp.volume);
  fields.part("epsilon_nearby", grasp.epsilon_nearby, [](auto& inner, auto& range) {
    for (const char* name : {"lowest", "highest"}) inner.needs(name);
    inner("lowest", range.lower);
    inner("highest", range.upper);
  });
  fields.derived_part("weight", grasp.holding, [](auto& inner, auto& holding) {
    inner.derived("holds", [&] { return holding.holds(); });
    inner.object("given", [&](auto& given) { load_case_fields(given, holding.given); });
    inner.object("worst", [&](auto& worst) { load_case_fields(worst, holding.worst); });
  });
  fields.derived_part("robustness", grasp.robustness,
                      [](auto& inner, auto& robustness) { robustness_fields(inner, robustness); });
}

void outcome_fields(auto& fields, auto& grasp, const CompiledScene& scene) {
  auto& trial = grasp.trial;
  double epsilon = trial.outcome == Outcome::stable ? trial.epsilon.lower : 0.0;
  fields("outcome", trial.outcome);
  fields("epsilon", epsilon);
  measure_fields(fields, grasp);
  fields.derived("force_closure", [&] { return trial.outcome == Outcome::stable; });
  // Only of scenes with such regions.
  std::optional<bool> preferred;
  if (!scene.preferred.empty()) preferred = trial.preferred;
  fields("preferred", preferred);
  if constexpr (kReads<decltype(fields)>) {
    trial.epsilon.lower = epsilon;
    trial.preferred = preferred.value_or(false);
    // A file of another program may have a quality but no outcome.
    if (fields.allow("epsilon") && !fields.allow("outcome")) {
      trial.outcome = epsilon > 0.0 ? Outcome::stable : Outcome::not_force_closure;
    }
  }
}

// Reads "arm_dofs", "arm_line", "path" and "lift", which are ignored in a scene without an arm.
void read_arm(FieldReader& fields, ScoredGrasp& grasp, const CompiledScene& scene);

void arm_fields(auto& fields, auto& grasp, const CompiledScene& scene) {
  if constexpr (kReads<decltype(fields)>) {
    read_arm(fields, grasp, scene);
  } else {
    fields("arm_dofs", unless_empty(grasp.trial.arm_dofs));
    fields("arm_line", unless_empty(grasp.trial.arm_line));
    fields.part("path", grasp.path,
                [](auto& inner, auto& path) { trajectory_fields(inner, path); });
    fields("lift", grasp.path ? std::optional(grasp.lift) : std::nullopt);
  }
}

// The order matters for reading: the pose gives the approach that approach_fields may replace, and
// pose, posture and approach together give the line that the arm has to follow.
void grasp_fields(auto& fields, auto& grasp, const CompiledScene& scene,
                  const std::vector<Primitive>& primitives) {
  auto& trial = grasp.trial;
  outcome_fields(fields, grasp, scene);
  pose_fields(fields, grasp, scene.scene);
  posture_fields(fields, grasp, scene.scene.hand);
  const ValueNames<LinkId> links = link_names(scene);
  fields.objects("contacts", trial.contacts, [&](auto& inner, auto& contact) {
    grasp_contact_fields(inner, contact, scene, links);
  });
  // A grasp that is read has to be pressed again.
  fields.derived_part("pads", grasp.pads,
                      [&](auto& inner, auto& pads) { pads_fields(inner, pads, links); });
  fields.derived("torque_origin", [&] { return scene.wrench_frame.torque_origin; });
  fields.derived("torque_scale", [&] { return scene.wrench_frame.torque_scale; });
  fields.object("weakest_wrench",
                [&](auto& inner) { weakest_wrench_fields(inner, trial.epsilon.weakest); });
  primitive_field(fields, grasp, primitives);
  // Only of grasps that a refinement found.
  fields.part("refinement", grasp.refinement, [](auto& inner, auto& refinement) {
    for (const char* name : {"gain", "trials"}) inner.needs(name);
    inner("gain", refinement.gain);
    inner("trials", refinement.trials);
  });
  // How it ends on an object that is free to move; a grasp that is read has to be closed again.
  fields.derived_part("free", grasp.free, [](auto& inner, auto& free) {
    inner("outcome", free.outcome);
    inner.derived("epsilon",
                  [&] { return free.outcome == Outcome::stable ? free.epsilon.lower : 0.0; });
    inner("X_object_hand", free.X_OH);
    inner("X_object_moved", free.X_OC);
    inner("joints", free.joints);
  });
  // On which shapes of an object that was seen in part it holds; a grasp that is read has to be
  // planned again.
  fields.derived_part("shapes", grasp.shapes, [](auto& inner, auto& shapes) {
    inner("likely", shapes.likely);
    inner("thin", shapes.thin);
    inner("thick", shapes.thick);
    inner.derived("held", [&] { return shapes.held(); });
    inner("unseen", shapes.unseen);
    inner("certainty", shapes.certainty);
  });
  // A grasp that is read has to be shaken again.
  fields.derived_part("shake", grasp.shake,
                      [](auto& inner, auto& shake) { shake_fields(inner, shake); });
  fields.object("approach", [&](auto& inner) { approach_fields(inner, grasp); });
  blocked_field(fields, trial, scene);
  // Only of grasps that formed in time, on an object that moved.
  fields("X_object_moved", trial.X_OC);
  arm_fields(fields, grasp, scene);
}

}  // namespace prehend
