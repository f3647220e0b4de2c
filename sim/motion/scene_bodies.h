// What a scene says of a world: its bodies, and how they touch.
#pragma once

#include "sim/motion/world.h"

namespace prehend {

struct Scene;

// Friction, static and kinetic, and compliance of a scene.
ContactLaws laws_of(const Scene& scene);

// Adds the scene's object, which moves, and its obstacles, which do not, and takes its laws; the
// hand and what carries it are not added. Throws InputError for an object without a positive mass.
void add_bodies(const Scene& scene, World& world);

}  // namespace prehend
