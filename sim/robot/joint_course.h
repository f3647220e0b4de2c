// The way of the joints of a hand that closes, and which of them stop when a link touches.
#pragma once

#include <vector>

#include "sim/robot/robot.h"

namespace prehend {

// The first joint of the finger that each joint belongs to, among those of its degree of freedom:
// those behind the same first one are of one finger, and those that a linkage joins
// (Joint::across).
std::vector<int> first_joints_of_fingers(const Robot& robot);

// Whether it belongs to a linkage that closes further when a link on this joint is stopped: others
// go on across it, and its drive goes on (rigid and by_finger couplings).
bool gives_way(const Robot& robot, int joint);

// How a degree of freedom closes: at a constant velocity to where it ends.
struct DofCourse {
  double velocity = 0.0;  // 0: stands still [rad/s or m/s]
  double end = 0.0;       // rad or m
};

// Joint values over the closing time t [s]. Each joint moves at its own constant velocity until it
// reaches its end or was stopped; of two self-centering fingers one may pass its end by as much as
// the other one was stopped short of it. One across a joint that gives way turns when that one
// stops: from then on it moves as the linkage does with that joint held.
class JointCourse {
 public:
  // To be called before anything else; keeps the memory that it has. `joints`: values at the start,
  // empty: those that belong to `dofs`. The robot must outlive the course.
  void start(const Robot& robot, const std::vector<double>& dofs,
             const std::vector<DofCourse>& closing, const std::vector<double>& joints = {});

  const std::vector<double>& at_start() const { return start_; }
  double value(int joint, double t) const;

  // Whether the joint moves, or may do so yet, from time t on.
  bool moves(int joint, double t) const { return speed(joint, t) != 0.0; }
  // Bound of the size of its velocity from time t on [rad/s or m/s].
  double speed(int joint, double t) const;
  // Its velocity at time t, which it keeps until it stops unless it may turn [rad/s or m/s].
  double velocity(int joint, double t) const;
  bool may_turn(int joint, double t) const;

  // When the joint, and the last one of all, comes to rest.
  double until(int joint) const { return until_[static_cast<std::size_t>(joint)]; }
  double end() const;

  // Stops what must stop when a link touches that these joints move, listed from the base on: all
  // of them, since each would press the link into what it touches. A rigid degree of freedom then
  // cannot move at all: its other joints, which may belong to other fingers, stop too; of one that
  // is coupled by finger those of the same finger. Only a link on a joint that gives way stops
  // nothing but this.
  void stop_before(const std::vector<int>& joints, double t);

  const std::vector<bool>& stopped_by_contact() const { return by_contact_; }

 private:
  void stop(int joint, double t);
  // The joints that stop with this one, itself among them; empty where others go on.
  std::vector<int> fellows(int joint) const;
  void turn_across(int joint, double t);
  // When the joint reaches its limit if it moves at its second velocity from time t on.
  double limit_time(int joint, double t) const;

  const Robot* robot_ = nullptr;
  std::vector<double> start_;
  std::vector<double> first_;   // velocities [rad/s or m/s]
  std::vector<double> second_;  // those after the turn; the same for joints that never turn
  std::vector<double> turn_;    // when each joint turns [s]
  std::vector<double> until_;   // when each joint stops [s]
  std::vector<bool> by_contact_;
};

}  // namespace prehend
