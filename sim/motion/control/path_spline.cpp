#include "sim/motion/control/path_spline.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace prehend {
namespace {

// Slope at the first of the points (at most four are used) of the polynomial through them, by
// Newton's divided differences. `at(i)` is the index of the i-th point from that end.
template <typename At>
double end_slope(const std::vector<double>& knots, const std::vector<double>& q, const At& at) {
  const std::size_t count = std::min<std::size_t>(4, q.size());
  std::array<double, 4> differences{};
  for (std::size_t i = 0; i < count; ++i) differences[i] = q[at(i)];
  for (std::size_t order = 1; order < count; ++order) {
    for (std::size_t i = count - 1; i >= order; --i) {
      differences[i] =
          (differences[i] - differences[i - 1]) / (knots[at(i)] - knots[at(i - order)]);
    }
  }
  // The derivative of d1 (s - s0) + d2 (s - s0)(s - s1) + d3 (s - s0)(s - s1)(s - s2) at s0.
  double slope = 0.0;
  double product = 1.0;
  for (std::size_t order = 1; order < count; ++order) {
    slope += differences[order] * product;
    product *= knots[at(0)] - knots[at(order)];
  }
  return slope;
}

// Slopes m of one joint at all knots. In Hermite form, values and slopes at the knots determine the
// cubics; the inner slopes follow from the condition that the second derivatives of neighbouring
// cubics agree where they meet, which is a tridiagonal linear system.
std::vector<double> spline_slopes(const std::vector<double>& knots, const std::vector<double>& q,
                                  SplineEnds ends) {
  const std::size_t last = knots.size() - 1;
  std::vector<double> h(last);
  std::vector<double> secant(last);
  for (std::size_t i = 0; i < last; ++i) {
    h[i] = knots[i + 1] - knots[i];
    secant[i] = (q[i + 1] - q[i]) / h[i];
  }
  std::vector<double> slope(last + 1, secant[0]);
  if (ends == SplineEnds::rest) {
    slope[0] = slope[last] = 0.0;
  } else if (last > 1) {
    slope[0] = end_slope(knots, q, [](std::size_t i) { return i; });
    slope[last] = end_slope(knots, q, [last](std::size_t i) { return last - i; });
  }
  // One equation for each inner knot,
  //   h1 m0 + 2 (h0 + h1) m1 + h0 m2 = 3 (h1 secant0 + h0 secant1),
  // solved by elimination downwards and substitution upwards (Thomas algorithm). The matrix is
  // diagonally dominant, so no pivoting is needed. The slopes at both ends are known: above[0] is
  // 0, and slope[last] enters as it is.
  std::vector<double> above(last + 1, 0.0);
  for (std::size_t i = 1; i < last; ++i) {
    const double right = 3.0 * (h[i] * secant[i - 1] + h[i - 1] * secant[i]);
    const double pivot = 2.0 * (h[i - 1] + h[i]) - h[i] * above[i - 1];
    above[i] = h[i - 1] / pivot;
    slope[i] = (right - h[i] * slope[i - 1]) / pivot;
  }
  for (std::size_t i = last; i-- > 1;) slope[i] -= above[i] * slope[i + 1];
  return slope;
}

}  // namespace

// The joints are independent: each has a system of equations of its own, with the same knots.
PathSpline::PathSpline(std::vector<double> knots, std::vector<std::vector<double>> points,
                       SplineEnds ends)
    : knots_(std::move(knots)), points_(std::move(points)), slopes_(points_) {
  assert(knots_.size() >= 2 && knots_.size() == points_.size());
  std::vector<double> q(points_.size());
  for (std::size_t joint = 0; joint < points_.front().size(); ++joint) {
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = points_[i][joint];
    const std::vector<double> slopes = spline_slopes(knots_, q, ends);
    for (std::size_t i = 0; i < q.size(); ++i) slopes_[i][joint] = slopes[i];
  }
}

PathSpline::PathSpline(std::vector<double> knots, std::vector<std::vector<double>> points,
                       std::vector<std::vector<double>> slopes)
    : knots_(std::move(knots)), points_(std::move(points)), slopes_(std::move(slopes)) {
  assert(knots_.size() >= 2 && knots_.size() == points_.size());
  assert(slopes_.size() == points_.size());
}

CurvePoint PathSpline::at(double s) const {
  // The interval of s. The first and the last knot are left out of the search, so that s at (or, by
  // rounding, beyond) either end falls into the outermost interval. Then the cubic Hermite
  // polynomial there, with t from 0 to 1 and r = 1 - t, and its derivatives by s.
  const auto after = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, s);
  const auto i = static_cast<std::size_t>(after - knots_.begin()) - 1;
  const double h = knots_[i + 1] - knots_[i];
  const double t = (s - knots_[i]) / h;
  const double r = 1.0 - t;
  CurvePoint point{points_[i], slopes_[i], slopes_[i]};
  for (std::size_t j = 0; j < point.q.size(); ++j) {
    const double q0 = points_[i][j];
    const double q1 = points_[i + 1][j];
    const double m0 = slopes_[i][j];
    const double m1 = slopes_[i + 1][j];
    const double secant = (q1 - q0) / h;
    point.q[j] =
        r * r * (1.0 + 2.0 * t) * q0 + t * t * (1.0 + 2.0 * r) * q1 + h * t * r * (r * m0 - t * m1);
    point.dq[j] = 6.0 * t * r * secant + r * (r - 2.0 * t) * m0 + t * (t - 2.0 * r) * m1;
    point.ddq[j] =
        (6.0 * (r - t) * secant + (2.0 * t - 4.0 * r) * m0 + (4.0 * t - 2.0 * r) * m1) / h;
  }
  return point;
}

}  // namespace prehend
