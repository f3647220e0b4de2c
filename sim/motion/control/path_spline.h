// A smooth curve through points of joint space.
#pragma once

#include <vector>

namespace prehend {

// A point of a curve q(s) with its derivatives by s, one number a joint.
struct CurvePoint {
  std::vector<double> q, dq, ddq;
};

// The slope of a spline at its first and its last point.
enum class SplineEnds {
  polynomial,  // that of the cubic through the four points there (of the parabola or the line, if
               // there are fewer). That follows a curve better than the natural end condition,
               // which sets the second derivative to 0 regardless of the points.
  rest,        // 0
};

// A piecewise cubic curve: a cubic in s between two knots, given by its points and slopes there.
class PathSpline {
 public:
  // The cubic spline through the points: twice continuously differentiable. At least two points
  // (one number a joint), and as many knots, strictly increasing. Source: de Boor 1978, A Practical
  // Guide to Splines, chapter IV.
  PathSpline(std::vector<double> knots, std::vector<std::vector<double>> points,
             SplineEnds ends = SplineEnds::polynomial);

  // The curve with the given slopes at its knots: as many as points.
  PathSpline(std::vector<double> knots, std::vector<std::vector<double>> points,
             std::vector<std::vector<double>> slopes);

  const std::vector<double>& knots() const { return knots_; }
  const std::vector<std::vector<double>>& points() const { return points_; }
  const std::vector<std::vector<double>>& slopes() const { return slopes_; }

  // The curve and its derivatives at s, which lies between the first and the last knot.
  CurvePoint at(double s) const;

 private:
  std::vector<double> knots_;
  std::vector<std::vector<double>> points_;
  std::vector<std::vector<double>> slopes_;
};

}  // namespace prehend
