// What trials have shown about where an arm can bring the hand.
#pragma once

#include <vector>

#include "sim/base/pose.h"

namespace prehend {

// Remembers hand poses that the arm was asked to reach, and guesses from these about others. For
// one object it is mostly the hand's orientation that decides: whether the arm reaches around it.
class ReachMemory {
 public:
  void add(const Pose& X_OH, bool reached);

  // True when the orientations nearest to this one, if they are near, were all out of reach.
  bool seems_out_of_reach(const Pose& X_OH) const;

 private:
  struct Known {
    Eigen::Quaterniond rotation;
    bool reached;
  };
  std::vector<Known> known_;
};

}  // namespace prehend
