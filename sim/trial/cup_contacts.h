// The contacts of a hand with suction cups.
#pragma once

#include <vector>

#include "sim/shape/contact/cup_seal.h"
#include "sim/trial/trial.h"

namespace prehend {

struct CompiledScene;

// How each cup of the hand lies on the object, in the order of Hand::cups, with the hand's base at
// X_OH. The object is at rest, the cups are relaxed.
std::vector<CupSeal> cup_seals(const CompiledScene& scene, const Pose& X_OH);

// A contact (ContactModel::suction) of each cup that seals once the hand has moved on along its
// approach until the whole lip touches: the contact's gap is that way, which is at most the travel
// of the cup and leaves all other links apart from object and obstacles. Its position is the centre
// of the lip, its normal the axis of the cup, its friction that of the cup's link.
std::vector<GraspContact> cup_contacts(const CompiledScene& scene, const Pose& X_OH,
                                       const std::vector<double>& joints);

}  // namespace prehend
