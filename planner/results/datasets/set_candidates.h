// The grasps of a set as candidates, and how far what became of them agrees with what the set says.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planner/results/datasets/grasp_set.h"
#include "sim/trial/candidate.h"

namespace prehend {

struct CompiledScene;
struct Hand;
struct Tried;

// The preshape (index) from which a hand closes on the grasps of a set: the narrowest that opens at
// least as wide as `configuration`, where there is none, or it is not known, the widest; the first
// of several. The hand has preshapes.
int set_preshape(const Hand& hand, const std::optional<double>& configuration);

// The grasps in their order, tried where they are: with the hand open, without an approach.
std::vector<Candidate> set_candidates(const GraspSet& set, const CompiledScene& scene);

// Whether the set says of each grasp that it holds.
std::vector<bool> set_labels(const GraspSet& set);

// How many grasps hold (are stable) by the set ("there") and in our trials ("here").
struct LabelAgreement {
  int both = 0;
  int there_only = 0;
  int here_only = 0;
  int neither = 0;

  int trials() const { return both + there_only + here_only + neither; }
};

// Of the trials that were made of set_candidates.
LabelAgreement compare_labels(const std::vector<bool>& labels, const std::vector<Tried>& tried);

// The four counts as a sentence.
std::string agreement_text(const LabelAgreement& agreement);

}  // namespace prehend
