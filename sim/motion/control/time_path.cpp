#include "sim/motion/control/time_path.h"

#include <algorithm>
#include <cmath>

#include "sim/base/input_error.h"
#include "sim/base/require_settings.h"
#include "sim/motion/control/time_corners.h"
#include "sim/motion/control/time_curve.h"

namespace prehend {
namespace {

using Points = std::vector<std::vector<double>>;

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
  require_settings(options);
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

// Adds a path that starts where the other ends.
void join(TimedPath& path, const TimedPath& next) {
  const double start = path.times.back();
  for (std::size_t i = 1; i < next.times.size(); ++i) {
    path.times.push_back(start + next.times[i]);
    path.positions.push_back(next.positions[i]);
    path.velocities.push_back(next.velocities[i]);
  }
}

}  // namespace

TimedPath time_path(const Points& waypoints, PathKind kind, const JointLimits& limits,
                    const TimePathOptions& options) {
  check(waypoints, limits, options);
  const bool moves = std::any_of(waypoints.begin(), waypoints.end(),
                                 [&](const auto& q) { return q != waypoints.front(); });
  if (!moves || kind == PathKind::corners) {
    return time_corners(waypoints, limits, options.sample_time);
  }
  return time_curve(curve_through(waypoints, limits), limits, options.sample_time);
}

TimedPath time_blended(const Points& waypoints, const std::vector<double>& blends,
                       const JointLimits& limits, const TimePathOptions& options) {
  check(waypoints, limits, options);
  require(blends.size() + 2 == std::max<std::size_t>(waypoints.size(), 2),
          {.field = "blends",
           .problem = "must be one for each waypoint but the first and the last",
           .value = std::to_string(blends.size())});
  for (const double blend : blends) {
    require(blend >= 0.0 && blend <= 1.0,
            {.field = "blends", .problem = "must be from 0 to 1", .value = std::to_string(blend)});
  }
  // A waypoint that repeats the one before is left out: no line leads to it. The motion stops at
  // the pair if it is to stop at one of them.
  Points points{waypoints.front()};
  std::vector<double> at{0.0};  // the blend at each point, 0 at both ends
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    const double blend = i + 1 < waypoints.size() ? blends[i - 1] : 0.0;
    if (waypoints[i] == points.back()) {
      at.back() = std::min(at.back(), blend);
      continue;
    }
    points.push_back(waypoints[i]);
    at.push_back(blend);
  }
  TimedPath path = time_corners({points.front()}, limits, options.sample_time);
  std::size_t from = 0;
  for (std::size_t to = 1; to < points.size(); ++to) {
    if (at[to] > 0.0) continue;
    const auto nth = [](std::size_t i) { return static_cast<std::ptrdiff_t>(i); };
    const Points run(points.begin() + nth(from), points.begin() + nth(to + 1));
    const std::vector<double> rounded(at.begin() + nth(from + 1), at.begin() + nth(to));
    join(path, rounded.empty()
                   ? time_corners(run, limits, options.sample_time)
                   : time_curve(blended_curve(run, rounded, limits), limits, options.sample_time));
    from = to;
  }
  return path;
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
  // A short motion is still described by as many samples.
  constexpr int kFewest = 16;
  return std::max(kFewest, static_cast<int>(steps));
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
