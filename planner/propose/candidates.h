// Candidate generation: from the primitives of an object to the hand poses and preshapes to try.
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

// How candidates are generated and thinned out.
struct CandidateOptions {
  GraspRuleOptions rules = {};
  // Two candidates with the same preshape are duplicates, and only the first is kept, when their
  // hand poses are no farther apart than both of these.
  double duplicate_distance = 2e-3;  // m
  double duplicate_angle = 0.05;     // rad
  // At most this many candidates are kept, picked evenly from the list of all (>= 1).
  int max_candidates = 800;
  // Smallest distance, along the approach, between hand and object at the pre-grasp [m].
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

// A candidate, and what it was derived from.
struct ProposedGrasp {
  Candidate candidate;
  int primitive = 0;  // index into the primitives
  std::string rule;   // "box faces", "cylinder end", ...: see AimedGrasp::rule
};

// The candidates, and two sizes that explain why there may be none: rules whose width no preshape
// takes give no candidate.
struct Proposals {
  std::vector<ProposedGrasp> grasps;
  int in_all = 0;                // number of candidates before they were thinned out
  double smallest_width = 0.0;   // smallest width of all rules; infinite without any rule [m]
  double largest_opening = 0.0;  // largest max_width of the hand's preshapes [m]
};

// Combines every rule of every primitive with every preshape whose range of widths includes the
// width that the rule closes on:
// - box: thumb and fingers on two opposite faces, approach along each of the four other directions;
// - cylinder: from the side, with the thumb across the axis or along it, and onto both ends;
// - sphere: from directions spread evenly over it.
// Each grasp is proposed with the thumb on either side, and at two depths: aimed with the hand's
// origin at the target, so that the palm moves on until it touches, and stopping short by
// Preshape::depth, so that the target is between the fingertips. Source: Miller, Knoop, Allen and
// Christensen 2003 (rules per primitive). Throws Cancelled.
Proposals propose_grasps(const CompiledScene& scene, const std::vector<Primitive>& primitives,
                         const CandidateOptions& options = {}, const RunContext& context = {});

}  // namespace prehend
