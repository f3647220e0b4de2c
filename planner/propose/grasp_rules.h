// The grasp rules of each primitive, independent of the hand: the target, the direction of approach
// and the direction along which the fingers close.
#pragma once

#include <string>
#include <vector>

#include "sim/base/settings.h"
#include "sim/geometry/primitive.h"

namespace prehend {

// How densely the rules sample the continuous choices that a primitive leaves.
struct GraspRuleOptions {
  // Approach directions around a cylinder's side, and turns of the hand about its axis for
  // approaches onto its ends (>= 1).
  int cylinder_directions = 12;
  // Target points along a cylinder's axis and along a box's side, evenly spaced (>= 1).
  int places = 3;
  // Approach directions over a sphere, and turns of the hand about each of them (>= 1).
  int sphere_directions = 20;
  int sphere_turns = 4;
};

template <SettingsOf<GraspRuleOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [cylinder_directions, places, sphere_directions, sphere_turns] = options;
  visit("cylinder_directions", cylinder_directions);
  visit("places", places);
  visit("sphere_directions", sphere_directions);
  visit("sphere_turns", sphere_turns);
}

// A way to grasp a primitive, before a hand and a preshape are chosen. Vectors are in the object's
// frame O.
struct AimedGrasp {
  Vector3 target_O = Vector3::Zero();     // point that the hand's grasp origin is to reach [m]
  Vector3 approach_O = Vector3::UnitZ();  // unit: direction in which the hand moves to the object
  Vector3 closing_O = Vector3::UnitX();   // unit, orthogonal to approach_O: direction along which
                                          // the fingers close
  double width = 0.0;                     // size of the primitive along closing_O [m]
  std::string rule;                       // name of the rule: "box faces", "cylinder end", ...
};

// All grasps that the rules give for a primitive, in a fixed order; each comes twice, with
// closing_O in both directions (the thumb on either side). Source: Miller, Knoop, Allen and
// Christensen 2003, Automatic grasp planning using shape primitives.
std::vector<AimedGrasp> aim_at(const Primitive& primitive, const GraspRuleOptions& options);

}  // namespace prehend
