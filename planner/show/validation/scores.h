// What prehend says of a grasp in one number, to be compared with what became of it.
#pragma once

#include <string_view>
#include <vector>

#include "planner/plan/plan_result.h"

namespace prehend {

// A score is larger for a grasp that is thought to be better. A grasp in which the hand did not
// close on the object has 0 of each.
struct Score {
  std::string_view name;        // in files
  std::string_view title;       // for people
  bool is_probability = false;  // of lifting: it can be compared with the share that lifts
  bool needs_volume = false;
  double (*of)(const ScoredGrasp&) = nullptr;  // infinite where nothing limits it; never NaN
};

// All scores; epsilon, which the others are compared with, is at kReferenceScore. A further score
// is a further line there.
std::vector<Score> scores(bool with_volume);

inline constexpr std::size_t kReferenceScore = 1;

}  // namespace prehend
