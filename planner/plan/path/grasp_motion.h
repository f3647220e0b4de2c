// The motion of a hand that approaches a grasp and closes, as frames for pictures and reports.
#pragma once

#include <string>
#include <vector>

#include "sim/base/pose.h"
#include "sim/motion/control/trajectory.h"

namespace prehend {

struct Candidate;
struct CompiledScene;
struct Trial;

// A force on the object, in the frame O.
struct MotionForce {
  Vector3 p_O = Vector3::Zero();
  Vector3 force_O = Vector3::Zero();  // [N]
};

// The hand, and the arm if there is one, at one moment.
struct MotionFrame {
  double time = 0.0;                    // s
  Pose X_OH = Pose::Identity();         // the hand's base in the object's frame
  std::vector<double> joints;           // of the hand [rad or m]
  std::vector<double> arm_joints = {};  // of the whole platform; empty without an arm
  // The object C as the hand carries it, in the frame O in which it stood before.
  Pose X_OC = Pose::Identity();
  std::vector<MotionForce> forces = {};  // of a simulation
};

// Between two frames joint values (and, without an arm, the hand's position) are interpolated
// linearly in time.
struct GraspMotion {
  std::vector<MotionFrame> frames;          // at least one
  std::vector<TrajectorySegment> segments;  // "approach", "close"; with a path also those before
                                            // and after
  // The object and the hand's base move freely, as the frames say. Else the hand keeps its rotation
  // on the way to the object, which stands until it is grasped and is then carried.
  bool is_simulated = false;
  // Index of the frame in which the object is grasped: the end of "close", the last one where there
  // is no such segment. From there on the hand carries the object.
  std::size_t grasp() const;
};

// With `path` (and a scene with an arm): a frame for each of its samples. Otherwise (`path` null)
// the motion of the trial: the hand approaches at 0.1 m/s and then closes at its closing
// velocities, carried by the arm along trial.arm_line where there is one. An arm_line of a single
// posture has no approach: the motion then starts at the grasp.
GraspMotion grasp_motion(const CompiledScene& scene, const Candidate& candidate, const Trial& trial,
                         const Trajectory* path);

// The motion with about `most` (>= 2) of its frames: every n-th one, and always those at the ends
// of segments, which is why there can be a few more.
GraspMotion thinned(const GraspMotion& motion, int most);

}  // namespace prehend
