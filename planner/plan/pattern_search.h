// The largest value of a function of a few variables, looked for along one direction at a time.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/base/random.h"

namespace prehend {

// A pattern search with a step of its own for each direction, after Hooke and Jeeves 1961 ("Direct
// search" solution of numerical and statistical problems), but without their moves along several
// directions at once. It looks at a few directions at a time, each one step up and one step down
// from the best point, and goes to the best of these points if it is better. The step of the
// direction that it went along is then twice as long the next time; that of a direction along which
// neither way was better is half as long.
//
// The directions are the variables at first. Epsilon is the least of many distances, so that its
// graph has ridges, from which every variable alone leads down although the ridge itself leads up.
// So when the search has looked along all directions twice and none was better, it goes on with
// other directions, orthogonal ones at random: as in mesh adaptive direct search (Audet and Dennis
// 2006), none that leads up is missed for ever.
//
// It only compares values, so cliffs and plateaus do no harm. It keeps nothing but the best point
// and the steps, so it can be stopped and continued at any time; and the points that it asks for
// together may be evaluated in parallel:
//
//   PatternSearch search(variables, value_at_zero, 0.3);
//   while (...) {
//     const auto points = search.next(2);
//     search.tell(values_at(points));
//   }
class PatternSearch {
 public:
  // Starts at zero, where the function has `value`. The variables, at least one, stay within
  // -1 .. 1; `step`, in (0, 1], is the first step along each. The same arguments and values give
  // the same points.
  PatternSearch(std::size_t variables, double value, double step);

  // The points for the next `count` directions, at least 1 and at most as many as there are
  // variables: two for each. Where the limits close one way, both are the other way, one of them
  // half as far. Coordinates beyond a limit are set to it.
  std::vector<std::vector<double>> next(std::size_t count);

  // The values at the points of the last next(), in their order. The search only goes to a larger
  // value, of equal ones to the first; never to one that is not a number.
  void tell(const std::vector<double>& values);

  const std::vector<double>& best() const { return best_; }
  double best_value() const { return best_value_; }

 private:
  // A point of the last next(): one step from the best point.
  struct Probe {
    std::size_t direction = 0;
    double way = 1.0;  // 1 or -1: along the step or against it
    std::vector<double> point = {};
  };

  Probe probe_from_best(double way) const;
  std::vector<double> point_at(double step) const;
  void shorten(std::size_t direction);
  void turn_directions();

  std::vector<double> best_;
  double best_value_ = 0.0;
  double first_step_ = 0.0;
  std::vector<std::vector<double>> directions_;  // orthonormal
  std::vector<double> steps_;                    // signed: the way that is asked for first
  std::size_t direction_ = 0;                    // the one that is looked at next
  std::size_t failures_ = 0;                     // directions since the last better point
  std::vector<Probe> probes_;
  Random random_;
};

}  // namespace prehend
