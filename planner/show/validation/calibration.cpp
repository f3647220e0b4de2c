#include "planner/show/validation/calibration.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/base/index.h"
#include "sim/quality/share_interval.h"

namespace prehend {

Calibration calibration(std::span<const double> predictions, std::span<const Label> labels,
                        int bins) {
  assert(predictions.size() == labels.size() && !labels.empty() && bins >= 1);
  Calibration result;
  for (int b = 0; b < bins; ++b) {
    ReliabilityBin& bin = result.bins.emplace_back();
    bin.from = static_cast<double>(b) / bins;
    bin.to = static_cast<double>(b + 1) / bins;
  }
  double all = 0.0;
  double lifted = 0.0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const double p = predictions[i];
    assert(p >= 0.0 && p <= 1.0);
    const int times = labels[i].times;
    ReliabilityBin& bin = result.bins[index(std::min(bins - 1, static_cast<int>(p * bins)))];
    bin.count += times;
    bin.lifted += labels[i].lifted ? times : 0;
    bin.predicted += times * p;
    const double off = p - (labels[i].lifted ? 1.0 : 0.0);
    result.brier += times * off * off;
    all += times;
    lifted += labels[i].lifted ? times : 0;
  }
  for (ReliabilityBin& bin : result.bins) {
    bin.observed = share_interval(bin.lifted, bin.count, kQuantile95);
    if (bin.count == 0) continue;
    bin.predicted /= bin.count;
    result.expected_error += bin.count / all * std::abs(bin.predicted - bin.share());
  }
  result.brier /= all;
  const double rate = lifted / all;
  result.brier_of_base_rate = rate * (1.0 - rate);
  return result;
}

}  // namespace prehend
