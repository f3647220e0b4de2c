// A hyperplane that bounds a polytope: the set normal . x <= offset. In six dimensions, those of
// wrench space, or in the three of its sections.
#pragma once

#include <array>

#include "sim/quality/wrench.h"

namespace prehend {

template <int Dimension>
struct HyperplaneIn {
  Eigen::Vector<double, Dimension> normal = Eigen::Vector<double, Dimension>::Zero();  // unit
  double offset = 0.0;
};
using Hyperplane = HyperplaneIn<6>;

// A plane and how well it passes through the corners of a facet.
template <int Dimension>
struct FittedPlane {
  HyperplaneIn<Dimension> plane;  // every corner has normal . corner >= offset, one an equality
  double spread = 0.0;            // largest normal . corner - offset
};

template <int Dimension>
using CornersIn =
    std::array<const Eigen::Vector<double, Dimension>*, static_cast<std::size_t>(Dimension)>;
using FacetCorners = CornersIn<6>;

// The plane with the direction of `normal` (not zero), moved to the lowest of the corners. Because
// of that choice the distance from the origin to the simplex of the corners is at least `offset`,
// however inexact the normal is.
template <int Dimension>
FittedPlane<Dimension> fit_offset(const Eigen::Vector<double, Dimension>& normal,
                                  const CornersIn<Dimension>& corners);

// The plane through the corners, with its normal on the side of `guess` (not zero): `guess` less
// its components along the facet. Where a facet is so thin that its edges do not determine the
// normal, `guess` decides among those possible.
template <int Dimension>
FittedPlane<Dimension> fit_plane(const Eigen::Vector<double, Dimension>& guess,
                                 const CornersIn<Dimension>& corners);

}  // namespace prehend
