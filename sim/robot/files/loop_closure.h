// Closed loops of linkages: joints that follow a drive because a point of one link stays on a point
// of another.
#pragma once

#include <set>
#include <vector>

#include "sim/robot/files/joint_tree.h"

namespace prehend {

// A point of link `a` that coincides with one of link `b`, each in its link's frame [m].
struct Loop {
  int a = -1;
  int b = -1;
  Vector3 p_A = Vector3::Zero();
  Vector3 p_B = Vector3::Zero();
};

// The pose of a link in the frame of the tree's root link, for one value per joint [rad or m].
Pose link_in_root(const JointTree& tree, int link, const std::vector<double>& values);

// Makes the joints of each loop followers of the one among them that is `driven` (or mimics another
// one; else the first). The loop is solved in position over the range of the drive; where that
// leaves a freedom, springs of joints pull them to where they rest, within their limits, and what
// has no spring stays put. A follower becomes a mimic, by the straight line that fits best (the
// note says by how much it misses), or a fixed joint where it hardly moves. Where only a spring
// holds a freedom of the loop, the joint that the drive does not carry gives way when it is stopped
// (Joint::across), again by the best straight line. A loop that cannot be closed is left out,
// noted.
void close_loops(const std::vector<Loop>& loops, const std::set<int>& driven, JointTree& tree);

}  // namespace prehend
