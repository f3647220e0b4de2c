// Friction and depths of surfaces in scene files (docs/reference/scene-file.md).
#pragma once

#include "sim/scene/scene.h"

namespace prehend {

class JsonField;  // sim/base/json/json_field.h

// A list of pairs of materials: what an entry says of a pair replaces what earlier ones did. Throws
// InputError that names the field, as the others here.
void read_friction(const JsonField& list, Scene& scene);

// The field "friction" of the object to grasp, of the root's "object" or "objects", with whatever
// touches it.
void read_object_friction(const JsonField& root, Scene& scene);

// {MATERIAL: depth [m]}.
void read_compliant_depths(const JsonField& object, CompliantDepths& depths);

}  // namespace prehend
