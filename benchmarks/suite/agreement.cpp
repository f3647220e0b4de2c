#include "benchmarks/suite/agreement.h"

#include <algorithm>
#include <cmath>

namespace prehend::bench {

std::vector<std::size_t> best_of(const std::vector<double>& values, std::size_t count) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] > 0.0) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] > values[b]; });
  order.resize(std::min(order.size(), count));
  return order;
}

std::size_t kept_of_best(const std::vector<double>& reference, const std::vector<double>& values,
                         std::size_t wanted, std::size_t allowed) {
  const std::vector<std::size_t> among = best_of(values, allowed);
  const std::vector<std::size_t> best = best_of(reference, wanted);
  return static_cast<std::size_t>(std::count_if(best.begin(), best.end(), [&](std::size_t i) {
    return std::find(among.begin(), among.end(), i) != among.end();
  }));
}

std::vector<double> relative_errors(const std::vector<double>& reference,
                                    const std::vector<double>& values) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(reference[i] > 0.0) || !(values[i] > 0.0)) continue;
    errors.push_back(100.0 * std::abs(values[i] - reference[i]) / reference[i]);
  }
  return errors;
}

double other_verdicts(const std::vector<double>& reference, const std::vector<double>& values) {
  if (values.empty()) return 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if ((reference[i] > 0.0) != (values[i] > 0.0)) ++count;
  }
  return 100.0 * static_cast<double>(count) / static_cast<double>(values.size());
}

}  // namespace prehend::bench
