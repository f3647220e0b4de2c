// The field "stands_on" of a scene file: what a body is put down on.
#pragma once

#include "sim/scene/scene.h"

namespace prehend {

class JsonField;  // sim/base/json/json_field.h

// Lowers the object, the other objects and the base of the robot onto the obstacles that they name
// (lowered_onto), all of which `scene` has already. Throws InputError for a name that no obstacle
// has, and for a body that would fall past it.
void put_down_all(const JsonField& root, Scene& scene);

}  // namespace prehend
