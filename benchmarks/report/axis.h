// The axis of a plot: from values to places, and which values are written beside it.
#pragma once

#include <string>
#include <vector>

namespace prehend::bench {

enum class Scale { linear, logarithmic };

// A value that is written beside the axis.
struct Tick {
  double value = 0.0;
  std::string label;
};

struct Axis {
  Scale scale = Scale::linear;
  double low = 0.0;  // values at both ends
  double high = 1.0;
  std::vector<Tick> ticks;  // ascending, between low and high

  // The place of a value: 0 at `low`, 1 at `high`. A value without a place (0 on a logarithmic
  // axis) is at 0.
  double place(double value) const;
};

// An axis that contains low to high, extended to the ticks around them. Linear: ticks are multiples
// of 1, 2 or 5 times a power of ten, seven at most. Logarithmic: powers of ten, with twice and five
// times them where they cover less than two decades, only every second or third of them where there
// are more than eight; values must be above 0. Where low and high are equal, the axis has some
// extent all the same.
Axis make_axis(Scale scale, double low, double high);

// A number with as few characters as it takes to tell ticks apart: 0.05, 20, 5k, 1M, 1e-6.
std::string short_number(double value);

}  // namespace prehend::bench
