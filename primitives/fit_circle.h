// A circle through points of a plane: where the cylinder fit starts.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace prehend {

struct Circle {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0.0;
};

// The algebraic least-squares circle (Kasa 1976, "A circle fitting procedure and its error
// analysis") of the points, without the fraction `tail` of them that is farthest from their median.
// Nothing when the points are too few, or so straight that the circle is far larger than they are.
std::optional<Circle> fit_circle(std::vector<Eigen::Vector2d> points, double tail);

}  // namespace prehend
