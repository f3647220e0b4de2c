// The motion of the joints of a hand that closes.
#pragma once

#include <algorithm>
#include <vector>

#include "sim/base/index.h"
#include "sim/robot/joint_course.h"
#include "sim/robot/robot.h"
#include "sim/scene/compiled_link.h"

namespace prehend {

class ConvexPoints;  // sim/shape/separation.h

// How far points move along one direction within the next `t` seconds: at most by steady * t, and
// at most by now * t + growth * t^2 / 2 [m].
struct TravelBound {
  double steady = 0.0;  // m/s
  double now = 0.0;     // m/s
  double growth = 0.0;  // m/s^2

  TravelBound& operator+=(const TravelBound& other);
  // The time within which they move by less than `distance`, > 0 [s].
  double time_for(double distance) const;
};

// Where a link is while the hand closes, in the frame of the hand's base.
struct ClosingLink {
  Pose X_HL = Pose::Identity();
  std::vector<Vector3> on_axis_H;  // for each of CompiledLink::joints, a point of its axis
};

// Where the links of a closing hand are over the closing time t [s], and bounds of their speeds.
class ClosingMotion {
 public:
  // To be called before anything else; keeps the memory that it has. `dofs` and `joints`: as in
  // ClosingStart. The hand must outlive the motion.
  void start(const Robot& hand, const std::vector<double>& dofs, const std::vector<double>& joints);

  // Bound on the speed of any point of the link relative to the palm from time t on [m/s]: the sum
  // over the moving joints before it of |velocity| * (farthest point from the joint's axis).
  double speed(const CompiledLink& link, double t) const;

  // Bound on the motion of `part` of the link along the unit `direction_H` (frame of the hand's
  // base) from time t on, at which the link is `placed`.
  TravelBound travel_along(const CompiledLink& link, const ConvexPoints& part,
                           const ClosingLink& placed, const Vector3& direction_H, double t) const;

  // Bound on how far any point of the link can move at all [m]. A self-centering finger may pass
  // its limit by as much as the other one was stopped short of it, which is at most its whole way.
  double farthest(const CompiledLink& link) const;

  // Stops what must stop when the link touches (JointCourse).
  void stop_before(const CompiledLink& link, double t) { course_.stop_before(link.joints, t); }

  // When the last joint comes to rest.
  double end() const { return course_.end(); }

  // The link at time t; `placed` keeps its memory. Joints that have not moved since they were
  // placed last are remembered.
  void place(const CompiledLink& link, double t, ClosingLink& placed);

  // Joint values at time t; after end() those at rest, for any t up to infinity.
  void joints_at(double t, std::vector<double>& joints) const;

  // Adds to the value of each degree of freedom at the start what it changes until the end: as much
  // as its joint that moved longest, because the drive moves on as long as any of its joints does
  // (breakaway).
  void move_to_end(std::vector<double>& dofs) const;

  const std::vector<bool>& stopped_by_contact() const { return course_.stopped_by_contact(); }

 private:
  // The frame A behind a joint in the frame P before it, at some value of the joint.
  struct PlacedJoint {
    double value = 0.0;
    Pose X_PA = Pose::Identity();
  };

  const Pose& placed(std::size_t joint, double t);
  void find_axes();

  const Robot* hand_ = nullptr;
  JointCourse course_;
  std::vector<DofCourse> closing_;
  std::vector<PlacedJoint> placed_;
  std::vector<Pose> X_HJ_;        // at the start
  std::vector<Vector3> axis_H_;   // of each joint, at the start
  std::vector<bool> keeps_axis_;  // whether the joint's axis keeps that direction
};

}  // namespace prehend
