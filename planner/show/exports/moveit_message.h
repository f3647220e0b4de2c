// ROS messages as YAML.
#pragma once

#include <string>
#include <vector>

#include "planner/show/exports/moveit.h"
#include "planner/show/exports/yaml_text.h"

namespace prehend {

// Writes messages into an emitter, with the names of one version of ROS.
class MoveitMessage {
 public:
  MoveitMessage(YAML::Emitter& yaml, RosVersion ros) : yaml_(yaml), ros_(ros) {}

  // std_msgs/Header without a time stamp, as the value of the key "header".
  void header(const std::string& frame);

  // builtin_interfaces/Duration, rounded to a nanosecond [s, >= 0].
  void duration(double seconds);

  // trajectory_msgs/JointTrajectoryPoint. `velocities` may be empty.
  void point(double time, const std::vector<double>& positions,
             const std::vector<double>& velocities);

  // geometry_msgs/Pose.
  void pose(const Pose& pose);

 private:
  void time(long long seconds, long long nanoseconds);

  YAML::Emitter& yaml_;
  RosVersion ros_;
};

}  // namespace prehend
