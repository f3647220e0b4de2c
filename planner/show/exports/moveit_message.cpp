#include "planner/show/exports/moveit_message.h"

#include <cmath>

#include "sim/base/input_error.h"
#include "sim/base/pose.h"

namespace prehend {

void MoveitMessage::time(long long seconds, long long nanoseconds) {
  const bool ros1 = ros_ == RosVersion::ros1;
  yaml_ << YAML::Flow << YAML::BeginMap;
  yaml_ << YAML::Key << (ros1 ? "secs" : "sec") << YAML::Value << seconds;
  yaml_ << YAML::Key << (ros1 ? "nsecs" : "nanosec") << YAML::Value << nanoseconds;
  yaml_ << YAML::EndMap;
}

void MoveitMessage::header(const std::string& frame) {
  yaml_ << YAML::Key << "header" << YAML::Value << YAML::BeginMap;
  yaml_ << YAML::Key << "stamp" << YAML::Value;
  // A stamp of 0 stands for no particular time.
  time(0, 0);
  yaml_ << YAML::Key << "frame_id" << YAML::Value;
  put_text(yaml_, frame);
  yaml_ << YAML::EndMap;
}

void MoveitMessage::duration(double seconds) {
  constexpr double kMost = 2147483647.0;  // sec is an int32
  require(seconds >= 0.0 && seconds < kMost,
          {.problem = "export: not a duration", .value = std::to_string(seconds) + " s"});
  constexpr long long kNanoseconds = 1000000000;
  const auto whole = static_cast<long long>(seconds);
  // Rounding may give a whole second (0.9999999996 s), which must be carried: nanoseconds are below
  // 10^9.
  const long long rest = std::llround((seconds - static_cast<double>(whole)) * 1e9);
  time(whole + rest / kNanoseconds, rest % kNanoseconds);
}

void MoveitMessage::point(double time, const std::vector<double>& positions,
                          const std::vector<double>& velocities) {
  yaml_ << YAML::BeginMap;
  yaml_ << YAML::Key << "positions" << YAML::Value;
  put_numbers(yaml_, positions);
  yaml_ << YAML::Key << "velocities" << YAML::Value;
  put_numbers(yaml_, velocities);
  yaml_ << YAML::Key << "accelerations" << YAML::Value;
  // Without accelerations controllers interpolate with cubics between positions and velocities,
  // which is the planned motion (Trajectory).
  put_numbers(yaml_, {});
  yaml_ << YAML::Key << "effort" << YAML::Value;
  put_numbers(yaml_, {});
  yaml_ << YAML::Key << "time_from_start" << YAML::Value;
  duration(time);
  yaml_ << YAML::EndMap;
}

void MoveitMessage::pose(const Pose& pose) {
  const Eigen::Quaterniond q = quaternion_of(pose).normalized();
  yaml_ << YAML::BeginMap << YAML::Key << "position" << YAML::Value;
  put_vector(yaml_, pose.translation());
  yaml_ << YAML::Key << "orientation" << YAML::Value << YAML::Flow << YAML::BeginMap;
  // ROS has w last and names all four.
  yaml_ << YAML::Key << "x" << YAML::Value;
  put_number(yaml_, q.x());
  yaml_ << YAML::Key << "y" << YAML::Value;
  put_number(yaml_, q.y());
  yaml_ << YAML::Key << "z" << YAML::Value;
  put_number(yaml_, q.z());
  yaml_ << YAML::Key << "w" << YAML::Value;
  put_number(yaml_, q.w());
  yaml_ << YAML::EndMap << YAML::EndMap;
}

}  // namespace prehend
