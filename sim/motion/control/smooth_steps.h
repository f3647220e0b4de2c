// Motion in equal steps of time, made smooth.
#pragma once

namespace prehend {

// A number that changes with time, and how fast [1/s].
struct SmoothValue {
  double value = 0.0;
  double rate = 0.0;
};

// Knot k of the uniform cubic B-spline whose control values are `at(i)`, `step` seconds apart: the
// weighted mean of at(k - 1), at(k) and at(k + 1). Between two knots the spline is the cubic that
// values and rates there determine. Its acceleration is continuous, and at knot k it is the second
// difference of the three controls, which is a weighted mean of the accelerations of whatever
// motion passes through the controls at these times; so are velocities. The spline therefore keeps
// to all limits of velocity and acceleration that this motion keeps to, and where that switches
// from one acceleration to another, the spline takes up to four steps for it. Source: de Boor 1978,
// A Practical Guide to Splines, chapter IX.
template <typename At>
SmoothValue smoothed(const At& at, int k, double step) {
  const double before = at(k - 1);
  const double here = at(k);
  const double after = at(k + 1);
  return {here + (before - 2.0 * here + after) / 6.0, (after - before) / (2.0 * step)};
}

}  // namespace prehend
