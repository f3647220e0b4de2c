// A motion of named joints in time.
#pragma once

#include <string>
#include <vector>

namespace prehend {

// A named stretch: samples first .. last, both included. It starts at the sample where the one
// before ends, so that neighbours share a sample.
struct TrajectorySegment {
  std::string name;
  int first = 0;
  int last = 0;
};

// Between two samples the motion is the cubic that their positions and velocities determine.
struct Trajectory {
  std::vector<std::string> joints;
  std::vector<double> times;                   // s, from 0, increasing
  std::vector<std::vector<double>> positions;  // one row a sample, one number a joint [rad or m]
  std::vector<std::vector<double>> velocities;
  std::vector<TrajectorySegment> segments;  // "transfer", "approach", "close"
};

}  // namespace prehend
