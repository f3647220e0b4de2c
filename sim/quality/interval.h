// A number that is known to lie between two others.
#pragma once

namespace prehend {

struct Interval {
  double lower = 0.0;
  double upper = 0.0;
};

}  // namespace prehend
