// Whether the object and the hand of a world have come to rest.
#pragma once

#include "sim/motion/dynamic_grasp/scene_world.h"

namespace prehend {

// How slow everything has to be for how long.
struct RestLimits {
  double slowest = 1e-4;  // of all points of the object [m/s]; ten times that of joints
  double time = 0.05;     // [s]
  // And no faster in the end than at first: what tips over is slow for long, but ever faster.
  bool slows_down = false;
};

// Looks at a world after each of its steps.
class Resting {
 public:
  explicit Resting(const RestLimits& limits = {}) : limits_(limits) {}

  // Whether everything rests. `time`: that the step took [s].
  bool look(const World& world, const WorldHand& hand, double time);

 private:
  RestLimits limits_;
  double for_ = 0.0;    // s
  double first_ = 0.0;  // speed of the object when it began to be slow [m/s]
};

}  // namespace prehend
