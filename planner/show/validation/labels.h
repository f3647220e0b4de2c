// What became of executed grasps, and what they have in common.
#pragma once

namespace prehend {

// The outcome of executions of one grasp.
struct Label {
  bool lifted = false;
  int times = 1;    // how many executions ended so (>= 1)
  int object = 0;   // >= 0: those of one object have the same number
  int session = 0;  // >= 0: as above, those of one session
};

}  // namespace prehend
