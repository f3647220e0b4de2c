// Choice of a few frames that summarise a motion.
#pragma once

#include <string>
#include <vector>

#include "planner/plan/path/grasp_motion.h"

namespace prehend {

// A frame, and the segment of the motion that it belongs to.
struct NamedFrame {
  MotionFrame frame;
  std::string segment;  // its name; where two segments meet "FIRST > SECOND"
};

// `count` (>= 0) frames of the motion: its end; with more the start; then where segments meet, as
// many as there is room for; and the rest evenly in time inside the segments, one in each first,
// then where the frames are farthest apart. Segments that take no time are left out, and where none
// takes any there are no frames.
std::vector<NamedFrame> named_frames(const GraspMotion& motion, int count);

}  // namespace prehend
