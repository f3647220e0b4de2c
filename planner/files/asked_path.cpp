#include "planner/files/asked_path.h"

#include <cstddef>

#include "planner/files/asked_grasps.h"

namespace prehend {
namespace {

std::vector<std::string> read_joints(const JsonField& field, const Robot& robot) {
  const std::vector<JsonField> items = field.items();
  std::vector<std::string> names;
  for (const JsonField& item : items) {
    const std::size_t j = names.size();
    if (j == robot.joints.size()) break;
    if (item.text() != robot.joints[j].name) {
      item.fail("this joint of " + robot.name + " is " + robot.joints[j].name);
    }
    names.push_back(item.text());
  }
  if (items.size() != robot.joints.size()) {
    field.fail(robot.name + " has " + std::to_string(robot.joints.size()) + " joints, here are " +
               std::to_string(items.size()));
  }
  return names;
}

std::vector<double> read_times(const JsonField& field) {
  std::vector<double> times;
  for (const JsonField& item : field.items()) {
    const double time = item.number();
    if (!times.empty() && !(time > times.back())) item.fail("times must increase");
    times.push_back(time);
  }
  if (times.empty()) field.fail("must not be empty");
  return times;
}

// A row a sample, a number a joint.
std::vector<std::vector<double>> read_rows(const JsonField& field, std::size_t samples,
                                           std::size_t joints) {
  const std::vector<JsonField> items = field.items();
  if (items.size() != samples) {
    field.fail("must be as many rows as there are times: " + std::to_string(samples) + ", not " +
               std::to_string(items.size()));
  }
  std::vector<std::vector<double>> rows;
  for (const JsonField& item : items) rows.push_back(item.numbers(joints));
  return rows;
}

void check_limits(const JsonField& field, const std::vector<std::vector<double>>& rows,
                  const Robot& robot) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows[i].size(); ++j) {
      const Joint& joint = robot.joints[j];
      const double value = rows[i][j];
      if (value >= joint.lower - kLimitTolerance && value <= joint.upper + kLimitTolerance) {
        continue;
      }
      field.items()[i].items()[j].fail(joint.name + " is outside its limits");
    }
  }
}

std::vector<TrajectorySegment> read_segments(const JsonField& field, std::size_t samples) {
  const int end = static_cast<int>(samples) - 1;
  std::vector<TrajectorySegment> segments;
  for (const JsonField& item : field.items()) {
    const TrajectorySegment segment{item["name"].text(), item["first"].integer(),
                                    item["last"].integer()};
    const int expected = segments.empty() ? 0 : segments.back().last;
    if (segment.first != expected) {
      item["first"].fail("must be " + std::to_string(expected) + ", where the one before ends");
    }
    if (segment.last < segment.first || segment.last > end) {
      item["last"].fail("must be from " + std::to_string(segment.first) + " to " +
                        std::to_string(end));
    }
    segments.push_back(segment);
  }
  if (segments.empty() || segments.back().last != end) {
    field.fail("must go on to the last sample: " + std::to_string(end));
  }
  return segments;
}

}  // namespace

Trajectory asked_path(const JsonField& path, const Robot& robot) {
  Trajectory read;
  read.joints = read_joints(path["joints"], robot);
  read.times = read_times(path["times"]);
  read.positions = read_rows(path["positions"], read.times.size(), read.joints.size());
  check_limits(path["positions"], read.positions, robot);
  read.velocities = read_rows(path["velocities"], read.times.size(), read.joints.size());
  read.segments = read_segments(path["segments"], read.times.size());
  return read;
}

}  // namespace prehend
