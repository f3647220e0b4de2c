// The convex hull of points in any dimension, by qhull. No other file uses qhull.
#pragma once

#include <string>

#include <Eigen/Core>

namespace prehend {

// solid: a hull with volume; flat: the points do not span the space; failed: qhull gave up.
enum class PointHullStatus { solid, flat, failed };

struct PointHull {
  PointHullStatus status = PointHullStatus::flat;
  double volume = 0.0;
  // Facets are simplices, one a column: the hull is normals.col(f) . x <= offsets[f] for all f, and
  // corners.col(f) are the columns of `points` at its corners.
  Eigen::MatrixXd normals;  // unit
  Eigen::VectorXd offsets;
  Eigen::MatrixXi corners;
  double reach = 0.0;   // the largest distance of a point from the origin
  double joggle = 0.0;  // how far qhull moved coordinates, with HullInput::joggled
  std::string message;  // qhull's error message, when failed
};

// Points as given, or joggled (moved at random by a little, qhull's option QJ) until the facets are
// numerically clear: for points on which qhull fails otherwise.
enum class HullInput { as_given, joggled };

// `points`: one a column, d >= 2 rows, finite. Fewer than d + 1 points are flat.
// Thread-safe: one qhull state a call. Source: Barber, Dobkin and Huhdanpaa 1996.
PointHull point_hull(const Eigen::MatrixXd& points, HullInput input = HullInput::as_given);

}  // namespace prehend
