// The mass of an object in scene files: "mass", "density", "center_of_mass" and "parts".
#pragma once

#include "sim/base/json/json_pose.h"
#include "sim/scene/scene.h"

namespace prehend {

// The mass that the object's field states, else kDefaultObjectMass [kg]. Throws InputError unless
// it is positive and at most 1e9 kg.
double whole_mass(const JsonField& object);

// Changes mass, centre of mass and inertia of a body of that mass and uniform density to what the
// object's fields state (docs/reference/scene-file.md). Throws InputError that names the field.
void read_mass(const JsonField& object, GraspableBody& body);

// Adds the fields that read_mass reads. The centre of mass only where it is not that of uniform
// density.
void add_mass(const GraspableBody& body, nlohmann::ordered_json& json);

}  // namespace prehend
