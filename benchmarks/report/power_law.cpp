#include "benchmarks/report/power_law.h"

#include <cmath>

namespace prehend::bench {

double PowerLaw::at(double x) const { return factor * std::pow(x, exponent); }

std::optional<PowerLaw> fit_power_law(const std::vector<DataPoint>& points) {
  std::vector<DataPoint> logs;
  DataPoint mean;
  for (const DataPoint& point : points) {
    if (!(point.x > 0.0) || !(point.y > 0.0)) continue;
    logs.push_back({std::log(point.x), std::log(point.y)});
    mean.x += logs.back().x;
    mean.y += logs.back().y;
  }
  if (logs.size() < 2) return std::nullopt;
  mean.x /= static_cast<double>(logs.size());
  mean.y /= static_cast<double>(logs.size());
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const DataPoint& point : logs) {
    const double dx = point.x - mean.x;
    const double dy = point.y - mean.y;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
  }
  // Equal x differ from their mean by rounding at most.
  constexpr double kRounding = 1e-24;
  if (xx <= kRounding * (1.0 + mean.x * mean.x)) return std::nullopt;
  PowerLaw law;
  law.exponent = xy / xx;
  law.factor = std::exp(mean.y - law.exponent * mean.x);
  // A constant y is explained whole.
  if (yy > kRounding * (1.0 + mean.y * mean.y)) law.r_squared = xy * xy / (xx * yy);
  return law;
}

}  // namespace prehend::bench
