// Bodies as a binary glTF 2.0 file (.glb), which 3D programs and browsers open.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "planner/show/picture/draw.h"
#include "planner/show/picture/drawn_body.h"

namespace prehend {

// One root node called `name`, with `extras` (an object) for whoever looks them up, turns the world
// (z up) to glTF's axes (y up); below it is a node a body, with its name and pose, in their order.
// Metres. Both sides of a surface show. A mesh that several bodies share is stored once. Faces that
// meet at less than `crease_angle` (radians) are shaded as one round surface. Bodies without a
// triangle that has area are left out. Names may hold any bytes: what is not UTF-8 is replaced by
// U+FFFD. Same input, same bytes.
// Throws InputError for poses that are not finite, meshes that vertex_arrays refuses, and more than
// the 4 GiB that the format can hold.
std::string glb_bytes(const std::vector<DrawnBody>& bodies, const std::string& name,
                      const nlohmann::ordered_json& extras,
                      double crease_angle = DrawOptions().crease_angle);

}  // namespace prehend
