// Whether the object and the hand of a world have come to rest.
#pragma once

#include "sim/motion/dynamic_grasp/scene_world.h"

namespace prehend {

// Looks at a world after each of its steps.
class Resting {
 public:
  // Whether everything rests. `time`: that the step took [s].
  bool look(const World& world, const WorldHand& hand, double time);

 private:
  double for_ = 0.0;  // s
};

}  // namespace prehend
