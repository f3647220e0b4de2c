// Finds the hand in a tree of links that also has the arm, and parts the two.
#pragma once

#include <optional>
#include <vector>

#include "sim/robot/files/joint_tree.h"
#include "sim/robot/platform.h"

namespace prehend {

// An arm has at least so many joints in a row; fewer count as the hand's own (a wrist).
inline constexpr int kFewestArmJoints = 3;

// The last link on whose path from the root all of these links hang (it may be one of them).
int carrier_of_all(const JointTree& tree, const std::vector<int>& links);

// The link with which the hand begins where fingers hang on an arm: from the root, joints follow
// each other without a branch, at least kFewestArmJoints of them, and then several joints hang on
// one rigid piece: the hand begins with the last link that carries them all. Nothing where there
// is no such place: the file is of an arm alone or of a hand alone.
std::optional<int> inferred_hand(const JointTree& tree);

// Whether the links can be parted there: something moves beyond `hand` and before it, no joint
// mimics one of the other part, and nothing else hangs on the joint that carries the hand.
bool can_be_parted(const JointTree& tree, int hand);

// A platform of two robots, "arm" and "hand": `hand` and what it carries, mounted on the rest at
// the end of a chain. The notes of the tree become those of the hand. can_be_parted must hold.
Platform parted(const JointTree& tree, int hand);

}  // namespace prehend
