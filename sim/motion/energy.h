// The energy of a world.
#pragma once

namespace prehend {

struct World;

// Kinetic and potential energy of all bodies and robots that move, gravity's from the world's
// origin, that of springs in joints, and what gears behind clutches give back; bases of robots
// count as at rest [J].
double energy_of(const World& world);

}  // namespace prehend
