// Objects and robots that are modelled a little too low, so that they reach into what they stand
// on.
#pragma once

#include <optional>
#include <vector>

#include "sim/scene/collision_body.h"
#include "sim/scene/scene.h"

namespace prehend {

// How far `object` has to move along the unit vector `up_O` to be free of the obstacles, which are
// placed in its frame: to 0.01 mm, at least 0.05 mm. Nothing where it is not free within `most`
// [m].
std::optional<double> rise_to_be_free(const CollisionBody& object,
                                      const std::vector<PlacedBody>& obstacles, const Vector3& up_O,
                                      double most);

// Whether a link that nothing moves overlaps `obstacle`, placed in its frame, as what it is screwed
// to: it would be free at most 50 mm higher, along the unit vector `up_L`.
bool stands_in(const CollisionBody& link, const PlacedBody& obstacle, const Vector3& up_L);

// Raises an object that overlaps obstacles and is free of them at most 3 mm higher (world z) to
// 0.1 mm above that, with a note. Others are left as they are.
void raise_sunk_object(Scene& scene);

// Notes which links that nothing moves stand in obstacles: compile_arm does not check these pairs.
void note_standing_base(Scene& scene);

}  // namespace prehend
