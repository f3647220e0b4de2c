// Counts over all grasps of a batch, for its data card and its page.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "planner/results/datasets/grasp_set.h"

namespace prehend {

// How many grasps ended in each Outcome.
struct OutcomeCounts {
  EnumArray<Outcome, std::size_t> of;

  std::size_t all() const;
  std::size_t stable() const { return of[Outcome::stable]; }
  void add(const OutcomeCounts& other);
};

// Counts in equal bins from 0; the last one also has all that is larger.
struct Histogram {
  double width = 1.0;  // of a bin
  std::vector<std::size_t> bins;

  void add(double value);
  void add(const Histogram& other);  // of the same bins
};

// The memory of a tally does not depend on the number of grasps.
struct BatchTally {
  std::size_t sets = 0;
  OutcomeCounts outcomes;
  std::map<std::string, OutcomeCounts> hands;
  std::map<std::string, OutcomeCounts> objects;
  Histogram epsilon{0.02, std::vector<std::size_t>(30)};           // of stable grasps
  Histogram contacts{1.0, std::vector<std::size_t>(25)};           // of grasps with contacts
  Histogram objects_by_share{0.05, std::vector<std::size_t>(20)};  // see count_shares

  void add(const std::string& object, const GraspSet& set);
  void add(const BatchTally& other);
  // Fills `objects_by_share`: in how many of the objects which share of the grasps is stable.
  void count_shares();
};

}  // namespace prehend
