#include "sim/quality/proved_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim/quality/support.h"

namespace prehend {
namespace {

// The largest height of a point above a facet, or of a facet above one of its corners, as a part of
// the largest coordinate.
constexpr double kPlaneError = 2e-11;
// The largest error of the volume, as a part of it.
constexpr double kVolumeError = 1e-8;

using Corners = Eigen::Ref<const Eigen::VectorXi>;

// The determinant of a 5 x 5 matrix, by Laplace's expansion along its first two rows: a fixed
// number of products, without the branches of a pivot search. Rounding is relative to the product
// of the rows' lengths, which is enough for a sum of such determinants.
double determinant(const Eigen::Matrix<double, 5, 5>& m) {
  // Two columns, then the other three. The sign is that of the permutation.
  struct Split {
    int a, b, c, d, e;
    double sign;
  };
  static constexpr std::array<Split, 10> kSplits = {{
      {0, 1, 2, 3, 4, 1.0},
      {0, 2, 1, 3, 4, -1.0},
      {0, 3, 1, 2, 4, 1.0},
      {0, 4, 1, 2, 3, -1.0},
      {1, 2, 0, 3, 4, 1.0},
      {1, 3, 0, 2, 4, -1.0},
      {1, 4, 0, 2, 3, 1.0},
      {2, 3, 0, 1, 4, 1.0},
      {2, 4, 0, 1, 3, -1.0},
      {3, 4, 0, 1, 2, 1.0},
  }};
  double sum = 0.0;
  for (const auto& [a, b, c, d, e, sign] : kSplits) {
    const double two = m(0, a) * m(1, b) - m(0, b) * m(1, a);
    const double three = m(2, c) * (m(3, d) * m(4, e) - m(3, e) * m(4, d)) -
                         m(2, d) * (m(3, c) * m(4, e) - m(3, e) * m(4, c)) +
                         m(2, e) * (m(3, c) * m(4, d) - m(3, d) * m(4, c));
    sum += sign * two * three;
  }
  return sum;
}

// The five-dimensional area of the simplex of the corners: that of its projection along a
// coordinate axis, over the cosine of the angle between the axis and the normal. The axis is the
// one nearest to the normal.
double area(const Wrenches& wrenches, const Corners& corners, const Wrench& normal) {
  constexpr double kFactorial = 120.0;  // of five dimensions
  Eigen::Index axis = 0;
  const double cosine = normal.cwiseAbs().maxCoeff(&axis);
  Eigen::Matrix<double, 5, 5> edges;
  for (Eigen::Index k = 0; k < 5; ++k) {
    const Wrench edge = wrenches.col(corners[k + 1]) - wrenches.col(corners[0]);
    for (Eigen::Index i = 0; i < 5; ++i) edges(i, k) = edge[i < axis ? i : i + 1];
  }
  return std::abs(determinant(edges)) / (kFactorial * cosine);
}

// The height of the lowest corner above the plane through the origin with this normal.
double lowest_height(const Wrenches& wrenches, const Corners& corners, const Wrench& normal) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const int corner : corners) lowest = std::min(lowest, normal.dot(wrenches.col(corner)));
  return lowest;
}

}  // namespace

// Moved outward by the error of the planes, the facets' planes enclose all points, and the facets
// are at most twice that error away from them. The volume is that of the pyramids over the facets
// with a common apex inside.
std::optional<double> proved_volume(const Wrenches& wrenches, const PointHull& hull) {
  const ColumnSupport set(wrenches);
  const double scale = wrenches.cwiseAbs().maxCoeff();
  const Wrench apex = wrenches.rowwise().mean();
  double error = 0.0;
  double volume = 0.0;
  double surface = 0.0;
  Wrench area_vectors = Wrench::Zero();
  for (Eigen::Index f = 0; f < hull.offsets.size(); ++f) {
    const Wrench normal = hull.normals.col(f);
    const double offset = hull.offsets[f];
    const double above = normal.dot(set.support(normal)) - offset;
    const double below = offset - lowest_height(wrenches, hull.corners.col(f), normal);
    const double height = offset - normal.dot(apex);
    error = std::max({error, above, below});
    if (!(error <= kPlaneError * scale && height > 0.0)) return std::nullopt;
    const double base = area(wrenches, hull.corners.col(f), normal);
    surface += base;
    area_vectors += base * normal;
    volume += height * base / 6.0;
  }
  // No squares: those of small areas are no doubles.
  const double imbalance = area_vectors.cwiseAbs().sum() * scale;
  const bool exact = error * surface + imbalance <= kVolumeError * volume;
  return exact && std::isnormal(volume) ? std::optional(volume) : std::nullopt;
}

}  // namespace prehend
