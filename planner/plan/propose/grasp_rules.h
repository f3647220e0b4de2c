// The grasp rules of each primitive, independent of the hand: the target, the direction of approach
// and the direction along which the fingers close, and the choices that a rule leaves open.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/shape/primitive.h"

namespace prehend {

// A way to grasp a primitive, before a hand and a preshape are chosen. Vectors are in the object's
// frame O.
struct AimedGrasp {
  Vector3 target_O = Vector3::Zero();     // point that the hand's grasp origin is to reach [m]
  Vector3 approach_O = Vector3::UnitZ();  // unit: direction in which the hand moves to the object
  Vector3 closing_O = Vector3::UnitX();   // unit, orthogonal to approach_O: direction along which
                                          // the fingers close
};

// A choice that a rule leaves open, a number from 0 to 1.
enum class Freedom {
  place,  // along a line, without its ends: 1/2 is its middle
  span,   // along a line, with its ends
  turn,   // about an axis: 0 and 1 are the same
};

// The values of a freedom at a level of detail (>= 0), evenly spaced; those of a level are among
// those of the next. The first levels are the middle of a line and its quarters; its ends and its
// middle; quarters of a turn.
int choice_count(Freedom freedom, int level);
// Value `i` of a level, 0 <= i < choice_count.
double choice_at(Freedom freedom, int level, int i);
// Whether the value is not one of the level before.
bool is_new_choice(Freedom freedom, int level, int i);

// A rule applied to a primitive.
struct GraspRule {
  std::string name;    // "box faces", "cylinder end", ...
  double width = 0.0;  // size of the primitive along the closing direction [m]
  std::vector<Freedom> freedoms;
  // The grasp for one value of each freedom.
  std::function<AimedGrasp(const std::vector<double>&)> aim;
};

// All rules of a primitive, in a fixed order:
// - box: thumb and fingers on two opposite faces, approach along each of the four other directions,
//   at a place along the third axis;
// - cylinder: from the side, from any direction, with the thumb across the axis (at a place along
//   it) or along it, and onto both ends with any turn of the hand;
// - sphere: from any direction and with any turn of the hand;
// - cone: as a cylinder, from the side on its wider and on its narrower half, and onto both ends;
// - rim: onto the edge, with thumb and fingers on both sides of the wall, at a place along it;
// - bar: from any direction across it, with thumb and fingers across it, at a place along it.
// Where a turn of the hand is not free, each rule comes twice, with the thumb on either side.
// Source: Miller, Knoop, Allen and Christensen 2003, Automatic grasp planning using shape
// primitives.
std::vector<GraspRule> grasp_rules(const Primitive& primitive);

}  // namespace prehend
