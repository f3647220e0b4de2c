// A motion of named joints in time.
#pragma once

#include <string>
#include <vector>

namespace prehend {

// A named part of a trajectory: samples first .. last, both included. It starts at the sample where
// the segment before it ends, so that neighbouring segments share a sample.
struct TrajectorySegment {
  std::string name;
  int first = 0;
  int last = 0;
};

// A timed motion of joints, as samples of position and velocity. Between two samples each joint
// moves on the cubic Hermite polynomial that their positions and velocities determine.
struct Trajectory {
  std::vector<std::string> joints;             // names, in the order of the numbers in each row
  std::vector<double> times;                   // s, from 0, increasing
  std::vector<std::vector<double>> positions;  // one row a sample, one number a joint [rad or m]
  std::vector<std::vector<double>> velocities;
  std::vector<TrajectorySegment> segments;  // "preshape", "transfer", "approach", ...
};

}  // namespace prehend
