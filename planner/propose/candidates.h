// Proposes grasps: from the primitives of an object to the poses at which a hand is tried.
#pragma once

#include <string>
#include <vector>

#include "planner/propose/grasp_rules.h"
#include "sim/base/run_context.h"
#include "sim/base/settings.h"
#include "sim/geometry/primitive.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/trial.h"

namespace prehend {

struct CandidateOptions {
  GraspRuleOptions rules = {};
  // Two candidates closer than both of these with the same preshape are one.
  double duplicate_distance = 2e-3;  // m
  double duplicate_angle = 0.05;     // rad
  // At most this many, taken evenly over the list (>= 1).
  int max_candidates = 800;
  // Added to the way from the pre-grasp to the object, so that the hand starts clear of it [m].
  double start_clearance = 0.01;
};

template <SettingsOf<CandidateOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [rules, duplicate_distance, duplicate_angle, max_candidates, start_clearance] = options;
  visit("", rules);
  visit("duplicate_distance", duplicate_distance);
  visit("duplicate_angle", duplicate_angle);
  visit("max_candidates", max_candidates);
  visit("start_clearance", start_clearance);
}

struct ProposedGrasp {
  Candidate candidate;
  int primitive = 0;  // index into the primitives
  std::string rule;   // "box face", "cylinder side across", ...
};

// Why preshapes were left out, for the message when nothing is proposed.
struct Proposals {
  std::vector<ProposedGrasp> grasps;
  double smallest_width = 0.0;   // smallest size that a rule wanted to close on [m]
  double largest_opening = 0.0;  // largest size that a preshape takes [m]
};

// Every rule of every primitive with every preshape whose widths include the primitive's:
// - box: thumb and fingers on two opposite faces, approach along each of the four other directions;
// - cylinder: from the side, with the thumb across the axis or along it, and onto both ends;
// - sphere: from directions spread evenly over it.
// Each grasp is proposed with the thumb on either side, and at two depths: with the palm moving on
// until it touches, and with the target between the fingertips (Preshape::depth). Source: Miller,
// Knoop, Allen and Christensen 2003 (rules per primitive). Throws Cancelled.
Proposals propose_grasps(const CompiledScene& scene, const std::vector<Primitive>& primitives,
                         const CandidateOptions& options = {}, const RunContext& context = {});

}  // namespace prehend
