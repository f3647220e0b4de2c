// Whether the object and the hand of a world have come to rest.
#pragma once

#include "sim/motion/dynamic_grasp/scene_world.h"

namespace prehend {

// How slow everything has to be for how long.
struct RestLimits {
  double slowest = 1e-4;  // of all points of the object [m/s]; ten times that of joints
  double time = 0.05;     // [s]
};

// Looks at a world after each of its steps.
class Resting {
 public:
  explicit Resting(const RestLimits& limits = {}) : limits_(limits) {}

  // Whether everything rests. `time`: that the step took [s].
  bool look(const World& world, const WorldHand& hand, double time);

 private:
  RestLimits limits_;
  double for_ = 0.0;  // s
};

}  // namespace prehend
