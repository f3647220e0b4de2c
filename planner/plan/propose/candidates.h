// Candidate generation: from the primitives of an object to the hand poses and preshapes to try.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planner/plan/propose/approach_limit.h"
#include "sim/base/run_context.h"
#include "sim/base/settings.h"
#include "sim/trial/candidate.h"

namespace prehend {

struct CompiledScene;
struct Primitive;

// Two candidates with the same preshape are duplicates, and only the first is proposed, when their
// hand poses are no farther apart than both of these, halved at each level of detail.
inline constexpr double kDuplicateDistance = 2e-3;  // m
inline constexpr double kDuplicateAngle = 0.05;     // rad

struct CandidateOptions {
  static constexpr AboutSettings kAbout{"CandidateOptions", "How candidates are generated."};
  double start_clearance = 0.01;
  std::optional<ApproachLimit> approach = {};
};

template <SettingsOf<CandidateOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [start_clearance, approach] = options;
  visit("start_clearance", start_clearance, kDistance, "m",
        "Smallest distance, along the approach, between hand and object at the pre-grasp.");
  visit.unlisted("approach", approach,
                 "Set: the directions in which hands may move to the object, of candidates and of "
                 "what they are improved to.");
}

// A candidate, and what it was derived from.
struct ProposedGrasp {
  Candidate candidate;
  int primitive = 0;       // index into the primitives
  std::string rule;        // "box faces", "cylinder end", ...: see GraspRule::name
  double width = 0.0;      // that the rule closes on [m]
  double stand_off = 0.0;  // how far the hand's origin stops short of the target [m]
  // Which way it is (ProposalSequence), the value of each of its freedoms and the level of detail
  // at which these values first occur.
  int way = 0;
  std::vector<double> choices = {};
  int level = 0;
  bool preferred = false;  // the fingers are aimed at preferred regions of the object
};

// The first candidates of the sequence of proposals, and two sizes that explain why there may be
// none: rules whose width no preshape takes give no candidate.
struct Proposals {
  std::vector<ProposedGrasp> grasps;
  double smallest_width = 0.0;   // smallest width of all rules; infinite without any rule [m]
  double largest_opening = 0.0;  // largest max_width of the hand's preshapes [m]
};

// The first `count` candidates of ProposalSequence: of rims and bars every fourth, of solids the
// others, as long as there are both. Throws Cancelled.
Proposals propose_grasps(const CompiledScene& scene, const std::vector<Primitive>& primitives,
                         std::size_t count, const CandidateOptions& options = {},
                         const RunContext& context = {});

}  // namespace prehend
