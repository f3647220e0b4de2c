// The grasp rules of each primitive, independent of the hand: the target, the direction of approach
// and the direction along which the fingers close.
#pragma once

#include <string>
#include <vector>

#include "sim/base/settings.h"
#include "sim/geometry/primitive.h"

namespace prehend {

struct GraspRuleOptions {
  // Directions around a cylinder's side and around its ends (>= 1).
  int cylinder_directions = 12;
  // Places along a cylinder's axis and along a box's side, evenly spread (>= 1).
  int places = 3;
  // Directions over a sphere, and turns of the hand about each (>= 1).
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

struct AimedGrasp {
  Vector3 target_O = Vector3::Zero();     // where the hand's origin is aimed, object frame [m]
  Vector3 approach_O = Vector3::UnitZ();  // unit
  Vector3 closing_O = Vector3::UnitX();   // unit, orthogonal to approach
  double width = 0.0;                     // of the primitive along closing [m]
  std::string rule;
};

std::vector<AimedGrasp> aim_at(const Primitive& primitive, const GraspRuleOptions& options);

}  // namespace prehend
