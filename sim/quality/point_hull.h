// The convex hull of points in any dimension (the only place that knows qhull).
#pragma once

#include <string>

#include <Eigen/Core>

namespace prehend {

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
  std::string message;  // qhull's, when failed
};

// As given, or joggled by qhull (QJ) until facets are clear: for points that defeat it otherwise.
enum class HullInput { as_given, joggled };

// `points`: one a column, d >= 2 rows, finite. Fewer than d + 1 points are flat.
// Thread-safe: one qhull state a call. Source: Barber, Dobkin and Huhdanpaa 1996.
PointHull point_hull(const Eigen::MatrixXd& points, HullInput input = HullInput::as_given);

}  // namespace prehend
