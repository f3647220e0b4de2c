// How much of each body a camera sees.
#pragma once

#include <vector>

#include "planner/picture/draw.h"

namespace prehend {

// Of each body, in their order, how many pixels of a picture of `width` x `height` show it. A pixel
// shows the solid body that is nearest at its center, of two at the same depth the first one, and
// counts as the part that is not covered by the surfaces of translucent bodies before it, whose
// backs count half. Translucent bodies have none. Throws InputError when the camera sees nothing.
std::vector<double> visible_pixels(const std::vector<DrawnBody>& bodies, const Camera& camera,
                                   int width, int height);

}  // namespace prehend
