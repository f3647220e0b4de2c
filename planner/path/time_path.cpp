#include "planner/path/time_path.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "planner/path/time_corners.h"
#include "planner/path/time_curve.h"
#include "sim/base/input_error.h"

namespace prehend {
namespace {

using Points = std::vector<std::vector<double>>;

// Ratio of a value to its limit up to which the excess counts as rounding. Without it the loop of
// time_path might slow down by a last bit for ever.
constexpr double kInside = 1.0 + 1e-10;

[[noreturn]] void fail(const std::string& what) {
  throw InputError({.field = "joint path", .problem = what});
}

void check_limit(const char* name, double limit, std::size_t joint) {
  if (std::isfinite(limit) && limit > 0.0) return;
  throw InputError({.field = "limits." + std::string(name) + "[" + std::to_string(joint) + "]",
                    .problem = "not positive, but the joint moves",
                    .value = std::to_string(limit)});
}

// Refuses what the timing cannot handle, before any work. Only joints that move need limits: a
// robot may have none (0) for the others.
void check(const Points& waypoints, const JointLimits& limits, const TimePathOptions& options) {
  require(std::isfinite(options.sample_time) && options.sample_time > 0.0,
          {.field = "sample_time",
           .problem = "must be positive and finite",
           .value = std::to_string(options.sample_time)});
  require(!waypoints.empty(), {.field = "waypoints", .problem = "none"});
  const std::vector<double>& first = waypoints.front();
  if (limits.velocity.size() != first.size() || limits.acceleration.size() != first.size()) {
    throw InputError({.field = "limits",
                      .problem = std::to_string(limits.velocity.size()) + " velocities and " +
                                 std::to_string(limits.acceleration.size()) +
                                 " accelerations for " + std::to_string(first.size()) + " joints"});
  }
  std::vector<bool> moves(first.size(), false);
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    const std::string name = "waypoints[" + std::to_string(i) + "]";
    if (waypoints[i].size() != first.size()) {
      throw InputError({.field = name,
                        .problem = "has " + std::to_string(waypoints[i].size()) +
                                   " numbers, the first " + std::to_string(first.size())});
    }
    for (std::size_t j = 0; j < first.size(); ++j) {
      if (!std::isfinite(waypoints[i][j])) {
        throw InputError({.field = name + "[" + std::to_string(j) + "]", .problem = "not finite"});
      }
      if (waypoints[i][j] != first[j]) moves[j] = true;
    }
  }
  for (std::size_t j = 0; j < first.size(); ++j) {
    if (!moves[j]) continue;
    check_limit("velocity", limits.velocity[j], j);
    check_limit("acceleration", limits.acceleration[j], j);
  }
}

// The factor (>= 1) by which the motion must be slowed down for all samples to be inside the
// limits. Stretching time by f divides velocities by f and accelerations by f^2.
double excess(const TimedPath& path, const JointLimits& limits) {
  double factor = 1.0;
  for (std::size_t i = 0; i < path.times.size(); ++i) {
    for (std::size_t j = 0; j < limits.velocity.size(); ++j) {
      const double speed = std::abs(path.velocities[i][j]);
      // Compared as products, so that a joint at rest without limits (0) is not divided by.
      if (speed > factor * limits.velocity[j]) factor = speed / limits.velocity[j];
      if (i == 0) continue;
      const double change = std::abs(path.velocities[i][j] - path.velocities[i - 1][j]);
      // The mean acceleration between two samples is what is limited. Between them it may be higher
      // (time_path.h).
      const double rate = change / (path.times[i] - path.times[i - 1]);
      if (rate > factor * factor * limits.acceleration[j]) {
        factor = std::sqrt(rate / limits.acceleration[j]);
      }
    }
  }
  return factor;
}

}  // namespace

TimedPath time_path(const Points& waypoints, PathKind kind, const JointLimits& limits,
                    const TimePathOptions& options) {
  check(waypoints, limits, options);
  const bool moves = std::any_of(waypoints.begin(), waypoints.end(),
                                 [&](const auto& q) { return q != waypoints.front(); });
  std::optional<CurveRun> run;
  if (moves && kind == PathKind::smooth) run.emplace(waypoints, limits);
  // The speeds found for the continuous path hold at its stations; between the samples there may be
  // a small excess. A slower motion is sampled at other places, so it is checked again; two or
  // three rounds are usual, since only the discretisation has to be corrected.
  double slower = 1.0;
  while (true) {
    TimedPath path = run ? run->sample(slower, options.sample_time)
                         : time_corners(waypoints, limits, slower, options.sample_time);
    const double factor = excess(path, limits);
    if (factor <= kInside) return path;
    slower *= factor;
  }
}

int step_count(double duration, double sample_time) {
  // Far more than any sensible motion, and far less than what overflows an int or the memory.
  constexpr double kMost = 1e7;
  const double steps = std::ceil(duration / sample_time);
  if (!(steps <= kMost)) {
    throw InputError({.field = "joint path",
                      .problem = "too many samples, its limits or sample_time are too small",
                      .value = "takes " + std::to_string(duration) + " s"});
  }
  return std::max(1, static_cast<int>(steps));
}

void append(Trajectory& trajectory, const std::string& segment, const TimedPath& path) {
  // [rad or m] Segments that follow each other share a waypoint. A larger gap is a mistake of the
  // caller: the robot would have to jump.
  constexpr double kSamePlace = 1e-9;
  const std::size_t joints = trajectory.joints.size();
  if (path.positions.empty() || path.positions.front().size() != joints) {
    fail("segment " + segment + " is empty or not of the trajectory's " + std::to_string(joints) +
         " joints");
  }
  const bool first = trajectory.times.empty();
  for (std::size_t j = 0; !first && j < joints; ++j) {
    const double gap = path.positions.front()[j] - trajectory.positions.back()[j];
    if (std::abs(gap) <= kSamePlace) continue;
    fail("segment " + segment + " does not start where the one before ends: joint " +
         trajectory.joints[j] + " is off by " + std::to_string(gap));
  }
  const double start = first ? 0.0 : trajectory.times.back();
  const int begin = first ? 0 : static_cast<int>(trajectory.times.size()) - 1;
  // The first sample of a later segment repeats the last one of the trajectory and is left out.
  // Both are at rest.
  for (std::size_t i = first ? 0 : 1; i < path.times.size(); ++i) {
    trajectory.times.push_back(start + path.times[i]);
    trajectory.positions.push_back(path.positions[i]);
    trajectory.velocities.push_back(path.velocities[i]);
  }
  trajectory.segments.push_back({segment, begin, static_cast<int>(trajectory.times.size()) - 1});
}

}  // namespace prehend
