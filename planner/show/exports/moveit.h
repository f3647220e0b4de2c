// Grasps and paths as messages of MoveIt (docs/reference/exports.md).
#pragma once

#include <string>
#include <vector>

#include "planner/show/exports/export_grasp.h"

namespace prehend {

// The version of ROS whose message fields are written.
enum class RosVersion {
  ros1,  // times have the fields secs and nsecs
  ros2,  // sec and nanosec
};

// The frame that grasp poses are given in.
enum class GraspFrame { object, world };

// What MoveIt messages need besides the grasps.
struct MoveitOptions {
  RosVersion ros = RosVersion::ros2;
  // Frame of grasp poses and of the directions with them: the object's, named like the object, or
  // the world's.
  GraspFrame frame = GraspFrame::object;
  std::string world_frame = "world";
  // How much of the approach and of the retreat must be possible (0..1): min_distance over
  // desired_distance. All of it was found free for the hand alone; an arm may reach less.
  double least_part = 0.5;
  // When the hand has to have reached a posture [s]. Some controllers refuse 0.
  double posture_time = 0.5;
};

// A list with an entry for each segment of the path in which something moves: its name as
// "segment", and as "trajectory" a moveit_msgs/RobotTrajectory of the joints that move in it and of
// those of the same robots, whose time begins at 0. Accelerations are left out: controllers then
// follow the cubics that positions and velocities determine. `names`: what the driver calls the
// joints of the path. Throws InputError when a sample is not of the path's joints or not finite.
std::string moveit_trajectories_yaml(const Trajectory& path, const std::vector<std::string>& names,
                                     const MoveitOptions& options = {});

// A list of moveit_msgs/Grasp, whose poses are those of the link that carries the hand
// (EndEffector::parent), as the message asks. Throws InputError that names the grasp when it has
// another number of joints than the header, or a number is not finite.
std::string moveit_grasps_yaml(const ExportHeader& header, const std::vector<ExportGrasp>& grasps,
                               const MoveitOptions& options = {});

}  // namespace prehend
