// Which parts of a robot are fingers, and which are the palm that carries them.
#pragma once

#include <vector>

#include "sim/robot/robot.h"

namespace prehend {

// A branch of the tree beyond the palm, up to the tip that reaches farthest.
struct Finger {
  std::vector<int> joints;        // from the palm to the tip
  std::vector<int> links;         // all that the first of these joints moves
  int tip_link = -1;              // the last link on the way to the tip
  std::vector<int> tip_links;     // all links on the joint of tip_link (a finger and its pad)
  Vector3 tip = Vector3::Zero();  // a point in the middle of tip_link's far end, in its frame [m]
};

struct HandParts {
  // The joint that carries all fingers (a wrist), -1: the base.
  int palm_joint = -1;
  std::vector<int> palm_links;  // those of that joint and of the joints before it
  std::vector<Finger> fingers;  // in the order of the joints
};

// The fingers are what branches from the first place of the tree, seen from the base, at which
// several branches with links begin. A branch without degrees of freedom of its own is no finger
// but a lever of a four-bar finger if it reaches less than 60 % as far as another one, or stays in
// touch with one that has more joints; so is one that passes another one's joints
// (Joint::across). Where nothing branches, a chain of at most two joints is one finger that closes
// onto the base; a longer one is an arm, and there are no fingers.
HandParts find_hand_parts(const Robot& robot);

// The middle of the surface of these links, with all degrees of freedom at their initial values, in
// the base frame [m].
Vector3 middle_of(const Robot& robot, const std::vector<int>& links);

}  // namespace prehend
