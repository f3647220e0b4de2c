// Simple bodies of sizes that a hand should hold, and which of them it does hold.
#pragma once

#include <string>
#include <vector>

#include "sim/robot/hand/hand_axes.h"
#include "sim/robot/hand/test_closing.h"

namespace prehend {

// What a preshape holds of a sphere, a cylinder across approach and closing axis, and a box of each
// of some sizes.
struct TestHolds {
  struct Held {
    std::string body;      // "sphere"
    double width = 0.0;    // along the closing axis [m]
    double epsilon = 0.0;  // 0: not held
  };
  std::vector<Held> bodies;

  int held() const;
  double mean_epsilon() const;
};

// Their names, in the order in which they are tried.
inline constexpr const char* kTestBodies[] = {"sphere", "cylinder", "box"};

// A quarter, half and four fifths of an opening [m].
std::vector<double> test_sizes(double width);

// Puts each body before the open hand, its middle on the line from the origin along the approach:
// as near as it can come, and where the fingers meet if that is farther; where neither is held, a
// little farther than the nearest. The better counts. A size outside the preshape's is not held.
TestHolds try_bodies(const TestClosing& closing, const HandAxes& axes, std::size_t thumb,
                     const Preshape& open, const std::vector<double>& sizes);

}  // namespace prehend
