// Which hand poses were proposed before.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "sim/base/pose.h"

namespace prehend {

// Poses with the preshape that they belong to, found again by their place.
class PoseSet {
 public:
  // Two poses are the same when they are no farther apart than both of these [m], [rad].
  PoseSet(double distance, double angle) { refine(distance, angle); }

  // Smaller tolerances from now on, for the poses so far as well.
  void refine(double distance, double angle);

  // Adds the pose, unless the same is there already: then it returns false.
  bool add(const Pose& pose, int preshape);

 private:
  struct Entry {
    Pose pose;
    int preshape;
  };
  using Cell = std::array<std::int64_t, 3>;

  Cell cell_of(const Pose& pose) const;
  bool holds(const Pose& pose, int preshape) const;

  double distance_ = 1.0;
  double angle_ = 0.0;
  std::vector<Entry> entries_;
  std::map<Cell, std::vector<std::size_t>> cells_;  // entries, in cubes of the distance
};

}  // namespace prehend
