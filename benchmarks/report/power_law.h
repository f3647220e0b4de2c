// How a quantity grows with a size: the exponent of a power law.
#pragma once

#include <optional>
#include <vector>

namespace prehend::bench {

struct DataPoint {
  double x = 0.0;
  double y = 0.0;
};

// y = factor * x^exponent.
struct PowerLaw {
  double exponent = 0.0;
  double factor = 0.0;
  // Part of the variance of log y that the law explains, at most 1. Low where the points are no
  // straight line in a plot with logarithmic axes, as with a cost that is constant at first.
  double r_squared = 1.0;

  double at(double x) const;
};

// The straight line through (log x, log y) with the least sum of squared differences in log y.
// Points with an x or y that is not above 0 have no logarithm and are left out. Nothing with fewer
// than two different x.
std::optional<PowerLaw> fit_power_law(const std::vector<DataPoint>& points);

}  // namespace prehend::bench
