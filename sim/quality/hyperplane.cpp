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

template <int Dimension>
using Directions = Eigen::Matrix<double, Dimension, Dimension - 1>;

// Orthonormalises the edges of a facet (modified Gram-Schmidt, longest remainder first), and
// returns how many are independent. Each edge is projected twice, which makes the columns
// orthogonal up to rounding even where the edges are nearly parallel.
template <int Dimension>
int orthonormalise(Directions<Dimension>& edges) {
  constexpr int kEdges = Dimension - 1;
  const double longest = edges.colwise().norm().maxCoeff();
  for (int rank = 0; rank < kEdges; ++rank) {
    Eigen::Index pivot = 0;
    edges.rightCols(kEdges - rank).colwise().squaredNorm().maxCoeff(&pivot);
    if (pivot != 0) edges.col(rank).swap(edges.col(rank + pivot));
    const auto done = edges.leftCols(rank);
    for (int pass = 0; pass < 2; ++pass) {
      edges.col(rank) -= done * (done.transpose() * edges.col(rank));
    }
    const double length = edges.col(rank).norm();
    if (length <= kShortRemainder * longest) return rank;
    edges.col(rank) /= length;
    for (int k = rank + 1; k < kEdges; ++k) {
      edges.col(k) -= edges.col(rank).dot(edges.col(k)) * edges.col(rank);
    }
  }
  return kEdges;
}

}  // namespace

// The lowest corner is taken, not the mean of the corners: every corner is then on or above the
// plane, so that the simplex of the corners is nowhere nearer to the origin than the offset. This
// makes the offset a lower bound for any error of the normal.
template <int Dimension>
FittedPlane<Dimension> fit_offset(const Eigen::Vector<double, Dimension>& normal,
                                  const CornersIn<Dimension>& corners) {
  FittedPlane<Dimension> fitted;
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

template <int Dimension>
FittedPlane<Dimension> fit_plane(const Eigen::Vector<double, Dimension>& guess,
                                 const CornersIn<Dimension>& corners) {
  Directions<Dimension> edges;
  for (int k = 0; k < Dimension - 1; ++k) {
    edges.col(k) = *corners[static_cast<std::size_t>(k) + 1] - *corners[0];
  }
  const int rank = orthonormalise<Dimension>(edges);
  const auto span = edges.leftCols(rank);
  // What is left of the guess after subtracting its part in the facet is the normal. Where little
  // is left the remainder is inaccurate, and the next pass repairs it.
  Eigen::Vector<double, Dimension> normal = guess;
  double before = guess.norm();
  for (int pass = 0; pass < 3; ++pass) {
    normal -= span * (span.transpose() * normal);
    const double length = normal.norm();
    // The guess lies in the facet: nothing better to say than the guess itself.
    if (!(length > kNoDirection * before)) return fit_offset<Dimension>(guess, corners);
    normal /= length;
    before = 1.0;
  }
  return fit_offset<Dimension>(normal, corners);
}

template FittedPlane<3> fit_offset<3>(const Eigen::Vector3d&, const CornersIn<3>&);
template FittedPlane<6> fit_offset<6>(const Wrench&, const CornersIn<6>&);
template FittedPlane<3> fit_plane<3>(const Eigen::Vector3d&, const CornersIn<3>&);
template FittedPlane<6> fit_plane<6>(const Wrench&, const CornersIn<6>&);

}  // namespace prehend
