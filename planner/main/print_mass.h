// The mass of an object on stdout: where it is, and what says so.
#pragma once

#include "sim/scene/scene.h"

namespace prehend {

// The components of a mesh that has several, which parts may name. Then, unless the mass is taken
// as uniform: mass, centre of mass, and each part with its share.
void print_mass(const GraspableBody& object);

}  // namespace prehend
