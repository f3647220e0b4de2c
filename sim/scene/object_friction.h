// Changes of the friction in a scene.
#pragma once

#include "sim/scene/scene.h"

namespace prehend {

// Static friction between two materials. Surfaces that slide have no more than those that stick: a
// larger kinetic coefficient of the pair is forgotten. Throws as checked_friction.
void set_static_friction(Scene& scene, Material a, Material b, double friction);

// The same of the object with every material, whatever its parts and those of links are made of.
void set_object_friction(Scene& scene, double friction);

}  // namespace prehend
