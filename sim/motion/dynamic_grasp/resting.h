// Whether the object and the hand of a world have come to rest.
#pragma once

#include "sim/motion/dynamic_grasp/scene_world.h"

namespace prehend {

struct RestingOptions {
  double slowest = 1e-4;  // of all points of the object [m/s], ten times that of joints
  double seconds = 0.05;  // for how long they have to be slower
};

// Looks at a world after each of its steps.
class Resting {
 public:
  explicit Resting(const RestingOptions& options = {}) : options_(options) {}

  // Whether everything rests. `time`: that the step took [s].
  bool look(const World& world, const WorldHand& hand, double time);

 private:
  RestingOptions options_;
  double for_ = 0.0;  // s
};

}  // namespace prehend
