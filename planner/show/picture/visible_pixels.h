// Visibility: how many pixels of each body a camera sees.
#pragma once

#include <vector>

#include "planner/show/picture/camera.h"
#include "planner/show/picture/drawn_body.h"

namespace prehend {

// For each body of `seen`, how many pixels of a picture of `width` x `height` show it, among the
// others and the bodies `around` it. A pixel shows the solid body that is nearest at its center (of
// two at the same depth the first one, those of `seen` before those `around`), and counts as the
// part that is not covered by translucent surfaces before it, whose backs cover half as much.
// Translucent bodies themselves have none. Throws InputError when the camera sees nothing.
std::vector<double> visible_pixels(const std::vector<DrawnBody>& seen,
                                   const std::vector<DrawnBody>& around, const Camera& camera,
                                   int width, int height);

}  // namespace prehend
