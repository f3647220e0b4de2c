// How well a score tells grasps that lifted from those that failed.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "planner/show/validation/labels.h"

namespace prehend {

// A point of the receiver operating characteristic: of all grasps with at least some score, the
// share of the failed ones and the share of the lifted ones.
struct RocPoint {
  double failed = 0.0;
  double lifted = 0.0;
};

// Executions in the order of a score. Sorting is done once; what is asked of it then takes a time
// proportional to their number.
class Ranking {
 public:
  // One score an execution, larger promises more; infinite ones may be among them, NaN may not.
  Ranking(std::span<const double> scores, std::span<const Label> labels);

  // The probability that of a lifted and a failed execution, drawn by their weights, the lifted one
  // has the larger score; ties count half (AUC: the statistic of Mann and Whitney 1947 over its
  // largest value; Hanley and McNeil 1982). One weight (>= 0) an execution. Nothing where all the
  // weight is on one outcome.
  std::optional<double> auc(std::span<const double> weights) const;

  // From (0, 0) to (1, 1), one point for each score that occurs, largest first. The area below the
  // line through them is the AUC. Empty where auc is nothing.
  std::vector<RocPoint> roc(std::span<const double> weights) const;

 private:
  struct Place {
    std::size_t execution = 0;
    bool lifted = false;
    bool ends_tie = false;  // the next one has a smaller score
  };
  std::vector<Place> places_;  // largest score first
};

// One weight an execution: how often it was made.
std::vector<double> weights_of(std::span<const Label> labels);

}  // namespace prehend
