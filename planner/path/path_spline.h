// A smooth curve through points of joint space.
#pragma once

#include <vector>

namespace prehend {

// A point of a curve q(s) with its derivatives by s, one number a joint.
struct CurvePoint {
  std::vector<double> q, dq, ddq;
};

// The cubic spline through the points: twice continuously differentiable, a cubic in s between two
// knots. Its slope at either end is that of the cubic through the four points there (of the
// parabola or the line, if there are fewer). That follows a curve better than the natural end
// condition, which sets the second derivative to 0 regardless of the points. Source: de Boor 1978,
// A Practical Guide to Splines, chapter IV.
class PathSpline {
 public:
  // At least two points (one number a joint), and as many knots, strictly increasing.
  PathSpline(std::vector<double> knots, std::vector<std::vector<double>> points);

  const std::vector<double>& knots() const { return knots_; }

  // The curve and its derivatives at s, which lies between the first and the last knot.
  CurvePoint at(double s) const;

 private:
  std::vector<double> knots_;
  std::vector<std::vector<double>> points_;
  std::vector<std::vector<double>> slopes_;
};

}  // namespace prehend
