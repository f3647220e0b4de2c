// The largest value of a function of a few variables, looked for along one variable at a time.
#pragma once

#include <cstddef>
#include <vector>

namespace prehend {

// A pattern search with a step of its own for each variable, after Hooke and Jeeves 1961 ("Direct
// search" solution of numerical and statistical problems), but without their moves along several
// variables at once. It looks at a few variables at a time, each one step up and one step down from
// the best point, and goes to the best of these points if it is better. The step of the variable
// that it went along is then twice as long the next time; that of a variable along which neither
// way was better is half as long.
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
  // -1 .. 1; `step`, in (0, 1], is the first step of each.
  PatternSearch(std::size_t variables, double value, double step);

  // The points for the next `count` variables, at least 1 and at most all of them: two for each.
  // Where the limit closes one way, both are the other way, one of them half as far. None of them
  // is best().
  std::vector<std::vector<double>> next(std::size_t count);

  // The values at the points of the last next(), in their order. The search only goes to a larger
  // value, of equal ones to the first; never to one that is not a number.
  void tell(const std::vector<double>& values);

  const std::vector<double>& best() const { return best_; }
  double best_value() const { return best_value_; }

 private:
  // A point of the last next(): one step from the best point.
  struct Probe {
    std::size_t variable = 0;
    double at = 0.0;   // value of the variable
    double way = 1.0;  // 1 or -1: along the step or against it
  };

  Probe probe_from_best(double way) const;
  void shorten(std::size_t variable);

  std::vector<double> best_;
  double best_value_ = 0.0;
  double first_step_ = 0.0;
  std::vector<double> steps_;  // signed: the way that is asked for first
  std::size_t variable_ = 0;   // the one that is looked at next
  std::vector<Probe> probes_;
};

}  // namespace prehend
