#include "planner/results/json_trajectory.h"

#include <cstddef>

#include "planner/results/json_posture.h"

namespace prehend {
namespace {

// The order of the joints is part of the motion: rows are numbers without names.
void check_joints(const JsonField& field, const std::vector<std::string>& joints,
                  const Robot& robot) {
  for (std::size_t j = 0; j < joints.size() && j < robot.joints.size(); ++j) {
    if (joints[j] == robot.joints[j].name) continue;
    field.items()[j].fail("this joint of " + robot.name + " is " + robot.joints[j].name);
  }
  if (joints.size() != robot.joints.size()) {
    field.fail(robot.name + " has " + std::to_string(robot.joints.size()) + " joints, here are " +
               std::to_string(joints.size()));
  }
}

void check_times(const JsonField& field, const std::vector<double>& times) {
  if (times.empty()) field.fail("must not be empty");
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (!(times[i] > times[i - 1])) field.items()[i].fail("times must increase");
  }
}

// One row for each sample, one number for each joint.
void check_rows(const JsonField& field, std::size_t samples, std::size_t joints) {
  const std::vector<JsonField> rows = field.items();
  if (rows.size() != samples) {
    field.fail("must be as many rows as there are times: " + std::to_string(samples) + ", not " +
               std::to_string(rows.size()));
  }
  for (const JsonField& row : rows) (void)row.numbers(joints);
}

// Segments share the sample at which they meet, begin at the first sample and end at the last.
void check_segments(const JsonField& field, const std::vector<TrajectorySegment>& segments,
                    std::size_t samples) {
  const int end = static_cast<int>(samples) - 1;
  int expected = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const TrajectorySegment& segment = segments[i];
    if (segment.first != expected) {
      field.items()[i]["first"].fail("must be " + std::to_string(expected) +
                                     ", where the one before ends");
    }
    if (segment.last < segment.first || segment.last > end) {
      field.items()[i]["last"].fail("must be from " + std::to_string(segment.first) + " to " +
                                    std::to_string(end));
    }
    expected = segment.last;
  }
  if (segments.empty() || expected != end) {
    field.fail("must go on to the last sample: " + std::to_string(end));
  }
}

}  // namespace

Trajectory read_trajectory(const JsonField& field, const Robot& robot) {
  Trajectory read;
  FieldReader fields(field);
  trajectory_fields(fields, read);
  fields.finish();
  check_joints(field["joints"], read.joints, robot);
  check_times(field["times"], read.times);
  check_rows(field["positions"], read.times.size(), read.joints.size());
  for (const JsonField& row : field["positions"].items()) check_joint_limits(row, robot);
  check_rows(field["velocities"], read.times.size(), read.joints.size());
  check_segments(field["segments"], read.segments, read.times.size());
  return read;
}

}  // namespace prehend
