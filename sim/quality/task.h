// What a grasp is for: the disturbances it has to resist, and how much of them it can.
#pragma once

#include <cstddef>
#include <span>
#include <variant>
#include <vector>

#include "sim/quality/contact.h"
#include "sim/quality/interval.h"
#include "sim/quality/wrench_space.h"

namespace prehend {

// Wrenches in the frame of the grasp, [force; torque * scale], relative to a unit of normal force.

// A finite set of wrenches; resisting all of them means resisting their convex hull, too.
struct TaskWrenches {
  std::vector<Wrench> wrenches;
};

// The ellipsoid {axes * u : |u| <= 1} of wrenches; the columns of `axes` must be independent.
struct TaskEllipsoid {
  Eigen::Matrix<double, 6, 6> axes = Eigen::Matrix<double, 6, 6>::Identity();
};

// The weight of an object whose centre of mass is the torque origin, in units of the normal force.
struct TaskGravity {
  Eigen::Vector3d direction = -Eigen::Vector3d::UnitZ();  // of the pull, any length above 0
  double weight = 1.0;                                    // > 0
};

using Task = std::variant<TaskWrenches, TaskEllipsoid, TaskGravity>;

// The largest k such that contacts with at most unit force (of the space's norm) resist k times
// every wrench of the task; 0 where some wrench of it cannot be resisted at all.
// Source: Borst, Fischer and Hirzinger, ICRA 2004 (task wrench space); Pollard 1994.
// Throws InputError for an empty task or one of zero wrenches only, wrenches and axes that are not
// finite, too short (kSmallestTask) or dependent, a weight or direction outside its range
// (ranges.h); and as wrench_space.
Interval task_resistance(std::span<const Contact> contacts, const WrenchFrame& frame,
                         const Task& task, const WrenchSpaceOptions& space = {});

// The most corners of all pyramids of a surface: for each there is a program to be solved.
inline constexpr std::size_t kMostPushes = 50000;

// The task of a disturbing unit force anywhere on the object: `surface` are contacts spread over
// it, whose cones (space.edges) push. Source: Pollard 1994 (object wrench space). Throws also where
// these have more corners in all than kMostPushes.
Interval object_wrench_ratio(std::span<const Contact> contacts, const WrenchFrame& frame,
                             std::span<const Contact> surface,
                             const WrenchSpaceOptions& space = {});

}  // namespace prehend
