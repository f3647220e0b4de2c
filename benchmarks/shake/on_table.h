// Objects without a support, put on a table.
#pragma once

#include "sim/scene/scene.h"

namespace prehend::bench {

// Lets the object down on a plate of wood below it, in the pose in which it is, and leaves it as it
// comes to rest, with 0.1 mm between its lowest point and the plate. The plate becomes the obstacle
// "table". Throws InputError where the object does not come to rest within 10 s, and for a scene
// with an arm, which may reach another pose no more.
void put_on_table(Scene& scene);

}  // namespace prehend::bench
