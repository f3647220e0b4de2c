#include "sim/quality/hyperplane.h"

#include <algorithm>
#include <utility>

namespace prehend {
namespace {

// An edge of a facet whose remainder is shorter than this, relative to the longest edge, has no
// reliable direction. With such directions the normals of neighbouring facets scatter, and the
// growth of the polytope stalls on points that are nearly equal.
constexpr double kShortRemainder = 1e-10;
// Remainders of a vector below this part of its length are rounding.
constexpr double kNoDirection = 1e-15;

using Directions = Eigen::Matrix<double, 6, 5>;

// Orthonormalises the edges of a facet (modified Gram-Schmidt, longest remainder first), and
// returns how many are independent. Each edge is projected twice, which makes the columns
// orthogonal up to rounding even where the edges are nearly parallel.
int orthonormalise(Directions& edges) {
  const double longest = edges.colwise().norm().maxCoeff();
  for (int rank = 0; rank < 5; ++rank) {
    Eigen::Index pivot = 0;
    edges.rightCols(5 - rank).colwise().squaredNorm().maxCoeff(&pivot);
    if (pivot != 0) edges.col(rank).swap(edges.col(rank + pivot));
    const auto done = edges.leftCols(rank);
    for (int pass = 0; pass < 2; ++pass) {
      edges.col(rank) -= done * (done.transpose() * edges.col(rank));
    }
    const double length = edges.col(rank).norm();
    if (length <= kShortRemainder * longest) return rank;
    edges.col(rank) /= length;
    for (int k = rank + 1; k < 5; ++k) {
      edges.col(k) -= edges.col(rank).dot(edges.col(k)) * edges.col(rank);
    }
  }
  return 5;
}

}  // namespace

// The lowest corner is taken, not the mean of the corners: every corner is then on or above the
// plane, so that the simplex of the corners is nowhere nearer to the origin than the offset. This
// makes the offset a lower bound for any error of the normal.
FittedPlane fit_offset(const Wrench& normal, const FacetCorners& corners) {
  FittedPlane fitted;
  fitted.plane.normal = normal / normal.norm();
  double lowest = fitted.plane.normal.dot(*corners[0]);
  double highest = lowest;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const double height = fitted.plane.normal.dot(*corners[i]);
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  fitted.plane.offset = lowest;
  fitted.spread = highest - lowest;
  return fitted;
}

FittedPlane fit_plane(const Wrench& guess, const FacetCorners& corners) {
  Directions edges;
  for (int k = 0; k < 5; ++k) {
    edges.col(k) = *corners[static_cast<std::size_t>(k) + 1] - *corners[0];
  }
  const int rank = orthonormalise(edges);
  const auto span = edges.leftCols(rank);
  // What is left of the guess after subtracting its part in the facet is the normal. Where little
  // is left the remainder is inaccurate, and the next pass repairs it.
  Wrench normal = guess;
  double before = guess.norm();
  for (int pass = 0; pass < 3; ++pass) {
    normal -= span * (span.transpose() * normal);
    const double length = normal.norm();
    // The guess lies in the facet: nothing better to say than the guess itself.
    if (!(length > kNoDirection * before)) return fit_offset(guess, corners);
    normal /= length;
    before = 1.0;
  }
  return fit_offset(normal, corners);
}

}  // namespace prehend
