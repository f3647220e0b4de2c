// The numbers that bodies and robots have in the text protocol of GraspIt!.
#pragma once

#include <string>
#include <vector>

#include "sim/motion/world.h"
#include "sim/scene/scene.h"

namespace prehend {

// A number's body. Numbers that no body has are of the name "none".
struct NumberedBody {
  std::string name;
  SolidId solid = {-1, -1};  // in the world of MovingWorld; of "none" as here
};

// Numbers 0 and up: the object, the obstacles as in the scene, and from 3 on, or the first that is
// free then, the links of the hand: those of its base, then of its chains one after the other. Each
// chain takes as many numbers as the longest one has links, and ends with its last link. So the
// distal links of the Barrett hand are 6, 9 and 12, as in the programs for GraspIt!'s.
std::vector<NumberedBody> graspit_bodies(const Scene& scene);

}  // namespace prehend
