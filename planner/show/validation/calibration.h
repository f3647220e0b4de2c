// Whether predicted probabilities of success are as large as the shares that succeed.
#pragma once

#include <span>
#include <vector>

#include "planner/show/validation/labels.h"
#include "sim/quality/interval.h"

namespace prehend {

// The executions whose predicted probability lies in [from, to), of the last bin in [from, to].
struct ReliabilityBin {
  double from = 0.0;
  double to = 1.0;
  int count = 0;
  int lifted = 0;
  double predicted = 0.0;  // mean of the predictions; 0 where there are none
  Interval observed;  // that contains the true share with a probability of 95 % (share_interval)

  double share() const { return count > 0 ? static_cast<double>(lifted) / count : 0.0; }
};

struct Calibration {
  std::vector<ReliabilityBin> bins;  // of the same width, from 0 to 1
  // Mean over the executions of |predicted - share| of their bin (expected calibration error;
  // Naeini, Cooper and Hauskrecht 2015). It depends on the bins.
  double expected_error = 0.0;
  // Mean of (prediction - outcome)^2, outcomes being 0 and 1 (Brier 1950); 0 is best.
  double brier = 0.0;
  // The same of a prediction that is the share of lifted executions each time: p (1 - p). Who
  // predicts worse than that knows less than nothing.
  double brier_of_base_rate = 0.0;
};

// One prediction in [0, 1] an execution; at least one execution, `bins` >= 1.
Calibration calibration(std::span<const double> predictions, std::span<const Label> labels,
                        int bins = 10);

}  // namespace prehend
