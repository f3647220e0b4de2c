// Approach axis, closing axis and grasp origin of a hand from how its fingers meet.
#pragma once

#include <optional>

#include "sim/robot/hand/derive_hand.h"
#include "sim/robot/hand/opposition.h"

namespace prehend {

struct HandAxes {
  Vector3 approach = Vector3::UnitZ();  // as in Hand
  Vector3 closing = Vector3::UnitX();
  Vector3 origin = Vector3::Zero();
};

// Closing axis: from the thumb's tip to the mean of the others' half-way to where they meet, or the
// direction of the thumb's motion where it slides; without the part along the axes about which the
// fingers bend, where these are parallel. Approach: from the middle of the palm to where the tips
// meet, orthogonal to the closing axis and to those axes. Origin: where the line through there
// along the approach leaves the palm. What is stated is kept, and the rest fits it.
HandAxes find_hand_axes(const Robot& robot, const HandParts& parts, const ClosingDofs& closing,
                        const Opposition& best, const StatedHand& stated);

// Other directions in which the palm may face: that in which the tips of the others begin to move
// about their fingers' roots, the palm's thinnest one, and those half-way to the approach that
// find_hand_axes gives. Unit, base frame.
std::vector<Vector3> other_approaches(const Robot& robot, const HandParts& parts,
                                      const ClosingDofs& closing, const Opposition& best,
                                      const Vector3& approach);

// These axes with the closing axis turned about the approach until it is orthogonal to the axes
// about which the others bend, where these are parallel and it is not so already.
std::optional<HandAxes> across_bending(const Robot& robot, const HandParts& parts,
                                       const Opposition& best, const HandAxes& axes);

}  // namespace prehend
