#include "benchmarks/report/axis.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/base/formatted.h"

namespace prehend::bench {
namespace {

constexpr double kMostLinearTicks = 6.0;  // steps: one tick more than that
constexpr double kSlack = 1e-9;           // of a step or a decade, for rounding

// The smallest of 1, 2, 5, 10, ... that gives at most kMostLinearTicks steps.
double linear_step(double extent) {
  const double power = std::pow(10.0, std::floor(std::log10(extent / kMostLinearTicks)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    const double step = factor * power;
    // Both ends are moved out to multiples of the step, which may add one.
    if (extent / step <= kMostLinearTicks - 1.0) return step;
  }
  return 10.0 * power;
}

Axis linear_axis(double low, double high) {
  if (!(high > low)) {
    const double room = low == 0.0 ? 1.0 : 0.5 * std::abs(low);
    low -= low == 0.0 ? 0.0 : room;
    high += room;
  }
  const double step = linear_step(high - low);
  const double first = std::floor(low / step + kSlack);
  const double last = std::ceil(high / step - kSlack);
  Axis axis{Scale::linear, first * step, last * step, {}};
  for (double i = first; i <= last; i += 1.0) {
    axis.ticks.push_back({i * step, short_number(i * step)});
  }
  return axis;
}

// 1, 2 and 5 times the powers of ten, from the last one at or below `low` to the first at or above
// `high`.
Axis axis_of_few_decades(double low, double high) {
  Axis axis{Scale::logarithmic, low, high, {}};
  std::vector<double> values;
  const double first = std::floor(std::log10(low) + kSlack);
  const double last = std::ceil(std::log10(high) - kSlack);
  for (double power = first; power <= last; power += 1.0) {
    for (const double factor : {1.0, 2.0, 5.0}) values.push_back(factor * std::pow(10.0, power));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool below = i + 1 < values.size() && values[i + 1] <= low * (1.0 + kSlack);
    const bool above = i > 0 && values[i - 1] >= high * (1.0 - kSlack);
    if (!below && !above) axis.ticks.push_back({values[i], short_number(values[i])});
  }
  axis.low = axis.ticks.front().value;
  axis.high = axis.ticks.back().value;
  return axis;
}

Axis logarithmic_axis(double low, double high) {
  if (!(high > low)) {
    low /= 2.0;
    high = 4.0 * low;
  }
  const double first = std::floor(std::log10(low) + kSlack);
  const double last = std::ceil(std::log10(high) - kSlack);
  if (std::log10(high / low) < 2.0) return axis_of_few_decades(low, high);
  constexpr double kMostDecades = 8.0;
  const double stride = std::ceil((last - first) / kMostDecades);
  Axis axis{Scale::logarithmic, std::pow(10.0, first), std::pow(10.0, last), {}};
  for (double power = first; power <= last; power += stride) {
    axis.ticks.push_back({std::pow(10.0, power), short_number(std::pow(10.0, power))});
  }
  return axis;
}

}  // namespace

double Axis::place(double value) const {
  if (scale == Scale::linear) return (value - low) / (high - low);
  if (!(value > 0.0)) return 0.0;
  return std::log(value / low) / std::log(high / low);
}

Axis make_axis(Scale scale, double low, double high) {
  return scale == Scale::linear ? linear_axis(low, high) : logarithmic_axis(low, high);
}

std::string short_number(double value) {
  const double size = std::abs(value);
  if (size < 1e-12) return "0";
  if (size >= 1e10 || size < 9.99e-4) {
    // "1e-06" and "1e+12" without what nobody needs.
    std::string text = formatted("%.3g", value);
    const std::size_t exponent = text.find('e');
    if (exponent == std::string::npos) return text;
    return text.substr(0, exponent + 1) + std::to_string(std::stoi(text.substr(exponent + 1)));
  }
  constexpr std::array<std::pair<double, const char*>, 3> kPrefixes = {
      {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}}};
  for (const auto& [factor, prefix] : kPrefixes) {
    if (size >= factor * (1.0 - kSlack)) return formatted("%.4g%s", value / factor, prefix);
  }
  return formatted("%.4g", value);
}

}  // namespace prehend::bench
