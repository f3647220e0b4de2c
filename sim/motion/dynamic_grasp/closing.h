// What each degree of freedom of a hand does while it closes in time.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/motion/dynamic_grasp/scene_world.h"
#include "sim/robot/robot.h"

namespace prehend {

// How far the degrees of freedom of a hand have come, in this order.
struct ClosingState {
  std::vector<bool> touches;  // whether a link that it moves presses on the object
  std::vector<double> rates;  // rad/s or m/s
};

ClosingState closing_state(const World& world, const WorldHand& hand, const Robot& as_hand);

// A strategy in time: what closes first does so until each of it touches the object, or stops, then
// the others likewise, and in the end everything with its largest efforts. A default strategy is
// at that end from the beginning. Looks at a hand after each of its steps.
class Closing {
 public:
  explicit Closing(const Robot& hand, const ClosingStrategy& strategy = {});

  // `time`: that the step took [s].
  void look(const ClosingState& state, double time);

  // The part of its largest effort with which a degree of freedom closes now; 0: it stays where it
  // is.
  double effort(std::size_t dof) const;
  // Whether everything closes with its largest effort.
  bool is_full() const { return stage_ == stages_; }

  // Stages before that, and the same in each of them of what has not touched the object.
  int stages() const { return stages_; }
  double effort_in(int stage, std::size_t dof) const;

 private:
  struct Motion {
    double velocity = 0.0;  // with which it closes, 0: it does not
    int stage = 0;          // from which on it closes
    bool touched = false;
    double still = 0.0;  // for how long [s]
  };

  std::vector<Motion> motions_;
  bool waits_;
  double effort_;
  int stages_;
  int stage_ = 0;
  double touched_ = 0.0;  // for how long something of the stage has touched the object [s]
};

}  // namespace prehend
